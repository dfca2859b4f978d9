// burnish weave and burnish info of drafts as a person runs them: files, round trip,
// contradictions, interrupted writes.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <thread>

#include "burnish/image_io.hpp"
#include "burnish/wif.hpp"
#include "support/paths.hpp"
#include "support/program.hpp"

namespace burnish::test {
namespace {

const std::vector<std::string> kFiles = {"color.png",  "direction.png", "draft.wif",
                                         "height.exr", "height.png",    "id.png",
                                         "normal.png", "preview.png",   "weave.json"};

const std::string kExamples = test::source_folder().string() + "/examples/weaves/";

Outcome weave(std::vector<std::string> arguments, const Surroundings& around = {}) {
    arguments.insert(arguments.begin(), "weave");
    return run_burnish(arguments, around);
}

std::vector<std::string> names_in(const std::string& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

TEST(WeaveCommand, WritesTheMapsAndTheirDraftMakesThemAgain) {
    const Folder folder;
    const std::string first = folder.path("first"), second = folder.path("second");
    const Outcome outcome = weave({kExamples + "houndstooth.wif", "--size", "128", "--repeats",
                                   "1,2", "--weave-twist", "-30", "-o", first});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.complaint;
    EXPECT_EQ(outcome.complaint,
              "burnish: note: process: embossed (render with --process embossed)\n");
    EXPECT_EQ(names_in(first), kFiles);
    ASSERT_EQ(weave({first + "/draft.wif", "--size", "128x256", "--repeats", "1,2", "--weave-twist",
                     "-30", "-o", second})
                  .exit_code,
              0);
    for (const char* name : {"height.exr", "normal.png", "direction.png", "color.png", "id.png"}) {
        const Image a = read_image(first + "/" + name, {.as_data = true});
        EXPECT_EQ(a.width, 128) << name;
        EXPECT_EQ(a.height, 256) << name;  // 8 ends and 16 picks: square texels
        EXPECT_EQ(a.pixels, read_image(second + "/" + name, {.as_data = true}).pixels) << name;
    }
    // The 16-bit heights and the float ones are one surface: half a code apart.
    const Image exact = read_image(first + "/height.exr");
    const Image codes = read_image(first + "/height.png", {.as_data = true});
    const auto [low, high] = std::minmax_element(exact.pixels.begin(), exact.pixels.end());
    for (std::size_t i = 0; i < exact.pixels.size(); ++i)
        ASSERT_NEAR(
            *low + codes.pixels[i * static_cast<std::size_t>(codes.channels)] * (*high - *low),
            exact.pixels[i], 0.51f / 65535 * (*high - *low) + 1e-8f);
}

TEST(WeaveCommand, ColorsComeBackAsTheFileHasThem) {
    const Folder folder;
    const std::string out = folder.path("out");
    ASSERT_EQ(weave({kExamples + "houndstooth.wif", "--size", "128", "-o", out}).exit_code, 0);
    // The example's palette, by hand: 34,32,36 and 232,226,212 of 255; black in holes.
    const Image colors = read_image(out + "/color.png", {.as_data = true});
    int dark = 0, light = 0, holes = 0;
    for (std::size_t i = 0; i < colors.pixels.size(); i += 3) {
        const auto code = [&](std::size_t c) {
            return static_cast<int>(std::lround(colors.pixels[i + c] * 255.0f));
        };
        const std::vector<int> rgb = {code(0), code(1), code(2)};
        dark += rgb == std::vector<int>{34, 32, 36};
        light += rgb == std::vector<int>{232, 226, 212};
        holes += rgb == std::vector<int>{0, 0, 0};
    }
    EXPECT_EQ(dark + light + holes, 128 * 128);
    EXPECT_NEAR(dark, light, 128 * 128 / 50);  // houndstooth is as dark as it is light
    // Marked as color, so that a viewer and our own renderer take it for that.
    EXPECT_NEAR(read_image(out + "/color.png").pixels[0], linear_from_srgb(colors.pixels[0]),
                1e-6f);
}

TEST(WeaveCommand, AColorAskedForTakesThePlaceOfTheDrafts) {
    const Folder folder;
    const std::string out = folder.path("out");
    ASSERT_EQ(weave({kExamples + "houndstooth.wif", "--size", "128", "--warp-color", "#ff0000",
                     "--weft-color", "#0000ff", "-o", out})
                  .exit_code,
              0);
    const Image colors = read_image(out + "/color.png", {.as_data = true});
    for (std::size_t i = 0; i < colors.pixels.size(); i += 3) {
        ASSERT_EQ(colors.pixels[i + 1], 0.0f);
        ASSERT_LE(colors.pixels[i] + colors.pixels[i + 2], 1.0f);
    }
    EXPECT_TRUE(read_wif(out + "/draft.wif").draft.warp_colors.empty());
}

TEST(WeaveCommand, InfoTellsWhatADraftHolds) {
    const Outcome info = run_burnish({"info", kExamples + "satin-stripe.wif"});
    ASSERT_EQ(info.exit_code, 0) << info.complaint;
    for (const char* part : {"\"Satin stripe\"", "32 ends, 4 picks, 8 shafts, 4 treadles",
                             "2 colors", "warp over 3 picks", "weft over 3 ends", "50.0 %",
                             "    .###.###.###.###...#...#...#...#\n"})
        EXPECT_NE(info.output.find(part), std::string::npos) << part << "\n" << info.output;
}

TEST(WeaveCommand, NamesWhatCannotBe) {
    const Folder folder;
    const std::string out = folder.path("out");
    const auto refused = [&](std::vector<std::string> arguments, int code,
                             const std::vector<std::string>& parts) {
        arguments.insert(arguments.end(), {"-o", out});
        expect_complaint(weave(arguments), code, parts);
    };
    refused({"herringbon"}, 2, {"weave", "herringbon", "did you mean 'herringbone'"});
    refused({folder.path("none.wif")}, 1, {"none.wif", "no such file"});
    refused({folder.write("bad.wif", "[WIF]\n[WARP]\nThreads=0\n")}, 1,
            {"bad.wif: [WARP] Threads, line 3", "from 1 to 65536", "\"0\""});
    refused({"plain", "--size", "8"}, 2, {"--size", "16 to 16384", "8"});
    refused({"plain", "--size", "64x"}, 2, {"--size"});
    refused({"plain", "--size", "20000"}, 2, {"--size", "16384"});
    refused({"plain", "--repeats", "0"}, 2, {"--repeats", "1 to 4096"});
    refused({"plain", "--repeats", "2,"}, 2, {"--repeats"});
    refused({"plain", "--size", "64", "--repeats", "32"}, 2, {"plain", "4 texels", "ends"});
    refused({"plain", "--yarn-mm", "0"}, 2, {"yarn_mm", "0.001"});
    refused({"plain", "--weave-gap", "1"}, 2, {"--weave-gap", "0.9"});
    refused({"plain", "--warp-color", "red"}, 2, {"--warp-color"});
    EXPECT_FALSE(std::filesystem::exists(out));
    expect_complaint(weave({"plain", "-o", folder.path("no/such")}), 1, {"no/such", "folder"});
}

TEST(WeaveCommand, AFailedWriteLeavesTheOldMapsWhole) {
    const Folder folder;
    const std::string out = folder.path("out");
    ASSERT_EQ(weave({"plain", "--size", "64", "-o", out}).exit_code, 0);
    std::vector<std::string> before;
    for (const std::string& name : kFiles) before.push_back(contents_of(out + "/" + name));
    // The preview and the heights, as the others, do not fit into 100 kB.
    const Outcome outcome =
        weave({"satin-5", "--size", "512", "-o", out}, {.file_size_limit = 100000});
    EXPECT_EQ(outcome.exit_code, 1) << outcome.complaint;
    EXPECT_EQ(names_in(out), kFiles);
    for (std::size_t i = 0; i < kFiles.size(); ++i)
        EXPECT_TRUE(contents_of(out + "/" + kFiles[i]) == before[i]) << kFiles[i];
}

TEST(WeaveCommand, AnInterruptedRunLeavesNothing) {
    const Folder folder;
    const std::string out = folder.path("out");
    // Several seconds of encoding; the folder is made before the maps are.
    RunningProgram program({"weave", "plain", "--size", "4096", "--repeats", "64", "-o", out});
    for (int i = 0; i < 1000 && !std::filesystem::exists(out); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    program.send_signal(SIGINT);
    expect_complaint(program.wait(), 130, {"interrupted"});
    EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace burnish::test
