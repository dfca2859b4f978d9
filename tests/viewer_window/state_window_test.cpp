// Starts and ends: no display, wrong scripts and flags, what is remembered, what a crash leaves.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "viewer_window/display.hpp"

namespace burnish::test {
namespace {

TEST_F(ViewerWindow, WithoutADisplayOneLineSaysSo) {
    expect_complaint(run_with({"--state", "none"}, ""), 1,
                     {"display", "DISPLAY", "burnish render"});
    expect_complaint(run_with({"--state", "none"}, ":7654"), 1, {"display"});
}

TEST_F(ViewerWindow, AWrongLineIsNamedBeforeAWindowOpens) {
    expect_complaint(run("wait rest\nset alhpa_x 0.3\n"), 1,
                     {"script.txt: line 2", "expected", "did you mean 'alpha_x'"});
    expect_complaint(run("jump\n"), 1,
                     {"script.txt: line 1", "expected a command", "found \"jump\""});
    expect_complaint(run("set alpha_x 7\n"), 1, {"script.txt: line 1", "found \"7\""});
    expect_complaint(run("log\n"), 1, {"script.txt: line 1", "the name of a value"});
    expect_complaint(run_with({"--script", path("none.txt")}, virtual_display()), 1, {"none.txt"});
}

TEST_F(ViewerWindow, AnExpectationThatDoesNotHoldEndsTheScript) {
    expect_complaint(run("set samples 1\nwait rest\n# a comment\nexpect drawn_samples = 2\n"), 1,
                     {"script.txt: line 4", "expected drawn_samples = 2, found 1"});
    expect_complaint(run("wait 1\nexpect smaples = 2\n"), 1,
                     {"line 2", "expected a measurement or a parameter", "found \"smaples\""});
    expect_complaint(run("wait 1\nexpect error = anything\n"), 1, {"line 2", "expected an error"});
    expect_complaint(run("wait 1\nexpect picked.D > 0\n"), 1,
                     {"line 2", "expected a picked point"});
}

TEST_F(ViewerWindow, WrongFlagsAreUsageErrors) {
    for (const std::vector<std::string>& flags : {std::vector<std::string>{"--size", "1280"},
                                                  {"--size", "10x10"},
                                                  {"--ui-scale", "9"},
                                                  {"--size", "640x480x3"},
                                                  {"--wrong"}})
        expect_complaint(run_with(flags, virtual_display()), 2, {flags.front()});
}

TEST_F(ViewerWindow, TheWindowAndItsFilesAreRemembered) {
    const std::string state = path("state");
    play("resize 700x500\nwait 2\nopen builtin:torus\nset samples 1\nwait rest\n",
         {"--state", state});
    const auto json = nlohmann::json::parse(contents_of(state + "/view.json"));
    EXPECT_EQ(json["width"], 700);
    EXPECT_EQ(json["height"], 500);
    EXPECT_EQ(json["recent"].at(0), "builtin:torus");
    const std::string script = folder_.write(
        "again.txt", "wait 2\nexpect window_width = 700\nexpect window_height = 500\n");
    const Outcome again = run_with({"--state", state, "--script", script}, virtual_display());
    EXPECT_EQ(again.exit_code, 0) << again.complaint;
    folder_.write("state/view.json", "{\"width\": \"wide\"}");
    const Outcome broken =
        run_with({"--state", state, "--script", path("wait.txt")}, virtual_display());
    EXPECT_EQ(broken.exit_code, 1);  // no such script: the state is not even read
    play("wait 2\nset samples 1\nwait rest\n", {"--state", state});
}

// What crashed sessions have left in a folder of states.
class CrashedWindow : public ViewerWindow {
  protected:
    std::string state() const { return path("state"); }
    std::vector<std::string> autosaved() const {
        std::vector<std::string> found;
        std::error_code error;
        for (const auto& entry : std::filesystem::directory_iterator(state(), error))
            if (entry.path().filename().string().starts_with("autosave-") &&
                entry.path().extension() == ".json")
                found.push_back(entry.path().string());
        return found;
    }
    // A window in which something was changed, killed as soon as that is kept.
    void crash() {
        const std::string script =
            folder_.write("work.txt", "set samples 1\nset alpha_x 0.37\nwait seconds 90\n");
        RunningViewer viewer({"--size", "320x240", "--state", state(), "--script", script});
        for (int i = 0; i < 2000 && autosaved().empty(); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        viewer.kill();
        ASSERT_EQ(autosaved().size(), 1u);
    }
    void expect_recovered() {
        play(fmt::format("wait rest\nexpect recovered = 1\nrecover open\nset samples 1\nwait rest\n"
                         "save scene {}\n",
                         path("recovered.json")),
             {"--state", state()});
        EXPECT_NE(contents_of(path("recovered.json")).find("0.37"), std::string::npos);
    }
};

TEST_F(CrashedWindow, WhatACrashLeavesIsOpenedAndThenGone) {
    crash();
    const auto logged =
        play(fmt::format("wait rest\nexpect recovered = 1\nrecover open\nset samples 1\nwait rest\n"
                         "expect alpha_x = 0.37\nlog title\nsave scene {}\nrecover open\n"
                         "expect error = \"no scene of an earlier session\"\n",
                         path("recovered.json")),
             {"--state", state()});
    EXPECT_NE(contents_of(path("recovered.json")).find("0.37"), std::string::npos);
    EXPECT_EQ(logged.at("title"), "builtin:sphere (recovered)");
    EXPECT_TRUE(autosaved().empty()) << "an orderly end removes what was recovered";
    play("wait rest\nexpect recovered = 0\n", {"--state", state()});
}

TEST_F(CrashedWindow, WhatACrashLeavesStaysUntilItIsDeclined) {
    crash();
    const std::vector<std::string> left = autosaved();
    play("wait rest\nexpect recovered = 1\nrecover later\nset samples 1\nwait rest\n",
         {"--state", state()});
    EXPECT_EQ(autosaved(), left);  // an orderly end removes its own alone
    play("wait rest\nexpect recovered = 1\nrecover delete\n", {"--state", state()});
    EXPECT_TRUE(autosaved().empty());
}

// A recovered scene that crashes again is not lost.
TEST_F(CrashedWindow, ARecoveredSceneIsStillThereAfterAnotherCrash) {
    crash();
    {
        const std::string script = folder_.write(
            "again.txt", fmt::format("wait rest\nrecover open\nset samples 1\nwait rest\n"
                                     "screenshot {}\nwait seconds 90\n",
                                     path("open.png")));
        RunningViewer viewer({"--size", "320x240", "--state", state(), "--script", script});
        for (int i = 0; i < 2000 && !std::filesystem::exists(path("open.png")); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        viewer.kill();
    }
    EXPECT_GE(autosaved().size(), 1u);
    expect_recovered();
}

// The drivers of this machine lose no context: the window is told that it has. The scene is kept.
TEST_F(CrashedWindow, ADeviceThatIsResetEndsTheWindowAndTheSceneIsKept) {
    const Outcome outcome =
        run("set samples 1\nset alpha_x 0.37\nwait rest\nsimulate device-reset\n"
            "wait rest\n",
            {"--state", state()});
    expect_complaint(outcome, 1, {"graphics device", "reset", "the next start offers it"});
    ASSERT_EQ(autosaved().size(), 1u);
    expect_recovered();
    expect_complaint(run("wait rest\nsimulate device-reset\nwait rest\n", {"builtin:torus"}), 1,
                     {"graphics device", "nothing was changed"});
}

}  // namespace
}  // namespace burnish::test
