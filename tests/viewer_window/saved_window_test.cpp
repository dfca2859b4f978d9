// What is saved is what was shown: by `burnish render`, by the command line that is copied, and in the
// window again.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "support/paths.hpp"
#include "support/program.hpp"
#include "viewer_window/display.hpp"

namespace burnish::test {
namespace {

// One level of 255, and the rounding of a float.
constexpr double kOneLevel = 1.001;

constexpr const char* kPicture = "set samples 4\nset width 320\nset height 240\n";

struct Case {
    std::string name, input, changes;
};

class SavedWindow : public ViewerWindow {
  protected:
    // Saves the scene and the picture, and draws the scene by all ways that there are.
    void expect_same_pictures(const Case& wanted) {
        SCOPED_TRACE(wanted.name);
        const std::string save =
            fmt::format("wait rest\nsave picture {} 320x240\n", path("window.png"));
        const auto logged = play(fmt::format("{}{}wait rest\n{}save scene {}\nlog command_line\n",
                                             kPicture, wanted.changes, save, path("saved.json")),
                                 {wanted.input});
        const Image window = picture("window.png");

        const Outcome rendered =
            run_burnish({"render", path("saved.json"), "-o", path("rendered.png")});
        ASSERT_EQ(rendered.exit_code, 0) << rendered.complaint;
        EXPECT_LE(levels_between(window, picture("rendered.png")), kOneLevel);

        const std::string programs = (build_folder() / "bin").string();
        const std::string line = fmt::format("cd '{}' && PATH='{}':\"$PATH\" {} 2> complaint.txt",
                                             path("."), programs, logged.at("command_line"));
        ASSERT_EQ(std::system(line.c_str()), 0)
            << logged.at("command_line") << contents_of(path("complaint.txt"));
        EXPECT_LE(levels_between(window, picture("picture.png")), kOneLevel)
            << logged.at("command_line");

        play(fmt::format("wait rest\nsave picture {} 320x240\n", path("again.png")),
             {path("saved.json")});
        EXPECT_LE(levels_between(window, picture("again.png")), kOneLevel);
    }
};

TEST_F(SavedWindow, PicturesOfBuiltinMeshesAreTheSameEverywhere) {
    expect_same_pictures({"values of all materials", "builtin:torus",
                          "set alpha_x 0.35\nset alpha_y 0.08\nset metal copper\nset method "
                          "follow-grain\nlight 30,50,3\n"});
    expect_same_pictures(
        {"a moved camera, light and environment", "builtin:sphere",
         "set alpha_x 0.3\nset alpha_y 0.1\nset normal_map builtin:bumps\nset metal steel\n"
         "light 10,30,2\ndrag orbit 60 30 3\ndrag zoom 0 20 2\ndrag pan 10 -8\n"
         "drag light 40 -20 3\ndrag environment 100 0 2\nset exposure 0.5\n"});
}

TEST_F(SavedWindow, PicturesOfModelsWithMaterialsOfTheirOwnAreTheSameEverywhere) {
    expect_same_pictures({"a model", two_materials("two.glb"),
                          "set alpha_x 0.4 left\nset alpha_y 0.1 left\nset metal gold right\n"
                          "drag orbit -50 20 2\nset image_light prefiltered\n"});
}

// The first scene of the window, with its scratches, as a new user would save it.
TEST_F(SavedWindow, TheFirstSceneIsSavedAsItIsShown) {
    play(fmt::format("{}drag orbit 30 10 2\nwait rest\nsave picture {} 320x240\nsave scene {}\n",
                     kPicture, path("window.png"), path("saved.json")));
    const Outcome rendered =
        run_burnish({"render", path("saved.json"), "-o", path("rendered.png")});
    ASSERT_EQ(rendered.exit_code, 0) << rendered.complaint;
    EXPECT_LE(levels_between(picture("window.png"), picture("rendered.png")), kOneLevel);
}

// The picture of the window at rest, in the size of the view, is that of `render` too.
TEST_F(SavedWindow, TheWindowAtRestShowsWhatRenderGives) {
    const std::string panels = "panel parameters off\npanel scene off\n";
    play(fmt::format("set samples 4\n{}light 20,40\nwait rest\nscreenshot {}\nsave picture {}\n",
                     panels, path("shot.png"), path("window.png")),
         {"builtin:torus"});
    const Image shot = picture("shot.png"), saved = picture("window.png");
    ASSERT_EQ(shot.width, saved.width);  // no panel beside the picture
    // The picture begins under the menu; below is the ball of the lights, which is the window's own.
    double least = 1e9;
    for (int top = 10; top + saved.height <= shot.height; ++top) {
        double most = 0;
        for (int y = 0; y < saved.height - 120; ++y)
            for (int x = 0; x < saved.width; ++x)
                for (int c = 0; c < 3; ++c)
                    most = std::max(most,
                                    255.0 * std::abs(static_cast<double>(shot.at(x, top + y)[c]) -
                                                     static_cast<double>(saved.at(x, y)[c])));
        least = std::min(least, most);
    }
    EXPECT_LE(least, kOneLevel);
}

// What the panel shows of a parameter is what `log` prints.
TEST_F(SavedWindow, ASceneThatIsOpenedAgainShowsItsValues) {
    const std::string scene =
        folder_.write("scene.json", R"({"format": "burnish-scene", "version": 1,
            "objects": [{"model": "builtin:sphere"}], "environment": "none",
            "parameters": {"metal": "copper", "scratch": "fine-random", "samples": 3,
                           "exposure": 0.5, "ground": true}})");
    const auto logged = play(
        "wait rest\nexpect metal = copper\nexpect samples = 3\n"
        "expect scratch = fine-random\nlog alpha_x\nexpect alpha_x > 0.1\n"
        "key ]\nexpect exposure > 0.8\nkey g\nexpect ground = false\n",
        {scene});
    EXPECT_NE(logged.at("alpha_x"), "the input's");
}

// What turns is what `render` turns, and the lights of the window are its own again afterwards.
TEST_F(SavedWindow, TurntablesAreThoseOfRender) {
    // What the drape sees of itself is found anew for every frame: few rays.
    play(fmt::format("set samples 2\nset image_light prefiltered\nset visibility_rays 16\nset "
                     "bounces 0\nlight 20,40\n"
                     "drag orbit 30 10 2\nwait rest\nsave picture {0} 320x240\n"
                     "turntable 3 {1}\nturntable 3 {2} light\nsave picture {3} 320x240\n"
                     "save scene {4}\n",
                     path("before.png"), path("object.png"), path("light.png"), path("after.png"),
                     path("saved.json")),
         {"builtin:drape"});
    EXPECT_LE(levels_between(picture("before.png"), picture("after.png")), kOneLevel);
    const Image first = picture("object_0000.png");
    for (const std::string turn : {"object", "light"}) {
        const Outcome rendered = run_burnish(
            {"render", path("saved.json"), "--turntable", "3", "--turn", turn, "--frames", "1",
             "--size", fmt::format("{}x{}", first.width, first.height), "-o", path("r.png")});
        ASSERT_EQ(rendered.exit_code, 0) << rendered.complaint;
        EXPECT_LE(levels_between(picture(turn + "_0001.png"), picture("r_0001.png")), kOneLevel);
        EXPECT_GT(levels_between(picture(turn + "_0001.png"), first), 20) << turn;
    }
}

TEST_F(SavedWindow, TurntableFramesMapsAndModelsAreWritten) {
    play(fmt::format("set samples 1\nwait rest\nturntable 3 {}\nsave gltf {}\n", path("turn.png"),
                     path("exported")),
         {two_materials("two.glb")});
    int frames = 0;
    for (const std::string& name : folder_.names())
        if (name.starts_with("turn") && name.ends_with(".png")) ++frames;
    EXPECT_EQ(frames, 3);
    ASSERT_TRUE(std::filesystem::is_directory(path("exported")));
    EXPECT_FALSE(std::filesystem::is_empty(path("exported")));
    const Outcome refused = run(fmt::format("wait rest\nsave scene {}\n", path("nowhere/a.json")));
    EXPECT_EQ(refused.exit_code, 1);
    expect_parts(refused.complaint, {"line 2", "nowhere/a.json"});
}

}  // namespace
}  // namespace burnish::test
