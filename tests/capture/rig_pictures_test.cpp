// Pictures of rigs: names of other machines, missing ones, pictures taken by order.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "burnish/image_io.hpp"
#include "burnish/rig.hpp"
#include "core/text.hpp"
#include "jobs/info/info.hpp"
#include "support/test_folder.hpp"

namespace burnish {
namespace {

using test::error_line;
using test::ScratchFolder;
namespace fs = std::filesystem;

void draw(const fs::path& path) {
    write_image(path, Image(4, 2, 3, 0.5f), {});
}

testing::AssertionResult has(const std::string& text, const std::string& part) {
    if (text.find(part) != text.npos) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "no \"" << part << "\" in: " << text;
}

// The warnings that contain `part`.
std::size_t warnings_of(const Rig& rig, const std::string& part) {
    return static_cast<std::size_t>(
        std::count_if(rig.warnings.begin(), rig.warnings.end(),
                      [&](const auto& w) { return w.find(part) != w.npos; }));
}

std::string direction_of(std::size_t k) {  // all different, all unit to four digits
    const double x = 0.1 * static_cast<double>(k % 6), y = 0.1 * static_cast<double>(k / 6);
    return fmt::format("{:.6f} {:.6f} {:.6f}", x, y, std::sqrt(1.0 - x * x - y * y));
}

std::string lp_of(const std::vector<std::string>& names) {
    std::string text = fmt::format("{}\n", names.size());
    for (std::size_t k = 0; k < names.size(); ++k) text += names[k] + " " + direction_of(k) + "\n";
    return text;
}

std::string json_of(const std::vector<std::string>& names, const std::string& more = "") {
    std::string lights;
    for (std::size_t k = 0; k < names.size(); ++k) {
        std::string direction = direction_of(k);
        std::replace(direction.begin(), direction.end(), ' ', ',');
        lights += fmt::format(R"({}{{{}"direction": [{}]}})", k ? ", " : "",
                              names[k].empty() ? "" : fmt::format(R"("image": "{}", )", names[k]),
                              direction);
    }
    return fmt::format(R"({{"format": "burnish-rig", "version": 1,
        "sample": {{"width": 4, "height": 2}}, "camera": {{"direction": [0, 0, 1]}}, {}
        "lights": [{}]}})",
                       more, lights);
}

std::string dome_of(std::size_t lights) {
    std::string list;
    for (std::size_t k = 0; k < lights; ++k) {
        std::string direction = direction_of(k);
        std::replace(direction.begin(), direction.end(), ' ', ',');
        list += fmt::format("{}[{}]", k ? ", " : "", direction);
    }
    return R"({"lightConfiguration": "directional", "directions": [)" + list + "]}";
}

std::vector<std::string> names_of(const Rig& rig) {
    std::vector<std::string> names;
    for (const RigLight& light : rig.lights)
        names.push_back(light.images.at(0).image.filename().string());
    return names;
}

using Names = std::vector<std::string>;

TEST(NaturalOrder, ComparesDigitsAsNumbers) {
    const Names ordered = {"a",     "A1",      "a01",        "a2",
                           "a10",   "a10b",    "a11",        "b1-9",
                           "b1-10", "img_2.x", "img_0010.x", "img_11111111111111111111111.x",
                           "z"};
    for (std::size_t i = 0; i < ordered.size(); ++i)
        for (std::size_t k = 0; k < ordered.size(); ++k)
            EXPECT_EQ(natural_less(ordered[i], ordered[k]), i < k) << ordered[i] << ordered[k];
}

TEST(RigPictures, OfOtherCaseAndEndingAreFoundByEveryReader) {
    const Names named = {"P00.jpg", "p01.jpg", "p02.jpg"};
    for (const bool json : {false, true}) {
        const ScratchFolder folder;
        for (const char* name : {"p00.JPG", "p01.png", "p02.JPG", "Mask.png", "white.png"})
            draw(folder / name);
        const fs::path path =
            json ? folder.write("r.json",
                                json_of(named, R"("mask": "mask.PNG", "white": "white.jpg",)"))
                 : folder.write("r.lp", lp_of(named));
        const Rig rig = read_rig(path, true);
        EXPECT_EQ(names_of(rig), (Names{"p00.JPG", "p01.png", "p02.JPG"}));
        EXPECT_EQ(rig.warnings.size(), 1u);
        // In one warning for all of them.
        EXPECT_EQ(
            warnings_of(rig, json ? "mask: \"Mask.png\" is taken for \"mask.PNG\" (other letter "
                                    "case); so are 4 more"
                                  : "line 2: \"p00.JPG\" is taken for \"P00.jpg\" (other "
                                    "letter case); so are 2 more"),
            1u)
            << rig.warnings.front();
        if (json) {
            EXPECT_EQ(rig.mask->filename(), "Mask.png");
            EXPECT_EQ(rig.white->filename(), "white.png");
        }
    }
}

