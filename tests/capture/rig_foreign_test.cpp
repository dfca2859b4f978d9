// Rigs in formats of other programs: .lp and .dome.
#include <gtest/gtest.h>

#include <cmath>

#include "burnish/image_io.hpp"
#include "burnish/rig.hpp"
#include "support/dng_writer.hpp"
#include "support/test_folder.hpp"

namespace burnish {
namespace {

using test::error_line;
using test::ScratchFolder;
namespace fs = std::filesystem;

testing::AssertionResult has(const std::string& text, const std::string& part) {
    if (text.find(part) != text.npos) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "no \"" << part << "\" in: " << text;
}

bool warns(const Rig& rig, const std::string& part) {
    for (const std::string& warning : rig.warnings)
        if (warning.find(part) != warning.npos) return true;
    return false;
}

void expect_near(const Vec3d& a, const Vec3d& b, double tolerance) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << i;
}

void draw(const fs::path& path, int width = 4, int height = 2) {
    write_image(path, Image(width, height, 3, 0.5f), {});
}

Rig read(const char* name, const std::string& text, const RigOverrides& overrides = {}) {
    const ScratchFolder folder;
    return read_rig(folder.write(name, text), false, overrides);
}

std::string error_of(const char* name, const std::string& text) {
    return error_line([&] { read(name, text); });
}

// --- .lp ----------------------------------------------------------------------------------------

TEST(Lp, ReadsDirectionsAndFillsInTheRest) {
    const Rig rig = read("a.lp",
                         "\xef\xbb\xbf 2 \r\n\r\nphoto 1 of 2.jpg\t0.6 0 0.8\r\n"
                         "b.jpg +0.0 -6e-1 0.8\r\n\n");
    ASSERT_EQ(rig.lights.size(), 2u);
    EXPECT_EQ(rig.lights[0].images.at(0).image.filename(), "photo 1 of 2.jpg");
    EXPECT_EQ(rig.lights[0].images[0].image.parent_path(), rig.file.parent_path());
    EXPECT_FALSE(rig.lights[0].place.near);
    expect_near(rig.lights[0].place.at, {0.6, 0, 0.8}, 1e-15);
    expect_near(rig.lights[1].place.at, {0, -0.6, 0.8}, 1e-15);
    EXPECT_EQ(rig.lights[1].where, "line 4");
    EXPECT_EQ(rig.camera.at, (Vec3d{0, 0, 1}));
    EXPECT_FALSE(rig.camera.near);
    EXPECT_EQ(rig.response, RigResponse::srgb);
    EXPECT_EQ(rig.width_mm, 0.0);
}

TEST(Lp, ErrorsNameTheLine) {
    const std::string good = "a.jpg 0 0 1\n";
    EXPECT_TRUE(has(error_of("a.lp", "3\n" + good + "b.jpg 0.6 0 0.8\n"),
                    "line 1: expected 3 lines of lights, found 2"));
    EXPECT_TRUE(has(error_of("a.lp", "\n1\n" + good + "b.jpg 0.6 0 0.8\n"),
                    "line 2: expected 1 lines of lights, found 2"));
    EXPECT_TRUE(has(error_of("a.lp", "2\n" + good + "b.jpg 0,577350269 0,577350269 0,577350269\n"),
                    "line 3: expected a decimal point in every number, found \"0,577350269\""));
    EXPECT_TRUE(has(error_of("a.lp", "2\n" + good + "b.jpg 0.6 0 0.9\n"),
                    "line 3: expected a direction of length 1, found one of length 1.082"));
    EXPECT_TRUE(has(error_of("a.lp", "2\n" + good + "b.jpg 0.6 0 -0.8\n"),
                    "line 3: expected a light above the sample (z > 0), found z = -0.8"));
    EXPECT_TRUE(has(error_of("a.lp", "2\n" + good + "b.jpg 1 0 0\n"), "line 3"));
    EXPECT_TRUE(has(error_of("a.lp", "1\na.jpg 0 nan 1\n"), "line 2"));
    EXPECT_TRUE(has(error_of("a.lp", "1\na.jpg 0 inf 1\n"), "line 2"));
    EXPECT_TRUE(has(error_of("a.lp", "1\n0 0 1\n"), "line 2: expected 'file x y z'"));
    EXPECT_TRUE(has(error_of("a.lp", "1\na.jpg 0 1\n"), "line 2: expected 'file x y z'"));
    EXPECT_TRUE(has(error_of("a.lp", "a.jpg 0 0 1\n"), "line 1: expected the number of lights"));
    EXPECT_TRUE(has(error_of("a.lp", "0\n"), "line 1: expected from 1 to 10000 lights"));
    EXPECT_TRUE(has(error_of("a.lp", "99999999999999999999\n"), "line 1"));
    EXPECT_TRUE(has(error_of("a.lp", ""), "line 1"));
    EXPECT_TRUE(has(error_of("a.lp", "2\n" + good + good),
                    "line 3: expected a picture of its own, found \"a.jpg\", that of line 2 too"));
}

TEST(Lp, RoundedDirectionsAreMadeUnitWithAWarning) {
    const Rig rig = read("a.lp", "2\na.jpg 0.6 0 0.8\nb.jpg 0.0 0.60 0.81\n");
    EXPECT_TRUE(warns(rig, "line 3: the direction's length is off by 0.8 %"));
    const double size = std::hypot(0.6, 0.81);
    expect_near(rig.lights[1].place.at, {0, 0.6 / size, 0.81 / size}, 1e-15);
    EXPECT_FALSE(warns(read("a.lp", "2\na.jpg 0.6 0 0.8\nb.jpg 0 0 1\n"), "length"));
}

TEST(Lp, FindsThePicturesOfAnotherMachine) {
    const ScratchFolder folder;
    fs::create_directory(folder / "jpg");
    draw(folder / "a 1.png");
    draw(folder / "jpg/b.png");
    draw(folder / "jpg/c.png");
    draw(folder / "d.png");
    const auto path = folder.write("dome.lp",
                                   "4\nC:\\captures\\lion head\\a 1.png 0 0 1\n"
                                   "C:\\captures\\jpg\\b.png 0.6 0 0.8\n"
                                   "/home/somebody/jpg/c.png 0 0.6 0.8\nd.png 0 -0.6 0.8\n");
    const Rig rig = read_rig(path, true);
    EXPECT_EQ(rig.lights[0].images[0].image, folder / "a 1.png");
    EXPECT_EQ(rig.lights[1].images[0].image, folder / "jpg/b.png");
    EXPECT_EQ(rig.lights[2].images[0].image, folder / "jpg/c.png");
    EXPECT_EQ(rig.lights[3].images[0].image, folder / "d.png");
    fs::remove(folder / "jpg/c.png");
    EXPECT_TRUE(
        has(error_line([&] { read_rig(path, true); }),
            "line 4: expected a picture that is there, found \"/home/somebody/jpg/c.png\""));
}

TEST(Lp, SizeComesFromTheCallerAndThePictures) {
    const ScratchFolder folder;
    draw(folder / "a.png", 8, 2);
    RigOverrides overrides;
    overrides.width_mm = 100;
    const Rig rig = read_rig(folder.write("a.lp", "1\na.png 0 0 1\n"), true, overrides);
    EXPECT_EQ(rig.width_mm, 100);
    EXPECT_EQ(rig.height_mm, 25);
    write_rig(folder / "a.json", rig);
    EXPECT_EQ(read_rig(folder / "a.json", true).height_mm, 25);
    EXPECT_TRUE(
        has(error_line([&] { write_rig(folder / "b.json", read_rig(folder / "a.lp", true)); }),
            "sample: expected a sample with a size"));
}

// Old programs write Windows-1252; JSON holds UTF-8 alone.
TEST(Lp, NamesThatAreNoUtf8AreReadAsWindows1252) {
    const ScratchFolder folder;
    RigOverrides overrides;
    overrides.width_mm = 10;
    const fs::path file = folder.write("a.lp", "1\nl\xf6we.png 0 0 1\n");
    Rig rig = read_rig(file, false, overrides);
    EXPECT_EQ(rig.lights[0].images[0].image.filename(), "l\xc3\xb6we.png");
    write_rig(folder / "a.json", rig);
    draw(folder / "l\xc3\xb6we.png", 8, 2);
    EXPECT_EQ(read_rig(file, true, overrides).lights[0].images[0].image.filename(),
              "l\xc3\xb6we.png");
    rig.lights[0].images[0].image = "l\xf6we.png";
    EXPECT_TRUE(has(error_line([&] { write_rig(folder / "b.json", rig); }),
                    "expected names of pictures in UTF-8"));
    EXPECT_FALSE(fs::exists(folder / "b.json"));
}

TEST(Lp, RealCapture) {
    const fs::path data = test::sample_data();
    const fs::path path = data / "captures/rti_lionhead_240lights/dirs.lp";
    if (data.empty() || !fs::exists(path)) GTEST_SKIP() << "no sample capture (set BURNISH_DATA)";
    const Rig rig = read_rig(path, false);
    ASSERT_EQ(rig.lights.size(), 240u);
    // Line 2 of the file, with directions of eight digits.
    expect_near(rig.lights[0].place.at, {-0.0019356994, -0.14720464, 0.98910415}, 1e-7);
    EXPECT_EQ(rig.lights[0].images[0].image, path.parent_path() / "jpg/Loewenkopf_klein_0001.jpg");
    EXPECT_EQ(rig.response, RigResponse::srgb);
}

// --- .dome --------------------------------------------------------------------------------------

TEST(Dome, Directional) {
    const Rig rig = read("a.dome", R"({"label": "mine", "notes": "", "imageWidth": 120,
        "lightConfiguration": "directional", "lightSource": "from_lp", "domeDiameter": 0,
        "directions": [[0.6, 0, 0.8], {"x": 0, "y": -0.6, "z": 0.8}]})");
    ASSERT_EQ(rig.lights.size(), 2u);
    EXPECT_FALSE(rig.lights[0].place.near);
    expect_near(rig.lights[1].place.at, {0, -0.6, 0.8}, 1e-15);
    EXPECT_EQ(rig.width_mm, 120);
    EXPECT_EQ(rig.lights[1].where, "directions[1]");
    EXPECT_FALSE(warns(rig, "unknown"));
}

