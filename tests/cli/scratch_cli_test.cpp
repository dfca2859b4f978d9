// burnish scratch as a person runs it: files, round trip, contradictions, interrupted writes.
#include <gtest/gtest.h>

#include <algorithm>

#include "burnish/image_io.hpp"
#include "jobs/maps/scratch.hpp"
#include "support/program.hpp"

namespace burnish::test {
namespace {

const std::vector<std::string> kFiles = {"anisotropy.png", "direction.png", "height.exr",
                                         "height.png",     "moments.exr",   "normal.png",
                                         "preview.png",    "scratch.json"};

Outcome scratch(std::vector<std::string> arguments, const Surroundings& around = {}) {
    arguments.insert(arguments.begin(), "scratch");
    return run_burnish(arguments, around);
}

std::vector<std::string> names_in(const std::string& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

TEST(ScratchCommand, WritesTheMapsAndMakesThemAgainFromTheirFolder) {
    const Folder folder;
    const std::string first = folder.path("first"), second = folder.path("second");
    const Outcome outcome =
        scratch({"--preset", "tool-marks", "--size", "128", "--strength", "1.5", "--add-layer",
                 "count=5,length=9,width=0.4,profile=burr", "-o", first});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
    EXPECT_EQ(names_in(first), kFiles);
    ASSERT_EQ(scratch({"--settings", first, "-o", second}).exit_code, 0);
    EXPECT_EQ(read_image(first + "/height.exr").pixels, read_image(second + "/height.exr").pixels);
    EXPECT_EQ(load_scratch_recipe(first).settings, load_scratch_recipe(second).settings);

    // The 16-bit heights and the float ones are one surface: half a code apart.
    const Image exact = read_image(first + "/height.exr");
    const Image codes = read_image(first + "/height.png", {.as_data = true});
    const auto [low, high] = std::minmax_element(exact.pixels.begin(), exact.pixels.end());
    for (std::size_t i = 0; i < exact.pixels.size(); ++i)
        ASSERT_NEAR(
            *low + codes.pixels[i * static_cast<std::size_t>(codes.channels)] * (*high - *low),
            exact.pixels[i], 0.51f / 65535 * (*high - *low) + 1e-8f);
}

TEST(ScratchCommand, NamesWhatContradictsItself) {
    const Folder folder;
    const std::string out = folder.path("out");
    const auto refused = [&](std::vector<std::string> arguments, int code,
                             const std::vector<std::string>& parts) {
        arguments.insert(arguments.end(), {"-o", out});
        expect_complaint(scratch(arguments), code, parts);
    };
    refused({"--preset", "brushd"}, 2, {"brushed"});
    refused({"--preset", "brushed", "--settings", "x"}, 2, {"not both"});
    refused({"--count", "5", "--density", "5"}, 2, {"not both"});
    refused({"--width", "0.1", "--depth", "0.2"}, 2, {"depth_mm", "half the width"});
    refused({"--range", "10"}, 2, {"range_deg", "random"});
    refused({"--direction", "image"}, 2, {"direction image"});
    refused({"--double-angle"}, 2, {"--direction-image"});
    refused({"--length", "5mm"}, 2, {"--length", "5mm"});
    refused({"--size", "20000"}, 2, {"size", "16384"});
    refused({"--add-layer", "count=1,count=2"}, 2, {"twice"});
    refused({"--add-layer", "width=1"}, 2, {"count or a density"});
    refused({"--settings", folder.path("none")}, 1, {"none", "no such file"});
    refused({"--settings", folder.write("bad.json", R"({"format":"burnish-scratch","version":1,
            "layers":[{"count":3,"widht_mm":1}]})")},
            1, {"layers[0]", "widht_mm", "width_mm"});
    EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(ScratchCommand, RefusesMasksAndDirectionsThatDoNotFit) {
    const Folder folder;
    const std::string wide = folder.path("wide.png"), gray = folder.path("grey.png");
    write_image(wide, Image(32, 16, 1, 1.0f), {});
    write_image(gray, Image(16, 16, 1, 1.0f), {});
    expect_complaint(scratch({"--wear-mask", wide, "-o", folder.path("a")}), 1,
                     {"wide.png", "square", "32x16"});
    expect_complaint(scratch({"--direction-image", gray, "-o", folder.path("a")}), 1,
                     {"grey.png", "channels", "1"});
    expect_complaint(scratch({"-o", gray}), 1, {"grey.png", "folder"});
    expect_complaint(scratch({"-o", folder.path("no/such")}), 1, {"no/such", "folder"});
    EXPECT_FALSE(std::filesystem::exists(folder.path("a")));
}

TEST(ScratchCommand, AFailedWriteLeavesTheOldMapsWhole) {
    const Folder folder;
    const std::string out = folder.path("out");
    ASSERT_EQ(scratch({"--preset", "brushed", "--size", "64", "-o", out}).exit_code, 0);
    std::vector<std::string> before;
    for (const std::string& name : kFiles) before.push_back(contents_of(out + "/" + name));
    // The moments, 5 floats a texel, do not fit into half a megabyte; earlier files do.
    const Outcome outcome = scratch({"--preset", "fine-random", "--size", "256", "-o", out},
                                    {.file_size_limit = 500000});
    EXPECT_EQ(outcome.exit_code, 1) << outcome.complaint;
    EXPECT_EQ(names_in(out), kFiles);
    for (std::size_t i = 0; i < kFiles.size(); ++i)
        EXPECT_TRUE(contents_of(out + "/" + kFiles[i]) == before[i]) << kFiles[i];
}

TEST(ScratchCommand, RenderTakesPresetsAndFoldersOrSaysWhatItTakes) {
    const Folder folder;
    expect_complaint(run_burnish({"render", "builtin:plane", "--scratch", folder.path("none"), "-o",
                                  folder.path("a.png")}),
                     2, {"scratch", "swirl-marks"});
    expect_complaint(run_burnish({"render", "builtin:plane", "--scratch", "brushed", "--normal-map",
                                  "builtin:bumps", "-o", folder.path("a.png")}),
                     2, {"not both"});
}

}  // namespace
}  // namespace burnish::test
