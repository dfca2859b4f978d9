// What opening a file means: files are told by content and by the roles that names state.
#include "viewer/document/open_files.hpp"

#include <gtest/gtest.h>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "stage/value_samples.hpp"
#include "support/paths.hpp"
#include "viewer/document/load_stage.hpp"
#include "viewer/viewer_support.hpp"

namespace burnish::viewer {
namespace {

using test::error_line;
using test::ScratchFolder;
using test::two_materials;

class OpenedFiles : public testing::Test {
  protected:
    std::string picture(const std::string& name, int width, int height) {
        std::filesystem::create_directories((folder_ / name).parent_path());
        write_image(folder_ / name, Image(width, height, 3, 0.5f), {});
        return (folder_ / name).string();
    }

    Document opened_alone(const std::string& path) { return document_for({{path}}); }

    ScratchFolder folder_;
};

TEST_F(OpenedFiles, WithoutAnyASphereOfBrushedSteelIsShown) {
    const Document document = document_for({});
    EXPECT_EQ(document, first_document());
    const Stage stage = load_stage(document);
    EXPECT_TRUE(stage.scene.warnings.empty());
    EXPECT_FALSE(stage.environment.radiance.empty());
    const Material& steel = stage.scene.materials.at(0);
    EXPECT_TRUE(steel.conductor.has_value());
    EXPECT_TRUE(static_cast<bool>(steel.normal_texture));
    const glm::vec2 alpha = stated_alpha(steel).value();
    EXPECT_GT(std::max(alpha.x, alpha.y), 2.0f * std::min(alpha.x, alpha.y));
}

TEST_F(OpenedFiles, ModelsAndScenesAreTheInput) {
    const std::string model = two_materials(folder_, "two.glb").string();
    EXPECT_EQ(opened_alone(model).input, model);
    EXPECT_EQ(opened_alone("builtin:torus").input, "builtin:torus");
    const std::string scene = folder_
                                  .write("s.json", R"({"format": "burnish-scene", "version": 1,
        "objects": [{"model": "builtin:plane"}]})")
                                  .string();
    EXPECT_EQ(opened_alone(scene).input, scene);
}

TEST_F(OpenedFiles, ANewInputEndsWhatBelongedToTheFormerOne) {
    Document document = first_document();
    set_parameter(document, "exposure", 1.0);
    set_parameter(document, "alpha_x", 0.3, 0);
    set_camera(document, {0, 0, 3}, {0, 0, 0}, 30.0);
    document.hidden = {0};
    document.lights.emplace();
    document.environment = "builtin:white";
    document.bookmarks.push_back({"here"});
    const Document model = opened(document, "builtin:plane");
    Document expected{.input = "builtin:plane", .environment = "builtin:white"};
    set_parameter(expected, "exposure", 1.0);
    EXPECT_EQ(model, expected);
    const std::string scene = folder_
                                  .write("s.json", R"({"format": "burnish-scene", "version": 1,
        "objects": [{"model": "builtin:plane"}]})")
                                  .string();
    EXPECT_EQ(opened(document, scene), Document{.input = scene}) << "the scene says it all";
}

TEST_F(OpenedFiles, LatLongPicturesAreEnvironmentsUnlessTheirNameStatesARole) {
    const std::string sky = picture("sky.exr", 16, 8);
    EXPECT_EQ(opened_alone(sky).environment, sky);
    EXPECT_EQ(opened_alone(sky).input, "builtin:sphere");
    EXPECT_EQ(opened_alone("builtin:white").environment, "builtin:white");
    const std::string wide = picture("wide_normal.png", 16, 8);
    EXPECT_EQ(opened_alone(wide).values.text("normal_map"), wide);
    EXPECT_EQ(opened_alone(wide).environment, "");
}

TEST_F(OpenedFiles, OtherPicturesAreTheMapsThatTheirNamesState) {
    const std::pair<const char*, const char*> kRoles[] = {{"rust_Color.png", "base_color_map"},
                                                          {"rust_Roughness.png", "roughness_map"},
                                                          {"rust_gloss.png", "glossiness_map"},
                                                          {"rust_Metalness.png", "metallic_map"},
                                                          {"rust_ao.png", "ao_map"},
                                                          {"rust_arm.png", "orm_map"},
                                                          {"rust_anisotropy.png", "anisotropy_map"},
                                                          {"rust_disp.png", "height_map"},
                                                          {"rust_emission.png", "emissive_map"},
                                                          {"rust_NormalGL.png", "normal_map"}};
    for (const auto& [name, parameter] : kRoles) {
        const std::string file = picture(name, 8, 8);
        const Document document = opened_alone(file);
        EXPECT_EQ(document.values.text(parameter), file);
        load_stage(document);
    }
    const Document directx = opened_alone(picture("rust_NormalDX.png", 8, 8));
    EXPECT_TRUE(directx.values.boolean("flip_green"));
    std::vector<std::string> notes;
    const std::string plain = picture("IMG_1234.png", 8, 8);
    EXPECT_EQ(document_for({{plain}}, &notes).values.text("normal_map"), plain);
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_NE(notes[0].find("taken as a normal map"), std::string::npos);
}

