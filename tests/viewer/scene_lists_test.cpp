// What the lists of a scene say, and lights that are switched off.
#include "viewer/document/scene_lists.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "viewer/document/editor.hpp"
#include "viewer/document/load_stage.hpp"
#include "viewer/document/save_scene.hpp"
#include "viewer/motion/navigation.hpp"
#include "viewer/viewer_support.hpp"

namespace burnish::viewer {
namespace {

using test::expect_same_stage;
using test::ScratchFolder;
using test::two_materials;

class SceneLists : public testing::Test {
  protected:
    void SetUp() override {
        Document document;
        document.input = two_materials(folder_, "two.glb", true).string();
        document.environment = "none";
        editor_.open(document);
    }
    void change(const auto& edit) {
        Document document = editor_.document();
        edit(document);
        editor_.set(document);
    }
    const Stage& stage() const { return editor_.stage(); }

    ScratchFolder folder_;
    Editor editor_;
};

TEST_F(SceneLists, MaterialsSayWhatTheyAre) {
    const auto kind = [&](const char* name, const char* value) {
        change([&](Document& d) { set_parameter_text(d, name, value, 1); });
        const std::string found = material_rows(stage())[1].kind;
        editor_.undo();
        return found;
    };
    std::vector<MaterialRow> rows = material_rows(stage());
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].name, "brass");
    EXPECT_EQ(rows[0].kind, "metal");
    EXPECT_EQ(rows[1].kind, "dielectric");
    EXPECT_EQ(rows[0].objects, 2);
    EXPECT_EQ(rows[1].objects, 1);
    EXPECT_EQ(kind("metal", "gold"), "metal");
    EXPECT_EQ(kind("weave", "plain"), "weave");
    EXPECT_EQ(kind("scratch", "brushed"), "scratch");
    change([](Document& d) {
        set_parameter(d, "base_color", glm::vec3(0.2f, 0.4f, 0.6f), 1);
        set_parameter_text(d, "metal", "gold", 0);
        d.hidden = {0};
    });
    rows = material_rows(stage());
    EXPECT_EQ(rows[1].color, glm::vec3(0.2f, 0.4f, 0.6f));
    // Gold reflects red best and blue least.
    EXPECT_GT(rows[0].color.x, rows[0].color.y);
    EXPECT_GT(rows[0].color.y, rows[0].color.z + 0.1f);
    EXPECT_LE(rows[0].color.x, 1.0f);
    EXPECT_EQ(rows[0].objects, 2) << "hidden ones too";
}

TEST_F(SceneLists, ObjectsAreThereWhetherShownOrNot) {
    change([](Document& d) { d.hidden = {1}; });
    const std::vector<ObjectRow> rows = object_rows(editor_.document(), stage());
    ASSERT_EQ(rows.size(), 3u);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        EXPECT_EQ(rows[i].shown, i != 1);
        EXPECT_GT(rows[i].triangles, 0u);
        EXPECT_FALSE(rows[i].name.empty());
        EXPECT_EQ(rows[i].material, stage().scene.instances[i].material);
    }
    EXPECT_EQ(rows[0].triangles, rows[1].triangles);
}

TEST_F(SceneLists, BoundsOfAnObjectHoldItsVerticesTightly) {
    const auto moved = std::ranges::find_if(stage().scene.instances, [](const Instance& i) {
        return glm::vec3(i.transform[3]) == glm::vec3(1.5f, 0, 0);
    });
    ASSERT_NE(moved, stage().scene.instances.end());
    const auto index = static_cast<std::size_t>(moved - stage().scene.instances.begin());
    const Mesh& mesh = stage().scene.meshes[static_cast<std::size_t>(moved->mesh)];
    Bounds found = bounds_of_object(stage(), index);
    for (int axis = 0; axis < 3; ++axis) {
        const auto at = [&](const glm::vec3& p) {
            return glm::vec3(moved->transform * glm::vec4(p, 1.0f))[axis];
        };
        const auto [low, high] = std::ranges::minmax(mesh.positions, {}, at);
        EXPECT_EQ(found.low[axis], at(low));
        EXPECT_EQ(found.high[axis], at(high));
    }
    change([&](Document& d) { d.hidden = {static_cast<int>(index)}; });
    EXPECT_EQ(bounds_of_object(stage(), index).high, found.high) << "hidden ones too";
    EXPECT_EQ(bounds_of_object(stage(), 99).high, glm::vec3(0.0f));
}

