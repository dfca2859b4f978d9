// Values of a scene file and of flags on a material: flags override the file, and errors name the
// source.
#include <gtest/gtest.h>

#include <string>

#include "burnish/stage.hpp"
#include "support/glb_writer.hpp"
#include "support/test_folder.hpp"

namespace burnish::test {
namespace {

StageRequest request_of(const std::filesystem::path& input,
                        const std::vector<std::pair<std::string, std::string>>& flags) {
    StageRequest request;
    request.input = input.string();
    request.environment = "none";
    for (const auto& [name, text] : flags) request.values.set(name, text, name);
    return request;
}

TEST(NamedFaults, TheFlagsUvScaleTakesThePlaceOfTheFiles) {
    const ScratchFolder folder;
    const auto file = folder.write("s.json", R"({"format": "burnish-scene", "version": 1,
        "objects": [{"model": "builtin:plane"}],
        "parameters": {"normal_map": "builtin:bumps", "uv_scale": 4}})");
    const auto repeats = [&](const StageRequest& request) {
        const Stage stage = set_stage(request);
        return stage.scene.materials.at(0).normal_texture.transform[0][0];
    };
    EXPECT_EQ(repeats(request_of(file, {})), 4.0f);
    EXPECT_EQ(repeats(request_of(file, {{"uv_scale", "2"}})), 2.0f);
}

// A square whose anisotropy texture has its own transform.
void write_square(const std::filesystem::path& path) {
    GlbWriter writer;
    writer.add_png(png_gradient(4, 2));
    GlbPrimitive square = unit_square(1, true);
    const nlohmann::json twice = {{"KHR_texture_transform", {{"scale", {2, 2}}}}};
    square.material =
        writer.add_material({{"normalTexture", {{"index", 0}}},
                             {"extensions",
                              {{"KHR_materials_anisotropy",
                                {{"anisotropyStrength", 0.6},
                                 {"anisotropyTexture", {{"index", 0}, {"extensions", twice}}}}}}}});
    writer.add_node(writer.add_mesh(square));
    const std::vector<std::byte> bytes = writer.glb();
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
}

TEST(NamedFaults, AModelCalledScratchIsNoScratchMap) {
    const ScratchFolder folder;
    for (const char* name : {"plate.glb", "scratch pad.glb"}) {
        write_square(folder / name);
        std::filesystem::current_path(folder / "");
        const Stage stage = set_stage(request_of(name, {{"uv_scale", "3"}}));
        const Material& material = stage.scene.materials.at(0);
        EXPECT_EQ(material.normal_texture.transform[0][0], 3.0f) << name;
        EXPECT_EQ(material.anisotropy_texture.transform[0][0], 2.0f) << name;
    }
    std::filesystem::current_path(std::filesystem::temp_directory_path());
}

}  // namespace
}  // namespace burnish::test