TEST(RigPictures, OfAnotherEndingHaveItsResponseUnlessOneIsStated) {
    const ScratchFolder folder;
    for (const char* name : {"p00.tif", "p01.tif"}) draw(folder / name);
    const Names named = {"p00.jpg", "p01.jpg"};
    const Rig usual = read_rig(folder.write("r.lp", lp_of(named)), true);
    EXPECT_EQ(usual.response, RigResponse::linear);
    EXPECT_EQ(usual.warnings.size(), 1u);
    const Rig stated =
        read_rig(folder.write("r.json", json_of(named, R"("response": "srgb",)")), true);
    EXPECT_EQ(stated.response, RigResponse::srgb);
    EXPECT_EQ(warnings_of(stated, "\"p00.tif\" is read as sRGB, the response that is stated for"),
              1u);
}

TEST(RigPictures, OfExactNamesAreNotWarnedOf) {
    const ScratchFolder folder;
    fs::create_directory(folder / "sub");
    for (const char* name : {"a.png", "sub/b.png"}) draw(folder / name);
    const Names named = {"a.png", "sub/b.png"};
    EXPECT_TRUE(read_rig(folder.write("r.lp", lp_of(named)), true).warnings.empty());
    EXPECT_TRUE(read_rig(folder.write("r.json", json_of(named)), true).warnings.empty());
}

TEST(RigPictures, MissingOnesAreCountedAndLeftOutOnRequest) {
    const ScratchFolder folder;
    Names named;
    for (int k = 0; k < 12; ++k) {
        named.push_back(fmt::format("p{:02}.png", k));
        if (k % 3 != 1) draw(folder / named.back());
    }
    for (const bool json : {false, true}) {
        const fs::path path =
            json ? folder.write("r.json", json_of(named)) : folder.write("r.lp", lp_of(named));
        const std::string line = error_line([&] { read_rig(path, true); });
        EXPECT_TRUE(has(line, json ? "lights[1].image: " : "line 3: "));
        EXPECT_TRUE(has(line,
                        "expected a picture that is there, found \"p01.png\" and 3 more of 12 "
                        "pictures missing: \"p01.png\", \"p04.png\", \"p07.png\" ...; "
                        "--skip-missing"));
        EXPECT_FALSE(has(line, "--by-order"));  // 8 pictures for 12 lights
        const Rig whole = read_rig(path, false);
        ASSERT_EQ(whole.lights.size(), 12u);
        EXPECT_TRUE(has(whole.missing, "\"p01.png\" and 3 more of 12"));
        RigOverrides overrides;
        overrides.skip_missing = true;
        for (const bool needs_images : {true, false}) {
            const Rig rig = read_rig(path, needs_images, overrides);
            ASSERT_EQ(rig.lights.size(), 8u);
            EXPECT_EQ(names_of(rig)[1], "p02.png");
            EXPECT_EQ(rig.lights[1].place.at, whole.lights[2].place.at);
            EXPECT_EQ(warnings_of(rig, "4 of 12 pictures are missing"), 1u);
        }
    }
}

TEST(RigPictures, AllMissingIsRefusedWhateverIsSkipped) {
    const ScratchFolder folder;
    for (int k = 0; k < 3; ++k) draw(folder / fmt::format("obj_{}.png", k));
    const fs::path path = folder.write("r.lp", lp_of({"ball_0.png", "ball_1.png", "ball_2.png"}));
    RigOverrides overrides;
    overrides.skip_missing = true;
    const std::string line = error_line([&] { read_rig(path, true, overrides); });
    EXPECT_TRUE(has(line, "\"ball_0.png\" and 2 more of 3 pictures missing"));
    EXPECT_TRUE(has(line, "--by-order takes the 3 pictures beside the file by their order"));
    EXPECT_FALSE(has(line, "--skip-missing"));
}

TEST(RigPictures, AnExposureMayBeLeftOutOfItsBracket) {
    const ScratchFolder folder;
    draw(folder / "a1.png");
    draw(folder / "b.png");
    const fs::path path = folder.write("r.json", R"({"format": "burnish-rig", "version": 1,
        "sample": {"width": 4, "height": 2}, "camera": {"direction": [0, 0, 1]}, "lights": [
        {"exposures": [{"image": "a1.png", "exposure": 1}, {"image": "a2.png", "exposure": 8}],
         "direction": [0, 0, 1]}, {"image": "b.png", "direction": [1, 0, 1]}]})");
    RigOverrides overrides;
    overrides.skip_missing = true;
    const Rig rig = read_rig(path, true, overrides);
    ASSERT_EQ(rig.lights.size(), 2u);
    EXPECT_EQ(rig.lights[0].images.size(), 1u);
    EXPECT_EQ(warnings_of(rig, "1 of 3 pictures are missing (\"a2.png\")"), 1u);
}

