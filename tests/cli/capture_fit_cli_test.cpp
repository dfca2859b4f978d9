// burnish capture simulate and fit as a person runs them: the files, the words, and stacks that
// cannot be fitted.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <thread>

#include "burnish/image_io.hpp"
#include "burnish/tabulated_file.hpp"
#include "burnish/tabulated_material.hpp"
#include "core/files.hpp"
#include "support/program.hpp"

namespace burnish::test {
namespace {

// A small stack: 8 x 8 pixels, 36 lights.
std::string stack_in(const Folder& folder, const std::string& material = "satin",
                     std::vector<std::string> more = {}) {
    const std::string name = folder.path("stack-" + material);
    std::vector<std::string> arguments = {"capture", "simulate", material, "-o",
                                          name,      "--size",   "8"};
    if (std::find(more.begin(), more.end(), "--lights") == more.end())
        more.insert(more.end(), {"--lights", "6x6"});
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run_burnish(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.complaint;
    return name;
}

Outcome fit(const std::string& rig, const std::string& output, std::vector<std::string> more = {},
            const Surroundings& around = {}) {
    std::vector<std::string> arguments = {"capture", "fit", rig, "-o", output, "--eta", "1.5"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_burnish(arguments, around);
}

void expect_one_line(const Outcome& outcome, int code, const std::string& part) {
    EXPECT_EQ(outcome.exit_code, code);
    EXPECT_EQ(std::count(outcome.complaint.begin(), outcome.complaint.end(), '\n'), 1)
        << outcome.complaint;
    EXPECT_NE(outcome.complaint.find(part), std::string::npos) << outcome.complaint;
}

TEST(CaptureFitCommand, MakesAMaterialAndLeavesNothingElse) {
    const Folder folder;
    const std::string stack = stack_in(folder);
    EXPECT_TRUE(std::filesystem::exists(stack + "/truth/truth.json"));
    EXPECT_TRUE(std::filesystem::exists(stack + "/images/0035.exr"));
    const std::string material = folder.path("material.exr");
    const Outcome outcome = fit(stack + "/rig.json", material, {"--hold-out", "6"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
    for (const char* part :
         {"8 x 8 pixels, 36 lights", "held out", "ward-isotropic", "ashikhmin-shirley"})
        EXPECT_NE(outcome.output.find(part), std::string::npos) << part << " in " << outcome.output;
    EXPECT_FALSE(std::filesystem::exists(material + ".stages"));
    const TabulatedMaterial read = read_tabulated_material(material);
    EXPECT_EQ(read.width, 8);
    EXPECT_TRUE(read.maps.contains("ward.alpha_across"));
    EXPECT_TRUE(read.metadata.contains("burnish:command"));
}

TEST(CaptureFitCommand, StagesOneByOneGiveTheSame) {
    const Folder folder;
    const std::string rig = stack_in(folder) + "/rig.json";
    const std::string whole = folder.path("whole.exr"), parts = folder.path("parts.exr");
    ASSERT_EQ(fit(rig, whole).exit_code, 0);
    for (const char* stage : {"pictures", "exemplars", "texels"}) {
        const Outcome part = fit(rig, parts, {"--until", stage});
        ASSERT_EQ(part.exit_code, 0);
        EXPECT_NE(part.output.find(std::string("stopped after ") + stage), std::string::npos);
        EXPECT_FALSE(std::filesystem::exists(parts));
        EXPECT_TRUE(std::filesystem::exists(parts + ".stages/" + stage + ".bin")) << stage;
    }
    ASSERT_EQ(fit(rig, parts).exit_code, 0);
    const TabulatedMaterial a = read_tabulated_material(whole), b = read_tabulated_material(parts);
    EXPECT_EQ(a.D, b.D);
    EXPECT_EQ(a.angle, b.angle);
    EXPECT_EQ(a.diffuse.pixels, b.diffuse.pixels);
}

TEST(CaptureFitCommand, SaysHowAnInterruptedOneGoesOn) {
    const Folder folder;
    const std::string rig = stack_in(folder, "classes", {"--lights", "16x16"}) + "/rig.json";
    const std::string material = folder.path("m.exr"), pictures = material + ".stages/pictures.bin";
    RunningProgram program({"capture", "fit", rig, "-o", material});
    for (int i = 0; i < 3000 && !std::filesystem::exists(pictures); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    ASSERT_TRUE(std::filesystem::exists(pictures));
    program.send_signal(SIGINT);
    expect_complaint(program.wait(), 130, {"the same command goes on", "m.exr.stages"});
    EXPECT_FALSE(std::filesystem::exists(material));
    EXPECT_TRUE(std::filesystem::exists(pictures));
}

TEST(CaptureFitCommand, EveryFormatOfPicturesFits) {
    const Folder folder;
    for (const char* format : {"png16", "png8"}) {
        const std::string stack =
            stack_in(folder, format[3] == '8' ? "velvet" : "satin", {"--format", format});
        const Outcome outcome = fit(stack + "/rig.json", folder.path("material.exr"));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.complaint;
    }
}

TEST(CaptureFitCommand, SaysWhatAStackCannotSupport) {
    const Folder folder;
    // Under 36 lights its lobes fall between the lights, and turns are a guess.
    const Outcome grain = fit(stack_in(folder, "single-grain", {"--lights", "12x12"}) + "/rig.json",
                              folder.path("a.exr"));
    EXPECT_EQ(grain.exit_code, 0);
    EXPECT_NE(grain.complaint.find("one grain direction"), std::string::npos) << grain.complaint;
    const Outcome above = fit(stack_in(folder, "satin",
                                       {"--camera-tilt", "0", "--rig", "dome", "--lights", "36",
                                        "--camera-distance", "0"}) +
                                  "/rig.json",
                              folder.path("b.exr"));
    EXPECT_NE(above.complaint.find("camera on the normal"), std::string::npos) << above.complaint;
    const Outcome mirror = fit(stack_in(folder, "mirror") + "/rig.json", folder.path("c.exr"));
    EXPECT_TRUE(mirror.complaint.find("narrower than lights") != std::string::npos ||
                mirror.complaint.find("between the lights") != std::string::npos)
        << mirror.complaint;
}

TEST(CaptureFitCommand, RefusesInOneLine) {
    const Folder folder;
    const std::string stack = stack_in(folder), rig = stack + "/rig.json",
                      out = folder.path("m.exr");
    expect_one_line(fit(rig, folder.path("m.png")), 2, ".exr");
    expect_one_line(fit(rig, out, {"--f0", "0.04"}), 2, "--f0");
    expect_one_line(fit(rig, out, {"--grid", "32x95"}), 2, "multiple of 24");
    expect_one_line(fit(rig, out, {"--hold-out", "1"}), 2, "from 2 to 1000");
    expect_one_line(fit(folder.path("none.json"), out), 1, "none.json");
    expect_one_line(fit(stack, out), 1, "a folder; \"" + rig + "\" is one");
    expect_one_line(fit(rig, "/proc/m.exr"), 1, "/proc/m.exr");

    // A picture that ends early, one of another size, and one that is missing.
    const std::string picture = stack + "/images/0007.exr";
    const auto bytes = read_file(picture);
    write_bytes(picture, std::span(bytes).first(bytes.size() / 2));
    expect_one_line(fit(rig, out), 1, "0007.exr");
    write_image(picture, Image(4, 4, 3, 0.5f), {});
    expect_one_line(fit(rig, out), 1, "8 x 8");
    std::filesystem::remove(picture);
    expect_one_line(fit(rig, out), 1, "0007.exr");
    EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(CaptureFitCommand, RefusesStacksWithoutInformation) {
    const Folder folder;
    const std::string stack = stack_in(folder), out = folder.path("m.exr");
    const auto fill = [&](float value) {
        for (const auto& entry : std::filesystem::directory_iterator(stack + "/images"))
            write_image(entry.path(), Image(8, 8, 3, value), {});
    };
    fill(0.0f);
    expect_one_line(fit(stack + "/rig.json", out), 1, "black");
    for (const char* lights : {"1x1", "2x1"}) {
        const std::string few = folder.path(std::string("few") + lights);
        ASSERT_EQ(run_burnish({"capture", "simulate", "satin", "-o", few, "--size", "8", "--lights",
                               lights})
                      .exit_code,
                  0);
        const Outcome outcome = fit(few + "/rig.json", out);
        EXPECT_EQ(outcome.exit_code, 1);
        EXPECT_NE(outcome.complaint.find("at least 3 lights"), std::string::npos)
            << outcome.complaint;
    }
    EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace burnish::test
