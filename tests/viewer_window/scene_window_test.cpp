// The lists of the scene, comparisons of materials and the ways to move, done by scripts.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "viewer_window/display.hpp"

namespace burnish::test {
namespace {

constexpr const char* kBare =
    "set samples 2\nset image_light prefiltered\nlight 20,40,2\npanel parameters off\n"
    "panel scene off\nwait rest\n";

// Above the status bar, whose words differ.
constexpr int kPicture = 450;

std::string shot(const std::string& file) {
    return fmt::format("wait rest\nwait 2\nscreenshot {}\n", file);
}

TEST_F(ViewerWindow, BookmarksAreKeptGoneToSavedAndFoundAgain) {
    const std::string scene = path("kept.json");
    play(std::string(kBare) + "drag orbit 120 40 2\nbookmark add \"from the left\"\n" +
             shot(path("left.png")) +
             "drag orbit -200 -20 2\nbookmark add front\nexpect bookmarks = 2\n" +
             "bookmark go \"from the left\"\n" + shot(path("again.png")) + "bookmark go front\n" +
             shot(path("front.png")) +
             "bookmark rename front \"the front\"\nbookmark go front\nexpect error = \"no "
             "bookmark\"\n"
             "bookmark rename \"the front\" \"from the left\"\nexpect error = \"a name that no\"\n"
             "bookmark delete \"the front\"\nexpect bookmarks = 1\nundo\nexpect bookmarks = 2\n"
             "drag orbit 30 0\nkey b\nexpect bookmarks = 3\nkey n\nundo 3\nexpect bookmarks = 2\n" +
             fmt::format("save scene {}\n", scene),
         {"builtin:torus"});
    EXPECT_EQ(levels_between(picture("left.png"), picture("again.png"), kPicture), 0.0);
    EXPECT_GT(levels_between(picture("left.png"), picture("front.png"), kPicture), 50.0);
    const auto json = nlohmann::json::parse(contents_of(scene));
    EXPECT_EQ(json["viewer"]["bookmarks"][1]["name"], "the front");
    play(
        "panel parameters off\npanel scene off\nwait rest\nexpect bookmarks = 2\n"
        "bookmark go \"from the left\"\n" +
            shot(path("reopened.png")),
        {scene});
    EXPECT_LE(levels_between(picture("left.png"), picture("reopened.png"), kPicture), 1.001);
}

TEST_F(ViewerWindow, ObjectsAreHiddenShownAloneAndFramed) {
    play(std::string(kBare) + shot(path("all.png")) +
             "expect objects = 2\nobject #0 off\nexpect objects_shown = 1\n" +
             shot(path("right.png")) +
             "undo\nexpect objects_shown = 2\nobject #1 solo\nexpect objects_shown = 1\n" +
             shot(path("solo.png")) +
             "object #1 solo\nexpect objects_shown = 2\nobject #0 off\nobject all on\n"
             "expect objects_shown = 2\nobject #0 frame\nexpect selected_object = 0\n" +
             shot(path("framed.png")) +
             "object #7 on\nexpect error = \"an object of the scene\"\n"
             "key o\nexpect selected_object = 1\nkey x\nexpect objects_shown = 1\nkey x\nkey s\n"
             "expect objects_shown = 1\nkey s\nexpect objects_shown = 2\n",
         {two_materials("two.glb")});
    EXPECT_GT(levels_between(picture("all.png"), picture("right.png"), kPicture), 50.0);
    EXPECT_EQ(levels_between(picture("right.png"), picture("solo.png"), kPicture), 0.0);
    EXPECT_GT(levels_between(picture("all.png"), picture("framed.png"), kPicture), 50.0);
}

TEST_F(ViewerWindow, LightsAreAddedSwitchedChangedAndRemoved) {
    const std::string scene = path("dark.json");
    play(std::string(kBare) + "environment none\n" + shot(path("lit.png")) +
             "lights 1 off\nexpect lights = 1\nexpect lights_on = 0\n" + shot(path("dark.png")) +
             fmt::format("save scene {}\n", scene) + "lights 1 on\n" + shot(path("relit.png")) +
             "lights add point\nlights add directional\nexpect lights = 3\n"
             "lights 3 to 100,20\nlights 3 color #ff0000\n" +
             shot(path("red.png")) +
             "lights 3 remove\nexpect lights = 2\nundo\nexpect lights = 3\n"
             "lights 2 off\nlights 1 remove\nexpect lights_on = 1\nlights 9 off\n"
             "expect error = \"no light 9\"\nkey l\nkey k\nexpect lights_on = 0\nkey k\n"
             "expect lights_on = 1\n",
         {"builtin:torus"});
    EXPECT_GT(levels_between(picture("lit.png"), picture("dark.png"), kPicture), 50.0);
    EXPECT_EQ(levels_between(picture("lit.png"), picture("relit.png"), kPicture), 0.0);
    EXPECT_GT(levels_between(picture("lit.png"), picture("red.png"), kPicture), 20.0);
    // What is off is off in other programs too, and on again in the window as it was.
    const auto json = nlohmann::json::parse(contents_of(scene));
    EXPECT_EQ(json["lights"][0]["intensity"], 0.0);
    play("panel parameters off\npanel scene off\nwait rest\nexpect lights_on = 0\nlights 1 on\n" +
             shot(path("opened.png")),
         {scene});
    EXPECT_LE(levels_between(picture("lit.png"), picture("opened.png"), kPicture), 1.001);
}

TEST_F(ViewerWindow, MaterialsAreSelectedAndTheBackgroundIsHidden) {
    play(std::string(kBare) +
             "material right\nexpect selected_material = 1\nkey j\nexpect selected_material = -1\n"
             "key j\nexpect selected_material = 0\nmaterial all\nexpect selected_material = -1\n"
             "material middle\nexpect error = \"a material of the scene\"\n"
             "background off\nexpect background = color\nkey e\nexpect background = environment\n"
             "undo\nexpect background = color\n",
         {two_materials("two.glb")});
}

TEST_F(ViewerWindow, TwoMaterialsAreComparedInEveryWay) {
    const std::string model = two_materials("two.glb");
    const std::string scene = path("compared.json");
    const auto logged = play(
        std::string(kBare) + shot(path("plain.png")) + "compare split material left right\n" +
            shot(path("split.png")) +
            "compare difference\nwait rest\nwait 3\nexpect difference > 0.001\n"
            "compare flip\nwait rest\nwait 3\nexpect flip > 0.001\nlog flip\n"
            // A change of the other material is one of the second picture.
            "set roughness 0.9 right\nwait rest\nwait 3\nlog flip\ncompare blink\nwait 10\n" +
            fmt::format("save scene {}\n", scene) +
            // The same material on both sides is no difference.
            "set base_color #808080\nset metallic 1\nset roughness 0.5\ncompare flip\nwait rest\n"
            "wait 3\nexpect flip < 1e-9\nundo 4\n"
            "compare split material left left\nexpect error = \"two materials\"\n"
            "compare split material left nowhere.exr\nexpect error = nowhere.exr\n"
            "compare split normal-map follow-grain\nwait rest\ncompare off\n" +
            shot(path("off.png")),
        {model});
    EXPECT_EQ(logged.count("flip"), 1u);
    const Image plain = picture("plain.png"), split = picture("split.png");
    EXPECT_GT(levels_between(plain, split, kPicture), 50.0);
    const auto json = nlohmann::json::parse(contents_of(scene));
    EXPECT_EQ(json["viewer"]["compare"]["materials"]["other"], 1);
    play("wait rest\nwait 3\ncompare difference\nwait rest\nwait 3\nexpect difference > 0.001\n",
         {scene});
}

TEST_F(ViewerWindow, BeforeAndAfterGivesWayToMethodsAndMaterials) {
    play(std::string(kBare) +
             "key h\nset roughness 0.9\ncompare difference\nwait rest\nwait 3\n"
             "expect difference > 0.001\n"
             // The divider of two pictures is no divider of three methods.
             "compare split\nmove 320 200\nmouse left 60 0\nwait rest\n"
             "compare split none normal-map follow-grain\nwait rest\nkey h\nmove 320 200\n"
             "mouse left -60 0\nwait rest\nkey h\ncompare split material #0 #1\nwait rest\nkey h\n"
             "wait rest\nkey h\nwait rest\n",
         {two_materials("two.glb")});
}

TEST_F(ViewerWindow, NavigationFollowsGltfViewersOrBlender) {
    std::string script = std::string(kBare) + "wait 2\nexpect undo_count = 3\n";
    struct Case {
        const char *navigation, *pad, *gesture;
        int steps;
    };
    for (const Case& c : {Case{"viewer", "off", "mouse left 80 0", 1},
                          {"viewer", "off", "mouse middle 80 0", 1},
                          {"viewer", "off", "mouse right 80 0", 1},
                          {"viewer", "off", "scroll 0 2", 1},
                          {"blender", "off", "mouse left 80 0", 0},
                          {"blender", "off", "mouse middle 80 0", 1},
                          {"blender", "off", "mouse middle 80 0 shift", 1},
                          {"blender", "off", "mouse middle 0 40 ctrl", 1},
                          {"blender", "off", "scroll 0 2", 1},
                          {"blender", "on", "scroll 3 2", 1},
                          {"blender", "on", "scroll 3 2 shift", 1},
                          {"blender", "on", "scroll 0 2 ctrl", 1}})
        script += fmt::format(
            "navigation {}\ntouchpad {}\nmove 320 240\nwait 2\n{}\nexpect undo_count = {}\n{}",
            c.navigation, c.pad, c.gesture, 3 + c.steps, c.steps > 0 ? "undo\n" : "");
    play(script, {"builtin:torus"});
    const std::string state = path("state");
    play("navigation blender\ntouchpad on\nwait 2\n", {"--state", state});
    const auto json = nlohmann::json::parse(contents_of(state + "/view.json"));
    EXPECT_EQ(json["navigation"], "blender");
    EXPECT_EQ(json["touchpad"], true);
}

}  // namespace
}  // namespace burnish::test