TEST(RigPictures, AreTakenByOrderForEveryReader) {
    const ScratchFolder folder;
    for (int k = 1; k <= 12; ++k) draw(folder / fmt::format("obj {}.png", k));
    draw(folder / "mask.png");  // the rig's JSON names it
    folder.write("._obj 1.png", "of another system");
    Names balls(12), none(12), expected;
    for (int k = 0; k < 12; ++k) {
        balls[static_cast<std::size_t>(k)] = fmt::format("ball_{:02}.jpg", k);
        expected.push_back(fmt::format("obj {}.png", k + 1));
    }
    RigOverrides overrides;
    overrides.by_order = true;
    const std::string mask = R"("mask": "mask.png",)";
    for (const auto& path : {folder.write("a.json", json_of(balls, mask)),
                             folder.write("b.json", json_of(none, mask))}) {
        const Rig rig = read_rig(path, true, overrides);
        EXPECT_EQ(names_of(rig), expected);
        EXPECT_EQ(rig.response, RigResponse::srgb);
        EXPECT_EQ(warnings_of(rig, "\"obj 9.png\" before \"obj 10.png\""), 1u);
    }
    fs::remove(folder / "mask.png");
    const Rig lp = read_rig(folder.write("a.lp", lp_of(balls)), true, overrides);
    EXPECT_EQ(names_of(lp), expected);
    EXPECT_EQ(warnings_of(lp, "the first, \"obj 1.png\", for \"ball_00.jpg\""), 1u);
    EXPECT_EQ(names_of(read_rig(folder.write("a.dome", dome_of(12)), true)), expected);
    EXPECT_EQ(names_of(read_rig(folder / "a.dome", false)), expected);
}

TEST(RigPictures, ByOrderOfAnotherCountAreRefusedWithBoth) {
    const ScratchFolder folder;
    for (const char* name : {"a.jpg", "b.jpg", "c.exr"}) draw(folder / name);
    RigOverrides overrides;
    overrides.by_order = true;
    for (const auto& path : {folder.write("r.lp", lp_of({"1.jpg", "2.jpg"})),
                             folder.write("r.json", json_of({"1.jpg", "2.jpg"})),
                             folder.write("r.dome", dome_of(2))}) {
        EXPECT_TRUE(has(error_line([&] { read_rig(path, true, overrides); }),
                        "expected 2 pictures beside the file, one a light, found 3 (1 .exr, 2 "
                        ".jpg)"));
        const Rig rig = read_rig(path, false, overrides);  // to render under: needs none
        EXPECT_EQ(rig.lights.size(), 2u);
        EXPECT_TRUE(has(rig.missing, "3 (1 .exr, 2 .jpg) found"));
    }
}

TEST(RigPictures, OfPaddedNumbersNeedNoWarning) {
    const ScratchFolder folder;
    for (int k = 1; k <= 12; ++k) draw(folder / fmt::format("p{:02}.png", k));
    const Rig rig = read_rig(folder.write("r.dome", dome_of(12)), true);
    EXPECT_TRUE(rig.warnings.empty()) << rig.warnings.front();
    EXPECT_EQ(names_of(rig).back(), "p12.png");
}

TEST(RigPictures, RawFilesAreLinear) {
    for (const char* name : {"a.dng", "b.NEF", "c.Cr2", "d.arw", "e.RAF"}) {
        EXPECT_EQ(usual_response(name), RigResponse::linear) << name;
        EXPECT_TRUE(is_raw_camera_name(name)) << name;
    }
    EXPECT_FALSE(is_raw_camera_name("a.tif"));
    const ScratchFolder folder;
    const Rig rig = read_rig(folder.write("r.lp", lp_of({"a.NEF", "b.NEF"})), false);
    EXPECT_EQ(rig.response, RigResponse::linear);
    EXPECT_TRUE(has(describe_file((folder / "r.lp").string()), "linear (raw files)"));
}

TEST(RigPictures, InfoReportsTheSame) {
    const ScratchFolder folder;
    draw(folder / "p00.PNG");
    draw(folder / "p01.png");
    const auto lp = folder.write("r.lp", lp_of({"p00.png", "p01.png", "p02.png"}));
    const std::string text = describe_file(lp.string());
    EXPECT_TRUE(has(text, "3 pictures, 1 missing"));
    EXPECT_TRUE(has(text, "missing: line 4: \"p02.png\"; --skip-missing"));
    EXPECT_TRUE(has(text, "warning: line 2: \"p00.PNG\" is taken for \"p00.png\""));
    EXPECT_TRUE(has(describe_file(folder.write("r.dome", dome_of(5)).string()),
                    "missing: 2 found; expected 5 pictures beside the file"));
}

}  // namespace
}  // namespace burnish
