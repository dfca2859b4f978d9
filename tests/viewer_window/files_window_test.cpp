// Files in the window: opened, missing, broken, changed and deleted while they are open.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <thread>

#include "burnish/context.hpp"
#include "support/glb_writer.hpp"
#include "viewer_window/display.hpp"

namespace burnish::test {
namespace {

std::string text_of(const std::vector<std::byte>& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

TEST_F(ViewerWindow, FilesOfAllKindsAreOpenedIntoTheScene) {
    const std::string model = two_materials("two.glb");
    folder_.write("sky.png", text_of(png_gradient(64, 32)));
    folder_.write("part_normal.png", text_of(png_gradient(32, 32)));
    play(
        fmt::format("set samples 1\nopen builtin:cylinder\nwait rest\nexpect materials = 1\n"
                    "open {}\nwait rest\nexpect materials = 2\nopen {}\nwait rest\nopen {}\n"
                    "wait rest\nundo 3\nwait rest\nexpect materials = 1\nredo\nwait rest\n"
                    "expect materials = 2\nenvironment builtin:studio\nwait rest\n"
                    "environment none\nwait rest\n",
                    model, path("sky.png"), path("part_normal.png")));
}

// A rig without a material beside it is fitted first.
TEST_F(ViewerWindow, ARigIsFittedAndItsMaterialShown) {
    const std::string stack = path("stack");
    const Outcome made = run_burnish(
        {"capture", "simulate", "isotropic", "-o", stack, "--size", "8", "--lights", "6x5"});
    ASSERT_EQ(made.exit_code, 0) << made.complaint;
    const std::map<std::string, std::string> seen =
        play(fmt::format("set samples 1\nwait rest\nopen {}\nwait rest\nlog tabulated\n",
                         stack + "/rig.json"),
             {"--state", path("state")});
    const std::string& material = seen.at("tabulated");
    EXPECT_TRUE(material.starts_with(path("state") + "/captures/stack-")) << material;
    EXPECT_TRUE(std::filesystem::is_regular_file(material));
}

TEST_F(ViewerWindow, AMissingOrBrokenFileIsSaidAndTheSessionGoesOn) {
    folder_.write("broken.glb", "glTF, but not really");
    play(fmt::format(
        "set samples 1\nopen {0}\nexpect error = \"missing.glb\"\nopen {1}\n"
        "expect error = \"broken.glb\"\nenvironment {0}\nexpect error = \"missing.glb\"\n"
        "wait rest\nexpect materials = 1\nexpect undo_count = 1\n",
        path("missing.glb"), path("broken.glb")));
    // Without an `expect error` the script ends there.
    const Outcome outcome = run("wait rest\nopen " + path("broken.glb") + "\nwait rest\n");
    EXPECT_EQ(outcome.exit_code, 1);
    expect_parts(outcome.complaint, {"script.txt: line 2", "broken.glb"});
}

TEST_F(ViewerWindow, AMissingFileOfTheCommandLineIsSaidOverTheFirstScene) {
    const std::string missing = path("missing.glb");
    const Outcome outcome = run("wait rest\n", {missing});
    EXPECT_EQ(outcome.exit_code, 1);
    expect_parts(outcome.complaint, {"burnish: ", "missing.glb", "expected a file"});
    play("expect error = missing.glb\nset samples 1\nwait rest\nexpect materials = 1\n", {missing});
}

TEST_F(ViewerWindow, AFileThatIsDeletedStaysOpen) {
    const std::string model = two_materials("two.glb");
    // The script deletes nothing itself: another process does, after the file was read.
    std::thread deletes([&] {
        for (int i = 0; i < 1000 && !std::filesystem::exists(path("read.png")); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        std::filesystem::remove(model);
    });
    const auto logged = play(
        fmt::format(
            "set samples 1\nwait rest\nwait seconds 1.2\nscreenshot {}\nwait seconds 2.5\n"
            "set roughness 0.3\nwait rest\nexpect materials = 2\nlog message title missing_files\n"
            "save scene {}\nset alpha_x 0.2\nundo\nwait rest\n",
            path("read.png"), path("kept.json")),
        {model});
    deletes.join();
    EXPECT_FALSE(std::filesystem::exists(model));
    EXPECT_EQ(logged.at("missing_files"), "two.glb is gone from disk: what was read stays");
    EXPECT_EQ(logged.at("message"), logged.at("missing_files"));
    EXPECT_EQ(logged.at("title"), "two.glb (gone from disk)");
}

TEST_F(ViewerWindow, AFolderOfMapsSaysWhatItTakesBack) {
    std::filesystem::create_directory(path("rust"));
    folder_.write("rust/rust_Color.png", text_of(png_gradient(16, 16)));
    const auto logged = play(
        fmt::format("set samples 1\nset metal copper\nset scratch fine-random\nwait rest\nopen {}\n"
                    "wait rest\nlog message\nexpect metal = none\nundo\nexpect metal = copper\n",
                    path("rust")),
        {"builtin:plane"});
    EXPECT_NE(logged.at("message").find("metal and scratch were taken back"), std::string::npos)
        << logged.at("message");
}

TEST_F(ViewerWindow, AFileThatChangesIsReadAgain) {
    const std::string model = two_materials("two.glb");
    const std::string other = two_materials("other.glb", png_gradient(16, 16));
    std::thread changes([&] {
        for (int i = 0; i < 1000 && !std::filesystem::exists(path("before.png")); ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(20));
        std::filesystem::rename(other, model);
    });
    play(
        fmt::format("set samples 2\nset roughness 0.9\nwait rest\nwait seconds 1.2\nscreenshot {}\n"
                    "wait seconds 2.5\nwait rest\nscreenshot {}\nexpect undo_count = 2\n",
                    path("before.png"), path("after.png")),
        {model});
    changes.join();
    // The left sphere has a texture now.
    EXPECT_GT(levels_between(picture("before.png"), picture("after.png")), 50.0);
}

// Mesa's software renderer takes 16384 texels a side; readers take 32768.
TEST_F(ViewerWindow, ATextureLargerThanTheDeviceTakesIsSaidAndTheSessionIsKept) {
    if (gpu::Context().max_texture_size() >= 20000)
        GTEST_SKIP() << "this device takes 20000 texels a side";
    const std::string model = two_materials("large.glb", png_gradient(20000, 1));
    const Outcome outcome = run("set samples 1\nwait rest\nexpect materials = 2\n", {model});
    EXPECT_EQ(outcome.exit_code, 1) << outcome.complaint;
    expect_parts(outcome.complaint, {"at most", "pixels a side on this device", "20000"});
    // The picture stays what it was, and the session goes on.
    play(
        fmt::format("panel parameters off\npanel scene off\nset samples 1\nwait rest\nwait 2\n"
                    "screenshot {1}\nopen {0}\nexpect error = 20000\nwait 5\nscreenshot {2}\n"
                    "undo\nwait rest\nexpect materials = 1\nset roughness 0.2\nwait rest\n",
                    model, path("before.png"), path("refused.png")));
    EXPECT_EQ(levels_between(picture("before.png"), picture("refused.png"), 450), 0.0);
}

}  // namespace
}  // namespace burnish::test
