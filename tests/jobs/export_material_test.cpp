// Materials written by burnish export material and read back.
#include "jobs/export_material.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "burnish/draft.hpp"
#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "burnish/load_model.hpp"
#include "burnish/stage.hpp"
#include "image/texel_value.hpp"
#include "support/test_folder.hpp"

namespace burnish {
namespace {

using namespace test;

ExportMaterialRequest request_of(
    const ScratchFolder& folder,
    std::initializer_list<std::pair<const char*, const char*>> parameters) {
    ExportMaterialRequest request;
    request.stage.input = "builtin:plane";
    request.stage.environment = "none";
    for (const auto& [name, value] : parameters) request.stage.values.set(name, value, name);
    request.width = request.height = 64;
    request.preview = false;
    request.output = folder / "out";
    return request;
}

Material source_of(const ExportMaterialRequest& request) {
    return set_stage(request.stage).scene.materials.front();
}

Material read_back(const ScratchFolder& folder) {
    return load_model((folder / "out/material.gltf").string(), 0).materials.front();
}

nlohmann::json json_of(const std::filesystem::path& file) {
    std::ifstream in(file);
    return nlohmann::json::parse(in);
}

// A built-in mesh has no name for its material.
TEST(ExportMaterial, MaterialsOfFlagsAreNamedByWhatTheFlagsName) {
    const ScratchFolder folder;
    std::filesystem::create_directories(folder / "rust_2k/textures");
    write_image(folder / "rust_2k/textures/rust_color.png", Image(4, 4, 3, 0.5f), {});
    const struct {
        std::vector<std::pair<std::string, std::string>> parameters;
        std::string name;
    } cases[] = {{{{"metal", "gold"}}, "gold"},
                 {{{"scratch", "brushed"}}, "brushed"},
                 {{{"metal", "steel"}, {"scratch", "fine-random"}}, "steel-fine-random"},
                 {{{"weave", "twill-2-2"}}, "twill-2-2"},
                 {{{"maps", (folder / "rust_2k/textures").string() + "/"}}, "rust_2k"},
                 {{{"roughness", "0.3"}}, "default"}};
    for (const auto& c : cases) {
        ExportMaterialRequest request = request_of(folder, {});
        for (const auto& [name, value] : c.parameters) request.stage.values.set(name, value, name);
        export_material(request, {});
        EXPECT_EQ(json_of(folder / "out/material.json").at("name"), c.name);
        EXPECT_EQ(read_back(folder).name, c.name);
        std::filesystem::remove_all(folder / "out");
    }
}

TEST(ExportMaterial, WhatGltfCannotSayComesBack) {
    const ScratchFolder folder;
    const ExportMaterialRequest request = request_of(folder, {{"metal", "gold"},
                                                              {"alpha_x", "0.08"},
                                                              {"alpha_y", "0.3"},
                                                              {"mdf", "beckmann"},
                                                              {"brdf", "cook-torrance"},
                                                              {"method", "rotate-arc"}});
    const ExportMaterialReport report = export_material(request, {});
    EXPECT_EQ(report.warnings.size(), 5U)
        << "mdf, brdf and the metal are approximated in glTF; mdf and method change nothing here";
    const Material from = source_of(request), to = read_back(folder);
    EXPECT_EQ(to.mdf, from.mdf);
    EXPECT_EQ(to.brdf, from.brdf);
    EXPECT_EQ(to.method, from.method);
    EXPECT_EQ(to.conductor, from.conductor);
    EXPECT_TRUE(to.base_color_texture);
    EXPECT_TRUE(to.anisotropy_texture);
}

TEST(ExportMaterial, ANamedProcessComesBackWithItsMethod) {
    const ScratchFolder folder;
    for (const std::string_view name : process_names()) {
        const ExportMaterialRequest request =
            request_of(folder, {{"metal", "steel"}, {"process", name.data()}});
        export_material(request, {});
        const Material from = source_of(request), to = read_back(folder);
        ASSERT_TRUE(from.process);
        EXPECT_EQ(name_of(*from.process), name);
        EXPECT_EQ(to.process, from.process) << name;
        EXPECT_EQ(to.method, method_of(*from.process)) << name;
        std::filesystem::remove_all(folder / "out");
    }
}

TEST(ExportMaterial, AFilmComesBackAndIsSaidToBeLostInGltf) {
    const ScratchFolder folder;
    const ExportMaterialRequest request =
        request_of(folder, {{"metal", "titanium"}, {"oxide", "50"}});
    const ExportMaterialReport report = export_material(request, {});
    EXPECT_TRUE(
        std::any_of(report.warnings.begin(), report.warnings.end(),
                    [](const std::string& line) { return line.find("oxide: ") != line.npos; }));
    const Material from = source_of(request), to = read_back(folder);
    ASSERT_TRUE(from.conductor && from.conductor->oxide);
    EXPECT_EQ(to.conductor, from.conductor);
}

TEST(ExportMaterial, WithoutExtrasItIsGltfAlone) {
    const ScratchFolder folder;
    ExportMaterialRequest request = request_of(folder, {{"metal", "gold"}, {"mdf", "beckmann"}});
    request.extras = false;
    export_material(request, {});
    const Material to = read_back(folder);
    EXPECT_EQ(to.mdf, Mdf::ggx);
    EXPECT_FALSE(to.conductor);
}

TEST(ExportMaterial, AWeaveComesBackAsAWeave) {
    const ScratchFolder folder;
    const ExportMaterialRequest request = request_of(
        folder, {{"weave", "satin-5"}, {"warp_color", "0.5,0.1,0.1"}, {"weave_yarns", "20"}});
    export_material(request, {});
    const Material from = source_of(request), to = read_back(folder);
    const Cloth *wanted = cloth_of(from), *found = cloth_of(to);
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(found->draft->warp_up, wanted->draft->warp_up);
    EXPECT_EQ(found->yarns, wanted->yarns);
    EXPECT_EQ(found->warp_color, wanted->warp_color);
    EXPECT_EQ(found->weft_color, wanted->weft_color);
    EXPECT_EQ(found->alpha, wanted->alpha);
    EXPECT_FLOAT_EQ(found->twist, wanted->twist);
    EXPECT_FALSE(to.base_color_texture);
}

// Files of an earlier export would be taken for maps of the new material.
TEST(ExportMaterial, ASecondExportRemovesFilesOfTheFirst) {
    const ScratchFolder folder;
    export_material(request_of(folder, {{"weave", "plain"}}), {});
    EXPECT_TRUE(std::filesystem::exists(folder / "out/draft.wif"));
    folder.write("out/notes.txt", "mine");
    export_material(request_of(folder, {{"metal", "gold"}}), {});
    EXPECT_FALSE(std::filesystem::exists(folder / "out/draft.wif"));
    EXPECT_TRUE(std::filesystem::exists(folder / "out/notes.txt"));
}

// The quad is as wide as its tiles together.
TEST(ExportMaterial, SizesThatAreStatedAreKept) {
    const ScratchFolder folder;
    export_material(request_of(folder, {{"scratch", "brushed"}, {"uv_scale", "4"}}), {});
    EXPECT_EQ(json_of(folder / "out/material.json")["tile_mm"][0], 50.0);
    const Bounds bounds = bounds_of(load_model((folder / "out/material.gltf").string(), 0));
    EXPECT_NEAR(bounds.high.x - bounds.low.x, 0.2, 1e-6);
    // A folder that states its size, as a set of maps.
    std::filesystem::rename(folder / "out", folder / "maps");
    const std::string maps = (folder / "maps").string();
    export_material(request_of(folder, {{"maps", maps.c_str()}}), {});
    EXPECT_EQ(json_of(folder / "out/material.json")["tile_mm"][0], 50.0);
    export_material(request_of(folder, {{"maps", maps.c_str()}, {"maps_tile_mm", "75"}}), {});
    EXPECT_EQ(json_of(folder / "out/material.json")["tile_mm"][0], 75.0);
    export_material(request_of(folder, {{"weave", "plain"}, {"weave_yarns_per_cm", "8"}}), {});
    // Sixteen yarns, eight a centimeter.
    EXPECT_EQ(json_of(folder / "out/material.json")["tile_mm"][0], 20.0);
}

TEST(ExportMaterial, TheManifestNamesEveryMap) {
    const ScratchFolder folder;
    ExportMaterialRequest request = request_of(folder, {{"metal", "gold"}});
    request.tile_mm = 50.0;
    export_material(request, {});
    const nlohmann::json manifest = json_of(folder / "out/material.json");
    EXPECT_EQ(manifest["tile_mm"][0], 50.0);
    for (const auto& [name, map] : manifest["maps"].items()) {
        const ImageInfo info = read_image_info(folder / ("out/" + map["file"].get<std::string>()));
        EXPECT_EQ(info.width, 64) << name;
        EXPECT_EQ(info.pixel_type, map["bits"] == 8 ? "uint8" : "uint16") << name;
    }
}

// A set of four maps dropped as a folder, against a glTF made by hand of the same four.
TEST(ExportMaterial, AFolderOfFourMapsIsTheSameMadeByHand) {
    const ScratchFolder folder;
    export_material(request_of(folder, {{"scratch", "brushed"}, {"alpha_x", "0.1"}}), {});
    std::filesystem::create_directory(folder / "set");
    const Image orm = read_image(folder / "out/orm.png", {.as_data = true});
    for (const auto& [name, channel] :
         {std::pair("s_Roughness.png", 1), std::pair("s_Metalness.png", 2)}) {
        Image one(orm.width, orm.height, 3);
        for (std::size_t t = 0; t < orm.pixels.size(); ++t)
            one.pixels[t] = orm.pixels[3 * (t / 3) + static_cast<std::size_t>(channel)];
        write_image(folder / ("set/" + std::string(name)), one, {});
    }
    for (const auto& [from, to] :
         {std::pair("base_color", "s_Color"), std::pair("normal", "s_NormalGL")})
        std::filesystem::copy_file(folder / ("out/" + std::string(from) + ".png"),
                                   folder / ("set/" + std::string(to) + ".png"));
    // By hand: roughness and metal of 8 bits in one picture, as glTF wants them.
    Image mine(orm.width, orm.height, 3);
    const Image rough = read_image(folder / "set/s_Roughness.png", {.as_data = true});
    const Image metal = read_image(folder / "set/s_Metalness.png", {.as_data = true});
    for (std::size_t t = 0; t < mine.pixels.size(); t += 3) {
        mine.pixels[t] = 1.0f;
        mine.pixels[t + 1] = rough.pixels[t];
        mine.pixels[t + 2] = metal.pixels[t];
    }
    write_image(folder / "out/mine.png", mine, {});
    nlohmann::json gltf = json_of(folder / "out/material.gltf");
    gltf["images"][1]["uri"] = "mine.png";
    nlohmann::json& material = gltf["materials"][0];
    for (const char* key : {"extras", "occlusionTexture", "extensions"}) material.erase(key);
    std::ofstream(folder / "out/mine.gltf") << gltf.dump();

    StageRequest request;
    request.environment = "none";
    request.input = (folder / "out/mine.gltf").string();
    const Stage by_hand = set_stage(request);
    request.values.set("maps", (folder / "set").string(), "--maps");
    const Stage dropped = set_stage(request);
    const Material &a = by_hand.scene.materials.front(), &b = dropped.scene.materials.front();
    EXPECT_EQ(a.lobe, b.lobe);
    EXPECT_EQ(a.metallic, b.metallic);
    EXPECT_EQ(a.base_color, b.base_color);
    EXPECT_EQ(a.flip_green, b.flip_green);
    for (TextureUse Material::*const use :
         {&Material::base_color_texture, &Material::normal_texture,
          &Material::metallic_roughness_texture}) {
        const Texture& x = by_hand.scene.textures.at(static_cast<std::size_t>((a.*use).texture));
        const Texture& y = dropped.scene.textures.at(static_cast<std::size_t>((b.*use).texture));
        ASSERT_EQ(x.width, y.width);
        ASSERT_EQ(x.color_space, y.color_space);
        double worst = 0;
        for (std::size_t t = 0; t < x.texels.size() / (x.type == TexelType::u16 ? 2 : 1); ++t)
            worst = std::max(worst, std::abs(static_cast<double>(texel_value(x, t)) -
                                             static_cast<double>(texel_value(y, t))));
        // The same codes; the joined map has 16 bits for 8.
        EXPECT_LT(worst, 1e-5);
    }
}

TEST(ExportMaterial, AMaterialThatIsNotThereIsNamed) {
    const ScratchFolder folder;
    ExportMaterialRequest request = request_of(folder, {});
    request.material = "dor";
    const std::string line = error_line<UsageError>([&] { export_material(request, {}); });
    EXPECT_NE(line.find("--material: expected a name (default)"), line.npos) << line;
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

// Extras are a reader's input like any other: what is wrong is said, and the maps are drawn.
TEST(ExportMaterial, BrokenExtrasAreWarnings) {
    const ScratchFolder folder;
    export_material(request_of(folder, {{"weave", "plain"}}), {});
    const std::filesystem::path file = folder / "out/material.gltf";
    const nlohmann::json whole = json_of(file);
    const auto faults = {
        R"({"mdf": "phong"})",
        R"({"mdf": 3})",
        R"([])",
        R"("text")",
        R"({"unknown": 1})",
        R"({"conductor": {"eta": [1, 2], "k": [1, 2, 3]}})",
        R"({"conductor": {"eta": [1, 2, -3], "k": [1, 2, 3]}})",
        R"({"conductor": {"eta": [1, 2, 3], "k": [1, 2, 3], "oxide": {"thickness_nm": 50}}})",
        R"({"conductor": {"eta": [1, 2, 3], "k": [1, 2, 3],
            "oxide": {"thickness_nm": 50, "curve": [[1, 1, 1]]}}})",
        R"({"conductor": {"eta": [1, 2, 3], "k": [1, 2, 3], "oxide": {"thickness_nm": -1,
            "curve": [[1, 1, 1], [0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0]]}}})",
        R"({"conductor": {"eta": [1, 2, 3], "k": [1, 2, 3], "oxide": {"thickness_nm": 5,
            "curve": [[1, 1, 1], [0, 0, 0], [0, 0, 1e9], [0, 0, 0], [0, 0, 0], [0, 0, 0]]}}})",
        R"({"tabulated": "../material.gltf", "color": {"base": [1, 1, 1], "metallic": 1}})",
        R"({"tabulated": "/etc/passwd", "color": {"base": [1, 1, 1], "metallic": 1}})",
        R"({"tabulated": "gone.exr", "color": {"base": [1, 1, 1], "metallic": 1}})",
        R"({"cloth": {"draft": "draft.wif"}})",
        R"({"cloth": {"draft": "draft.wif", "yarns": 1e9}})",
    };
    for (const char* fault : faults) {
        nlohmann::json broken = whole;
        broken["materials"][0]["extras"]["burnish"] = nlohmann::json::parse(fault);
        std::ofstream(file) << broken.dump();
        const Scene scene = load_model(file.string(), 0);
        EXPECT_TRUE(scene.materials.front().base_color_texture) << fault;
        EXPECT_TRUE(std::any_of(scene.warnings.begin(), scene.warnings.end(),
                                [](const std::string& line) {
                                    return line.find("extras.burnish") != line.npos &&
                                           line.find("maps are drawn") != line.npos;
                                }))
            << fault;
    }
}

}  // namespace
}  // namespace burnish
