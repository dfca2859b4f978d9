// What a person does in the window, done by scripts: values, undo, drags, picks, views, panels, keys.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <string_view>

#include "burnish/render_settings.hpp"
#include "viewer_window/display.hpp"

namespace burnish::test {
namespace {

// Whether any two pixels of the picture differ by more than a tenth of white.
bool shows_something(const Image& image) {
    const auto [low, high] = std::minmax_element(image.pixels.begin(), image.pixels.end());
    return *high - *low > 0.1f;
}

TEST_F(ViewerWindow, TheFirstStartShowsASphereAndRestsAtItsSamples) {
    play(
        fmt::format("set samples 4\nwait rest\nexpect drawn_samples = 4\nexpect warnings = 0\n"
                    "expect undo_count = 1\nscreenshot {}\n",
                    path("first.png")));
    const Image shot = picture("first.png");
    EXPECT_EQ(shot.width, 640);
    EXPECT_EQ(shot.height, 480);
    EXPECT_TRUE(shows_something(shot));
}

TEST_F(ViewerWindow, ValuesAreSetUnsetUndoneAndDoneAgain) {
    play(
        "set samples 4\nset method normal-map\nset alpha_x 0.3\nset alpha_y 0.1\n"
        "expect alpha_x = 0.3 1e-6\nexpect undo_count = 4\n"
        "undo 2\nexpect alpha_x != 0.3\nexpect redo_count = 2\nexpect method = normal-map\n"
        "redo 2\nexpect alpha_y = 0.1 1e-6\nunset alpha_y\nexpect undo_count = 5\n"
        "undo 5\nexpect undo_count = 0\nwait rest\n",
        {"builtin:torus"});
}

TEST_F(ViewerWindow, AMaterialOfTheModelTakesValuesOfItsOwn) {
    play(
        "set samples 2\nexpect materials = 2\nset roughness 0.2 right\nset roughness 0.7 #0\n"
        "wait rest\nset roughness 0.2 nobody\nexpect error = \"expected a material of the scene\"\n"
        "expect undo_count = 3\n",
        {two_materials("two.glb")});
}

TEST_F(ViewerWindow, EveryDragChangesWhatItShouldInOneStep) {
    constexpr std::array kKinds = {"orbit", "pan", "zoom", "light", "environment"};
    std::string script = fmt::format(
        "set samples 1\nset image_light prefiltered\nlight 20,40,2\npanel parameters off\n"
        "panel scene off\nwait rest\nscreenshot {}\n",
        path("before.png"));
    for (const char* kind : kKinds)
        script += fmt::format(
            "drag {0} 40 25 6\nwait rest\nexpect undo_count = 4\nscreenshot {1}\nundo\n"
            "expect undo_count = 3\nwait rest\nscreenshot {2}\n",
            kind, path(fmt::format("{}.png", kind)), path(fmt::format("{}_undone.png", kind)));
    play(script, {"builtin:torus"});
    const Image before = picture("before.png");
    for (const std::string kind : kKinds) {
        // A fifth of white at least somewhere: the picture moves. Undone, only the status bar differs.
        EXPECT_GT(levels_between(before, picture(kind + ".png"), 430), 50.0) << kind;
        EXPECT_EQ(levels_between(before, picture(kind + "_undone.png"), 430), 0.0) << kind;
    }
}

TEST_F(ViewerWindow, APickTellsTheLobeAndTheBackgroundIsRefused) {
    const auto logged = play(
        "panel parameters off\npanel scene off\nset samples 2\nlight 0,30\nwait rest\npick 320 "
        "240\nexpect picked.D > 0\n"
        "expect picked.follow-grain.highlight_error >= 0\nlog picked.tilt picked.f\n"
        "pick 12 34\nexpect error = \"found the background\"\npanel inspector off\nwait 2\nclick "
        "320 250\nexpect picked.D > 0\n"
        "click 330 240 shift\nwait rest\n",
        {"builtin:sphere"});
    EXPECT_EQ(logged.count("picked.f"), 1u);
}

TEST_F(ViewerWindow, EveryWayToCompareIsShown) {
    const auto logged = play(fmt::format(
        "set samples 2\nwait rest\ncompare split normal-map rotate-approx follow-grain "
        "deform-smooth\nwait rest\nscreenshot {}\n"
        "compare blink\nwait 5\ncompare difference normal-map follow-grain\nwait rest\nwait 2\n"
        "expect difference > 0\nlog difference\ncompare flip\nwait rest\nwait 2\nexpect flip > 0\n"
        "log flip\ncompare off\nwait rest\n",
        path("split.png")));
    EXPECT_TRUE(shows_something(picture("split.png")));
    EXPECT_EQ(logged.count("flip"), 1u);
}

TEST_F(ViewerWindow, EveryViewIsShown) {
    std::string script =
        "set samples 1\nset image_light prefiltered\nset normal_map builtin:bumps\n"
        "panel parameters off\npanel scene off\nwait rest\n";
    for (const std::string_view name : surface_view_names())
        script += fmt::format("view {}\nwait rest\nscreenshot {}\n", name,
                              path(std::string(name) + ".png"));
    play(script, {"builtin:torus"});
    const Image radiance = picture(std::string(surface_view_names().front()) + ".png");
    for (std::size_t i = 1; i < surface_view_names().size(); ++i) {
        const std::string name(surface_view_names()[i]);
        EXPECT_GT(levels_between(radiance, picture(name + ".png")), 20.0) << name;
    }
    const Outcome outcome = run("wait rest\nview normals\n");
    EXPECT_EQ(outcome.exit_code, 1);
    expect_parts(outcome.complaint, {"line 2", "expected a view (radiance"});
}

TEST_F(ViewerWindow, ThePassesAreTimedWhileTheirPanelIsOpen) {
    play(
        "set samples 4\nlight 20,40,2\nwait rest\nexpect cost.frame > 0\n"
        "expect error = \"expected the panel costs open\"\npanel costs on\nwait rest\nwait 3\n"
        "expect cost.shadow-maps > 0\nexpect cost.shading > 0\nexpect cost.sum > 0\n"
        "expect cost.display > 0\nexpect cost.interface > 0\nexpect cost.frame > 0\n"
        "expect cost.nothing > 0\nexpect error = \"expected a measurement\"\n"
        "panel costs off\nlog cost.sum\nexpect error = \"expected the panel costs open\"\n",
        {"builtin:torus"});
}

TEST_F(ViewerWindow, EveryPanelOpensAndEveryKeyDoesSomething) {
    std::string script = "set samples 1\nset image_light prefiltered\nwait 3\npick 320 240\n";
    for (const char* panel :
         {"parameters", "scene", "compare", "inspector", "messages", "keys", "costs", "generator"})
        script += fmt::format("panel {} on\nwait 2\n", panel);
    script += "panel keys off\n";
    for (const char* key : {"f", "home", "t",   "t", "m",      "c",      "c",
                            "c", "c",    "c",   "v", "g",      "g",      "[",
                            "]", "tab",  "tab", "1", "2",      "3",      "4",
                            "5", "6",    "?",   "?", "ctrl+z", "ctrl+y", "ctrl+shift+c",
                            "f5"})
        script += fmt::format("key {}\nwait 2\n", key);
    play(script +
             "set samples 1\nwait rest\nresize 400x300\nwait rest\nexpect window_width = 400\n"
             "resize 900x700\nwait rest\nexpect window_height = 700\n",
         {"builtin:torus"});
    const Outcome outcome = run("wait rest\nkey ctrl+x\n");
    EXPECT_EQ(outcome.exit_code, 1);
    expect_parts(outcome.complaint, {"line 2", "expected a key of the list under ?"});
}

}  // namespace
}  // namespace burnish::test