// Every light must be on the sphere and on the ray from the origin in its direction.
TEST(Dome, SphericalLiesOnTheSphereAlongTheDirections) {
    for (const double offset : {0.0, 60.0, -40.0}) {
        const Rig rig =
            read("a.dome", R"({"lightConfiguration": "spherical", "domeDiameter": 600,
            "verticalOffset": )" +
                               std::to_string(offset) +
                               R"(, "directions": [[0.6, 0, 0.8], [0, 0, 1], [0, -0.96, 0.28]]})");
        const Vec3d directions[] = {{0.6, 0, 0.8}, {0, 0, 1}, {0, -0.96, 0.28}};
        for (std::size_t i = 0; i < 3; ++i) {
            ASSERT_TRUE(rig.lights[i].place.near);
            const Vec3d& p = rig.lights[i].place.at;
            EXPECT_NEAR(std::hypot(p[0], p[1], p[2] - offset), 300.0, 1e-10);
            const double t = std::hypot(p[0], p[1], p[2]);
            expect_near({p[0] / t, p[1] / t, p[2] / t}, directions[i], 1e-12);
        }
    }
}

TEST(Dome, PositionsAndCorrections) {
    const Rig rig = read("a.dome", R"({"lightConfiguration": "lights3d",
        "directions": [[0, 0, 1], [0, 0, 1]], "positions3d": [[10, 0, 200], [0, 20, 200]],
        "ledAdjust": [[1, 2, 4], [1, 1, 1]],
        "lightsCalibration": [{"whiteBalance": {"r": 1, "g": 1, "b": 2}, "intensity": 0.5},
                              {"spatialCalibration": {}}]})");
    EXPECT_TRUE(rig.lights[0].place.near);
    EXPECT_EQ(rig.lights[1].place.at, (Vec3d{0, 20, 200}));
    // The factors multiply pixels: a factor of 2 means half the intensity.
    EXPECT_EQ(rig.lights[0].intensity, (Vec3d{2, 1, 0.25}));
    EXPECT_EQ(rig.lights[1].intensity, (Vec3d{1, 1, 1}));
    EXPECT_TRUE(warns(rig, "spatialCalibration is passed over"));
    const Rig plain = read("a.dome", R"({"positions": [[10, 0, 200], [0, 20, 200]]})");
    EXPECT_TRUE(plain.lights[1].place.near);
}

