// The second document of a comparison: the objects of a material under another one.
#include "viewer/document/second_document.hpp"

#include <gtest/gtest.h>

#include <glm/vec2.hpp>

#include "burnish/image_io.hpp"
#include "viewer/document/load_stage.hpp"
#include "viewer/document/save_scene.hpp"
#include "viewer/document/viewer_section.hpp"
#include "viewer/viewer_support.hpp"

namespace burnish::viewer {
namespace {

using test::error_line;
using test::expect_same_materials;
using test::expect_same_stage;
using test::ScratchFolder;
using test::two_materials;

// "brass" (0) on two objects, "oak" (1) on one.
class OtherMaterials : public testing::Test {
  protected:
    void SetUp() override {
        Document document;
        document.input = two_materials(folder_, "two.glb").string();
        document.environment = "none";
        editor_.open(document);
    }
    const std::vector<Material>& materials() const { return editor_.stage().scene.materials; }
    void change(const auto& edit) {
        Document document = editor_.document();
        edit(document);
        editor_.set(document);
    }
    std::string bumps() {
        write_image(folder_ / "bumps.png", Image(4, 4, 3, 0.5f), {});
        return (folder_ / "bumps.png").string();
    }

    ScratchFolder folder_;
    Editor editor_;
};

TEST_F(OtherMaterials, TheObjectsOfOneAreDrawnWithTheOther) {
    // Values of its own that could not lie over the other's.
    change([](Document& d) {
        set_parameter(d, "alpha_x", 0.2, 0);
        set_parameter(d, "roughness", 0.6, 1);
    });
    const OtherMaterial other(editor_, {0, "#1"});
    EXPECT_EQ(other.first_name(), "brass");
    EXPECT_EQ(other.second_name(), "oak");
    const Editor second = other.editor_of(editor_);
    const std::vector<Material>& drawn = second.stage().scene.materials;
    ASSERT_EQ(drawn.size(), 2u);
    EXPECT_TRUE(drawn[0] == materials()[1]);
    EXPECT_TRUE(drawn[1] == materials()[1]);
    EXPECT_FALSE(materials()[0] == materials()[1]) << "the scene itself stays";
    EXPECT_TRUE(second.stage().scene.instances == editor_.stage().scene.instances);
}

TEST_F(OtherMaterials, AChangeOfTheSceneIsOneOfBothPictures) {
    const OtherMaterial other(editor_, {1, "#0"});
    Editor second = other.editor_of(editor_);
    change([](Document& d) {
        set_parameter(d, "alpha_x", 0.3, 0);
        set_parameter(d, "exposure", 2.0);
        d.hidden = {2};
        d.lights = {Light{}};
    });
    second.set(other.of(editor_.document()));
    const Stage& stage = second.stage();
    EXPECT_EQ(stated_alpha(stage.scene.materials[1]), glm::vec2(0.3f));
    EXPECT_TRUE(stage.scene.materials[1] == materials()[0]);
    EXPECT_EQ(stage.exposure_ev, 2.0);
    EXPECT_EQ(stage.scene.instances[2].mesh, -1);
    EXPECT_EQ(stage.scene.lights.size(), 1u);
    // Of the material that is replaced nothing is seen.
    change([](Document& d) { set_parameter(d, "alpha_x", 0.7, 1); });
    second.set(other.of(editor_.document()));
    EXPECT_EQ(stated_alpha(second.stage().scene.materials[1]), glm::vec2(0.3f));
}

TEST_F(OtherMaterials, AFileIsPutOnAsADropPutsIt) {
    const std::string file = bumps();
    const OtherMaterial other(editor_, {1, file});
    EXPECT_EQ(other.second_name(), "bumps.png");
    Document dropped = editor_.document();
    set_parameter_text(dropped, "normal_map", file, 1);
    expect_same_materials(other.editor_of(editor_).stage().scene, load_stage(dropped).scene);
}

TEST_F(OtherMaterials, WhatIsNoMaterialIsRefused) {
    const auto refused = [&](const MaterialPair& pair) {
        return error_line([&] { OtherMaterial(editor_, pair); });
    };
    EXPECT_NE(refused({5, "#0"}).find("an index below 2"), std::string::npos);
    EXPECT_NE(refused({0, "#2"}).find("an index below 2"), std::string::npos);
    EXPECT_NE(refused({0, "builtin:sphere"}).find("a material"), std::string::npos);
    EXPECT_NE(refused({0, "builtin:studio"}).find("a material"), std::string::npos);
    EXPECT_NE(refused({0, (folder_ / "none.exr").string()}).find("none.exr"), std::string::npos);
    const auto invalid = [&](const MaterialPair& pair) {
        Compare compare;
        compare.materials = pair;
        return error_line<UsageError>([&] { require_valid(compare); });
    };
    EXPECT_NE(invalid({1, "#1"}).find("two materials"), std::string::npos);
    EXPECT_NE(invalid({1, ""}).find("found none"), std::string::npos);
    EXPECT_NE(invalid({-1, "#1"}).find("a number from 0"), std::string::npos);
}

TEST_F(OtherMaterials, IndicesAreToldFromFiles) {
    EXPECT_EQ(scene_material_of("#0"), 0);
    EXPECT_EQ(scene_material_of("#12"), 12);
    for (const char* file : {"", "#", "#1x", "#-1", "# 1", "1", "#99999999999", "/a/#1"})
        EXPECT_FALSE(scene_material_of(file).has_value()) << file;
}

TEST_F(OtherMaterials, ASavedSceneKeepsTheComparison) {
    const std::string file = bumps();
    for (const std::string& other : {std::string("#1"), file}) {
        change([&](Document& d) {
            d.compare.mode = CompareMode::blink;
            d.compare.materials = MaterialPair{0, other};
            d.compare.middle = 0.25;
        });
        const auto scene = folder_ / "sub/saved.json";
        std::filesystem::create_directories(folder_ / "sub");
        save_scene(editor_.document(), editor_.stage(), scene);
        Editor again;
        again.open({.input = scene.string()});
        EXPECT_EQ(again.document().compare, editor_.document().compare) << other;
        expect_same_stage(again.stage(), editor_.stage());
    }
    const auto broken = [](const std::string& text) {
        return error_line([&] { read_viewer_section(text, "scene.json"); });
    };
    EXPECT_NE(broken(R"({"compare": {"materials": {"material": 0}}})").find("other"),
              std::string::npos);
    EXPECT_NE(
        broken(R"({"compare": {"materials": {"material": 1, "other": 1}}})").find("two materials"),
        std::string::npos);
}

// "Before": materials as they were, all else as it is.
TEST_F(OtherMaterials, WhatIsHeldIsSeenUnderThePresentCameraAndLight) {
    change([](Document& d) { set_parameter(d, "alpha_x", 0.2); });
    const Document held = editor_.document();
    change([](Document& d) {
        set_parameter(d, "alpha_x", 0.6);
        set_parameter(d, "exposure", 1.0);
        set_camera(d, {1, 2, 3}, {0, 0, 0}, 40.0);
        d.lights.emplace();
        d.environment = "builtin:white";
    });
    const Document seen = seen_as(held, editor_.document());
    EXPECT_EQ(seen.values.real("alpha_x"), 0.2);
    EXPECT_EQ(seen.values.real("exposure"), 1.0);
    EXPECT_TRUE(load_stage(seen).camera == editor_.stage().camera);
    EXPECT_EQ(seen.lights, editor_.document().lights);
    EXPECT_EQ(seen.environment, "builtin:white");
}

}  // namespace
}  // namespace burnish::viewer
