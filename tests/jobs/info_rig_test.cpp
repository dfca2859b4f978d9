// `burnish info` of rigs: the text lines.
#include <gtest/gtest.h>

#include <regex>

#include "burnish/image_io.hpp"
#include "jobs/info/info.hpp"
#include "support/test_folder.hpp"

namespace burnish {
namespace {

using test::ScratchFolder;

testing::AssertionResult has(const std::string& text, const std::string& pattern) {
    if (std::regex_search(text, std::regex(pattern))) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "no \"" << pattern << "\" in:\n" << text;
}

TEST(InfoRig, NearLightsWithCorners) {
    const ScratchFolder folder;
    write_image(folder / "a.png", Image(6, 4, 3, 0.5f), {});
    const std::string text = describe_file(folder
                                               .write("r.json", R"({
        "format": "burnish-rig", "version": 1, "response": "linear",
        "sample": {"width": 60, "height": 40}, "camera": {"position": [0, -300, 300]},
        "lights": [{"image": "a.png", "position": [0, 0, 200]},
                   {"image": "none.png", "position": [0, 200, 200]},
                   {"direction": [0, 0.6, 0.8]}]})")
                                               .string());
    EXPECT_TRUE(has(text, "r.json: rig, sample 60 x 40 mm\n"));
    EXPECT_TRUE(has(text, R"(2 pictures, 1 missing \(lights\[1\]: "[^"]*none\.png"\), linear)"));
    EXPECT_TRUE(has(text, R"(camera at \(0, -300, 300\) mm, 45\.0 deg from the normal)"));
    // Elevations 90, 45 and asin 0.8 = 53.1 degrees; one azimuth.
    EXPECT_TRUE(has(text, "3 lights, 2 of them near, 45.0 to 90.0 deg over the sample, 0 deg"));
    // The camera leans to -y, the lights to +y: h tilts by (45 - theta) / 2, at most 22.5.
    EXPECT_TRUE(has(text, R"(centre: half vectors tilt up to 22\.5 deg \(at most 45\.0\), )"));
    EXPECT_TRUE(has(text, R"(corners: half vectors tilt up to \d+\.\d to \d+\.\d deg)"));
    EXPECT_TRUE(
        has(text, R"(narrowest lobe these lights sample: alpha 0\.\d+ \(ggx\), 0\.\d+ \()"));
}

TEST(InfoRig, DirectionsAlone) {
    const ScratchFolder folder;
    const std::string text =
        describe_file(folder.write("d.lp", "2\na.jpg 0.6 0 0.8\nb.jpg 0 0.6 0.8\n").string());
    EXPECT_TRUE(has(text, "d.lp: rig, size of the sample not known\n"));
    EXPECT_TRUE(has(text, R"(2 pictures, 2 missing \(line 2: "[^"]*a\.jpg"\), sRGB)"));
    EXPECT_TRUE(has(text, R"(camera towards \(0, 0, 1\), 0\.0 deg)"));
    EXPECT_TRUE(has(text, "2 lights, far away, 53.1 deg over the sample, 90 deg of azimuth"));
    EXPECT_FALSE(has(text, "corners"));
    EXPECT_FALSE(has(text, "camera on the normal"));  // the lights are on one side
}

TEST(InfoRig, BrokenOnesAreErrorsOfRigs) {
    const ScratchFolder folder;
    const std::string path = folder.write("r.json", R"({"format": "burnish-rig",)").string();
    EXPECT_NE(test::error_line([&] { describe_file(path); }).find("line 1, column 26"),
              std::string::npos);
}

}  // namespace
}  // namespace burnish