TEST(Dome, ErrorsNameTheKey) {
    EXPECT_TRUE(has(error_of("a.dome", "{}"), "positions: expected a value, found none"));
    EXPECT_TRUE(has(error_of("a.dome", R"({"directions": []})"), "directions"));
    EXPECT_TRUE(has(error_of("a.dome", R"({"directions": [[0, 0, 2]]})"),
                    "directions[0]: expected a direction of length 1"));
    EXPECT_TRUE(has(error_of("a.dome", R"({"directions": [[0, 0, -1]]})"),
                    "directions[0]: expected a light above the sample"));
    EXPECT_TRUE(has(error_of("a.dome", R"({"lightConfiguration": "round"})"),
                    "lightConfiguration: expected directional, spherical or lights3d"));
    EXPECT_TRUE(
        has(error_of("a.dome", R"({"directions": [[0,0,1]], "ledAdjust": [[1,1,1],[1,1,1]]})"),
            "ledAdjust: expected 1 entries, found 2"));
    EXPECT_TRUE(has(error_of("a.dome", R"({"lightConfiguration": "spherical", "domeDiameter": 10,
                    "verticalOffset": 5, "directions": [[0,0,1]]})"),
                    "verticalOffset"));
    EXPECT_TRUE(warns(read("a.dome", R"({"directions": [[0,0,1]], "imageWdith": 3})"),
                      "unknown key \"imageWdith\" is passed over; did you mean 'imageWidth'?"));
}

