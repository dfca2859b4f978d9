// Every sample model under both sample environments with every method: pictures that are finite,
// show the model and survive the way to a file and back.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include "burnish/image_io.hpp"
#include "burnish/renderer.hpp"
#include "pictures.hpp"
#include "support/test_folder.hpp"

namespace burnish::test {
namespace {

namespace fs = std::filesystem;

// One file of each folder of data/models.
std::vector<fs::path> models() {
    std::vector<fs::path> found;
    for (const auto& folder : fs::directory_iterator(sample("models"))) {
        for (const char* kind : {"glTF-Binary", "glTF"}) {
            const fs::path place = folder.path() / kind;
            if (!fs::is_directory(place)) continue;
            const auto is_model = [](const auto& entry) {
                return entry.path().extension() == ".glb" || entry.path().extension() == ".gltf";
            };
            const auto file = std::find_if(fs::directory_iterator(place), {}, is_model);
            if (file == fs::directory_iterator()) continue;
            found.push_back(file->path());
            break;
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

// What is wrong with a picture of a model before nothing, "" when nothing is.
std::string trouble_of(const Image& picture) {
    double covered = 0;
    float brightest = 0;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const float* p = picture.at(x, y);
            for (int c = 0; c < 4; ++c) {
                if (!std::isfinite(p[c]) || p[c] < 0.0f)
                    return fmt::format("{} in channel {} at {}, {}", p[c], c, x, y);
            }
            covered += p[3];
            brightest = std::max({brightest, p[0], p[1], p[2]});
        }
    }
    if (covered < 0.05 * picture.width * picture.height) return "the model is hardly there";
    if (brightest < 0.01f) return "it is black";
    return {};
}

void expect_finite(const std::vector<fs::path>& files, const std::string& environment,
                   const Settings& surface) {
    const fs::path light = sample(environment);
    ASSERT_FALSE(light.empty()) << environment << " is missing";
    const ScratchFolder folder;
    Settings settings = {{"width", "160"},
                         {"height", "120"},
                         {"samples", "2"},
                         {"image_light_samples", "4"},
                         {"background", "transparent"}};
    settings.insert(settings.end(), surface.begin(), surface.end());
    for (const fs::path& model : files) {
        Stage stage = stage_of(model.string(), light.string(), {"-45,45,2"}, settings);
        gpu::Renderer renderer(*gl_context(), stage.scene, &stage.environment);
        for (std::size_t i = 0; i < method_names().size(); ++i) {
            for (Material& material : stage.scene.materials)
                material.method = static_cast<Method>(i);
            renderer.set_materials(stage.scene.materials);
            const fs::path file = folder / "picture.exr";
            write_image(file, renderer.render(stage.camera, stage.settings), {});
            const Image picture = read_image(file, {.finite_only = false});
            EXPECT_EQ(trouble_of(picture), "") << model.filename() << ", " << method_names()[i];
        }
    }
}

class EveryModel : public testing::Test {
  protected:
    void SetUp() override {
        BURNISH_REQUIRE_GL();
        const fs::path folder = sample("models");
        BURNISH_REQUIRE_SAMPLE(folder);
        models_ = models();
        ASSERT_GE(models_.size(), 6u) << "models are missing from " << folder;
    }

    std::vector<fs::path> models_;
};

TEST_F(EveryModel, IsFiniteUnderVeniceSunset) {
    expect_finite(models_, "environments/venice_sunset_1k.hdr", {});
}

TEST_F(EveryModel, IsFiniteUnderRoyalEsplanade) {
    expect_finite(models_, "environments/royal_esplanade_1k.hdr", {});
}

// Where the methods have most to do: a rough normal map on narrow lobes, on models with stored
// tangents of a drum, with those of a head that are one a triangle, and without.
TEST_F(EveryModel, IsFiniteWithABumpyBrushedSurface) {
    std::erase_if(models_, [](const fs::path& model) {
        return model.stem() != "AnisotropyRotationTest" && model.stem() != "Suzanne" &&
               model.stem() != "NormalTangentTest";
    });
    expect_finite(models_, "environments/venice_sunset_1k.hdr",
                  {{"alpha_x", "0.05"},
                   {"alpha_y", "0.6"},
                   {"normal_map", "builtin:bumps"},
                   {"normal_scale", "3"},
                   {"metallic", "1"}});
}

}  // namespace
}  // namespace burnish::test