TEST_F(OpenedFiles, MaterialsGoOntoTheSelectedMaterialOrAll) {
    const std::string table = (folder_ / "table.exr").string();
    write_tabulated_material(table, test::even_table());
    EXPECT_EQ(opened_alone(table).input, "builtin:sphere");
    EXPECT_EQ(opened_alone(table).values.text("tabulated"), table);
    Document document = opened_alone(two_materials(folder_, "two.glb").string());
    document = opened(document, table, 1);
    EXPECT_FALSE(document.values.is_set("tabulated"));
    EXPECT_EQ(document.material_values.at(1).text("tabulated"), table);
    const std::string draft = (test::source_folder() / "examples/weaves/tweed.wif").string();
    if (std::filesystem::exists(draft)) {
        document = opened(document, draft, 1);
        EXPECT_EQ(document.material_values.at(1).text("weave"), draft);
        EXPECT_FALSE(document.material_values.at(1).is_set("tabulated"))
            << "a weave takes its place";
    }
}

TEST_F(OpenedFiles, FoldersAreScratchMapsOrSetsOfMaps) {
    picture("set/rust_Color.png", 8, 8);
    const std::string set = (folder_ / "set").string();
    EXPECT_EQ(opened_alone(set).values.text("maps"), set);
    EXPECT_EQ(opened_alone(set + "/").input, "builtin:sphere");
    picture("scratches/normal.png", 8, 8);
    picture("scratches/anisotropy.png", 8, 8);
    folder_.write("scratches/scratch.json", "{}");
    const std::string scratches = (folder_ / "scratches").string();
    EXPECT_EQ(opened_alone(scratches).values.text("scratch"), scratches);
    std::filesystem::create_directory(folder_ / "empty");
    error_line<UsageError>([&] { opened_alone((folder_ / "empty").string()); });
}

TEST_F(OpenedFiles, ARigSaysHowItBecomesAMaterialUnlessOneLiesBesideIt) {
    const std::string rig =
        folder_.write("rig.json", R"({"format": "burnish-rig", "version": 1})").string();
    const std::string line = error_line([&] { opened_alone(rig); });
    EXPECT_NE(line.find("run `burnish capture fit"), std::string::npos) << line;
    write_tabulated_material(folder_ / "fitted.exr", test::even_table());
    std::vector<std::string> notes;
    EXPECT_EQ(document_for({{rig}}, &notes).values.text("tabulated"),
              (folder_ / "fitted.exr").string());
    EXPECT_EQ(notes.size(), 1u);
}

TEST_F(OpenedFiles, TheOrderOfArgumentsDoesNotMatter) {
    const std::string sky = picture("sky.exr", 16, 8), color = picture("rust_Color.png", 8, 8);
    const std::string model = two_materials(folder_, "two.glb").string();
    const Document document = document_for({{sky, color, model}});
    EXPECT_EQ(document, document_for({{model, sky, color}}));
    EXPECT_EQ(document.input, model);
    EXPECT_EQ(document.environment, sky);
    EXPECT_EQ(document.values.text("base_color_map"), color);
}

TEST_F(OpenedFiles, NamesBecomeAbsolute) {
    const std::string sky = picture("sky.exr", 16, 8);
    const std::string relative = std::filesystem::relative(sky).string();
    EXPECT_EQ(opened_alone(relative).environment,
              std::filesystem::absolute(relative).lexically_normal().string());
}

TEST_F(OpenedFiles, WhatIsNoneOfTheseIsRefused) {
    error_line([&] { opened_alone((folder_ / "missing.glb").string()); });
    error_line([&] { opened_alone(""); });
    // A file of unknown content is taken for a model, whose reader says what it expects.
    const Document document = opened_alone(folder_.write("notes.txt", "nothing").string());
    error_line([&] { load_stage(document); });
    error_line([&] { load_stage(opened_alone("builtin:cube")); });
}

}  // namespace
}  // namespace burnish::viewer