TEST_F(SceneLists, SoloShowsOneAndThenAll) {
    Document document = editor_.document();
    show_alone(document, stage(), 1);
    EXPECT_EQ(document.hidden, (std::set<int>{0, 2}));
    show_alone(document, stage(), 2);
    EXPECT_EQ(document.hidden, (std::set<int>{0, 1}));
    show_alone(document, stage(), 2);
    EXPECT_TRUE(document.hidden.empty());
}

TEST_F(SceneLists, ALightThatIsOffKeepsItsIntensity) {
    ASSERT_EQ(stage().scene.lights.size(), 1u);
    const Light lit = stage().scene.lights[0];
    change([](Document& d) { d.dark = {0, 7}; });
    EXPECT_EQ(stage().scene.lights[0].intensity, 0.0f);
    EXPECT_TRUE(all_lights(editor_.document(), stage())[0] == lit);
    expect_same_stage(stage(), load_stage(editor_.document()));
    // Saved, it is off for everybody; the viewer knows what it is when it is on.
    save_scene(editor_.document(), stage(), folder_ / "dark.json");
    StageRequest request;
    request.input = (folder_ / "dark.json").string();
    EXPECT_EQ(set_stage(request).scene.lights.at(0).intensity, 0.0f);
    Editor again;
    again.open({.input = request.input});
    EXPECT_EQ(again.document().dark, std::set<int>{0});
    EXPECT_EQ(again.stage().scene.lights.at(0).intensity, 0.0f);
    Document on = again.document();
    on.dark.clear();
    again.set(on);
    EXPECT_EQ(again.stage().scene.lights.at(0).intensity, lit.intensity);
    EXPECT_EQ(again.stage().scene.lights.at(0).color, lit.color);
    editor_.undo();
    EXPECT_TRUE(stage().scene.lights[0] == lit);
}

TEST(NavigationOfTheMouse, IsThatOfViewersOrOfBlender) {
    constexpr Modifiers none{}, shift{true, false, false}, ctrl{false, true, false},
        alt{false, false, true};
    for (const Navigation n : {Navigation::viewer, Navigation::blender}) {
        EXPECT_EQ(drag_of(n, 2, none), Drag::orbit);
        EXPECT_EQ(drag_of(n, 2, shift), Drag::pan);
        EXPECT_EQ(drag_of(n, 2, ctrl), Drag::zoom);
        EXPECT_EQ(drag_of(n, 1, none), Drag::pan);
        EXPECT_EQ(drag_of(n, 0, shift), Drag::highlight);
        EXPECT_EQ(drag_of(n, 0, ctrl), Drag::light);
        EXPECT_EQ(drag_of(n, 0, alt), Drag::environment);
        for (const bool pad : {false, true})
            for (const auto& [keys, does] : mouse_help(n, pad))
                EXPECT_TRUE(keys[0] != '\0' && does[0] != '\0');
    }
    EXPECT_EQ(drag_of(Navigation::viewer, 0, none), Drag::orbit);
    EXPECT_EQ(drag_of(Navigation::blender, 0, none), Drag::none);
    EXPECT_EQ(scroll_of(false, none), Drag::zoom);
    EXPECT_EQ(scroll_of(false, shift), Drag::zoom);
    EXPECT_EQ(scroll_of(true, none), Drag::orbit);
    EXPECT_EQ(scroll_of(true, shift), Drag::pan);
    EXPECT_EQ(scroll_of(true, ctrl), Drag::zoom);
}

}  // namespace
}  // namespace burnish::viewer
