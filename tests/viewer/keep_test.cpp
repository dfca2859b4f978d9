// What is remembered from start to start, and scenes of sessions that crashed.
#include "viewer/document/keep.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <ctime>
#include <random>

#include "support/test_folder.hpp"
#include "viewer/document/load_stage.hpp"
#include "viewer/document/save_scene.hpp"

namespace burnish::viewer {
namespace {

using test::ScratchFolder;

TEST(RememberedState, IsReadBackAsItWasWritten) {
    const ScratchFolder folder;
    Remembered state;
    state.width = 1600;
    state.x = -200;
    state.y = 30;
    state.maximized = true;
    state.navigation = Navigation::blender;
    state.touchpad = true;
    state.panels = {{"materials", false}, {"lights", true}};
    add_recent(state, "/models/caf\xc3\xa9 \"1\".glb");
    add_recent(state, "builtin:torus");
    std::vector<std::string> warnings;
    const std::filesystem::path inner = folder / "not/yet/there";
    EXPECT_EQ(load_remembered(inner, warnings), Remembered{});
    save_remembered(inner, state);
    EXPECT_EQ(load_remembered(inner, warnings), state);
    EXPECT_TRUE(warnings.empty());
}

TEST(RememberedState, RecentFilesAreTheLatestTwelve) {
    Remembered state;
    for (int i = 0; i < 20; ++i) add_recent(state, "/m" + std::to_string(i));
    add_recent(state, "/a/../m15");
    ASSERT_EQ(state.recent.size(), kMostRecent);
    EXPECT_EQ(state.recent.front(), "/m15") << "spelled otherwise it is the same file";
    EXPECT_EQ(std::count(state.recent.begin(), state.recent.end(), "/m15"), 1);
    EXPECT_EQ(state.recent.back(), "/m8");
}

TEST(RememberedState, ABrokenFileGivesTheFirstStateAndOneWarning) {
    const ScratchFolder folder;
    const auto warnings_of = [&](const std::string& text) {
        folder.write("view.json", text);
        std::vector<std::string> warnings;
        load_remembered(folder / "", warnings);
        return warnings;
    };
    for (const char* text :
         {"", "{", "[]", "null", R"({"width": "wide"})", R"({"width": 1e99})", R"({"width": -1})",
          R"({"panels": [1]})", R"({"panels": {"a": 1}})", R"({"recent": {"a": 1}})",
          R"({"recent": [1]})", R"({"navigation": "maya"})", R"({"touchpad": 1})",
          R"({"x": 1, "y": "a"})", "{\"recent\": [\"\xff\"]}"}) {
        const std::vector<std::string> warnings = warnings_of(text);
        ASSERT_EQ(warnings.size(), 1u) << text;
        EXPECT_NE(warnings[0].find("view.json"), std::string::npos) << warnings[0];
    }
    EXPECT_TRUE(warnings_of(R"({"of a later version": 3})").empty());
    std::mt19937 random(7);
    for (int i = 0; i < 2000; ++i) {  // damage of all kinds
        std::string text =
            R"({"width": 1280, "panels": {"a": true}, "recent": ["/a", "/b"], "x": 1, "y": 2})";
        for (int j = 0; j < 3; ++j) text[random() % text.size()] = static_cast<char>(random());
        EXPECT_LE(warnings_of(text).size(), 1u);
    }
}

TEST(RememberedState, LiesWhereTheXdgDirectoriesSay) {
    const auto with = [](const char* state, const char* home) {
        state != nullptr ? ::setenv("XDG_STATE_HOME", state, 1) : ::unsetenv("XDG_STATE_HOME");
        home != nullptr ? ::setenv("HOME", home, 1) : ::unsetenv("HOME");
        return state_folder();
    };
    const char* const home = std::getenv("HOME");
    const std::string before = home == nullptr ? "" : home;
    EXPECT_EQ(with("/state", "/home/a"), "/state/burnish");
    EXPECT_EQ(with("relative", "/home/a"), "/home/a/.local/state/burnish");
    EXPECT_EQ(with(nullptr, "/home/a"), "/home/a/.local/state/burnish");
    EXPECT_EQ(with(nullptr, nullptr), "");
    std::vector<std::string> warnings;
    EXPECT_EQ(load_remembered("", warnings), Remembered{});
    EXPECT_TRUE(autosaves_left_behind("").empty());
    remove_autosave("");
    with(nullptr, before.c_str());
}

TEST(Autosave, OfALivingProcessIsNotLeftBehindAndOfADeadOneIs) {
    const ScratchFolder folder;
    Document document{.input = "builtin:plane", .environment = "none"};
    set_parameter(document, "alpha_x", 0.2);
    const Stage stage = load_stage(document);
    autosave(folder / "state", document, stage, "/models/part.glb");
    EXPECT_TRUE(autosaves_left_behind(folder / "state").empty());
    const pid_t child = ::fork();
    if (child == 0) {  // it "crashes": nothing is removed
        try {
            autosave(folder / "state", document, stage, "/models/part.glb");
        } catch (...) {
            ::_exit(1);
        }
        ::_exit(0);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_EQ(status, 0);
    const std::vector<LeftBehind> left = autosaves_left_behind(folder / "state");
    ASSERT_EQ(left.size(), 1u);
    EXPECT_NE(left[0].file.string().find("-" + std::to_string(child) + "-"), std::string::npos);
    EXPECT_EQ(left[0].scene, "/models/part.glb");
    // The offer says what the scene is and when it was kept: now, or the minute before.
    const std::string offer = text_of_offer(left[0]);
    EXPECT_NE(offer.find("/models/part.glb"), std::string::npos) << offer;
    const auto minute = [](std::time_t at) {
        char text[32];
        std::strftime(text, sizeof text, "%Y-%m-%d %H:%M", std::localtime(&at));
        return std::string(text);
    };
    const std::time_t time = std::time(nullptr);
    EXPECT_TRUE(offer.ends_with(minute(time)) || offer.ends_with(minute(time - 60))) << offer;
    StageRequest request;
    request.input = left[0].file.string();
    EXPECT_EQ(stated_alpha(set_stage(request).scene.materials.at(0)), glm::vec2(0.2f));
    remove_autosave(folder / "state");
    EXPECT_FALSE(std::filesystem::exists(autosave_path(folder / "state")));
    EXPECT_EQ(autosaves_left_behind(folder / "state").size(), 1u);
}

TEST(Autosave, ARecoveredSceneHasItsFormerNameUntilItIsSaved) {
    const ScratchFolder folder;
    Document document{.input = "builtin:plane", .environment = "none"};
    Stage stage = load_stage(document);
    EXPECT_EQ(scene_name(document, stage).path, "builtin:plane");
    EXPECT_FALSE(scene_name(document, stage).recovered);
    for (int crash = 0; crash < 2; ++crash) {  // the second one is of a recovered scene
        const std::string name =
            crash == 0 ? "/models/a \"part\".glb" : scene_name(document, stage).path;
        autosave(folder / "state", document, stage, name);
        document = {.input = autosave_path(folder / "state").string()};
        stage = load_stage(document);
        EXPECT_EQ(scene_name(document, stage).path, "/models/a \"part\".glb");
        EXPECT_TRUE(scene_name(document, stage).recovered);
    }
    save_scene(document, stage, folder / "saved.json");
    document = {.input = (folder / "saved.json").string()};
    EXPECT_FALSE(scene_name(document, load_stage(document)).recovered);
}

TEST(Autosave, SavingProposesTheNameOfTheSceneThatIsRecovered) {
    EXPECT_EQ(proposed_scene_file({"/rooms/lamp.json", true}), "/rooms/lamp.json");
    EXPECT_EQ(proposed_scene_file({"/rooms/lamp.json", false}), "/rooms/lamp.json");
    // A model is never written over.
    EXPECT_EQ(proposed_scene_file({"/models/part.v2.glb", true}), "/models/part.v2.json");
    EXPECT_EQ(proposed_scene_file({"builtin:torus", true}), "scene.json");
    EXPECT_EQ(proposed_scene_file({}), "scene.json");
}

TEST(Autosave, ANumberOfAProcessThatIsUsedAgainDoesNotHideAScene) {
    const ScratchFolder folder;
    // This process lives, but it did not start at 1.
    std::string name = autosave_path(folder / "").filename().string();
    name = name.substr(0, name.rfind('-')) + "-1.json";
    folder.write(name, "{}");
    folder.write("autosave-x.json", "{}");
    folder.write("autosave-other-host-1-1.json", "{}");
    folder.write("view.json", "{}");
    const std::vector<LeftBehind> left = autosaves_left_behind(folder / "");
    ASSERT_EQ(left.size(), 1u);
    EXPECT_EQ(left[0].file.filename(), name);
}

}  // namespace
}  // namespace burnish::viewer