TEST(Dome, TakesThePicturesBesideItInTheOrderOfTheirNames) {
    const ScratchFolder folder;
    draw(folder / "p2.png", 4, 2);
    draw(folder / "p1.png", 4, 2);
    const auto path =
        folder.write("a.dome", R"({"imageWidth": 80, "directions": [[0,0,1], [0.6,0,0.8]]})");
    const Rig rig = read_rig(path, true);
    EXPECT_EQ(rig.lights[0].images.at(0).image, folder / "p1.png");
    EXPECT_EQ(rig.lights[1].images.at(0).image, folder / "p2.png");
    EXPECT_EQ(rig.height_mm, 40);
    draw(folder / "mask.png");
    EXPECT_TRUE(has(error_line([&] { read_rig(path, true); }),
                    "expected 2 pictures beside the file, one a light, found 3"));
}

// Cameras write a JPEG beside each raw file: the same pictures twice.
TEST(Dome, TakesRawFilesOnlyWhereThereIsNothingElse) {
    const ScratchFolder folder;
    const auto path = folder.write("a.dome", R"({"directions": [[0,0,1]]})");
    const std::vector<std::byte> bytes = test::dng_of(Image(32, 24, 3, 0.5f));
    folder.write("p.dng", std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    EXPECT_EQ(read_rig(path, true).lights[0].images.at(0).image, folder / "p.dng");
    draw(folder / "p.png", 4, 2);
    EXPECT_EQ(read_rig(path, true).lights[0].images.at(0).image, folder / "p.png");
}

}  // namespace
}  // namespace burnish
