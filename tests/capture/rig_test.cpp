// Our rig JSON, the checks shared by all formats, and the geometry of received light.
#include "burnish/rig.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "burnish/image_io.hpp"
#include "support/dng_writer.hpp"
#include "support/paths.hpp"
#include "support/test_folder.hpp"

namespace burnish {
namespace {

using test::error_line;
using test::ScratchFolder;
using testing::AssertionFailure;
using testing::AssertionResult;
using testing::AssertionSuccess;

constexpr double kRounding = 1e-15;

AssertionResult near(const Vec3d& a, const Vec3d& b, double tolerance = kRounding) {
    for (std::size_t i = 0; i < 3; ++i)
        if (!(std::abs(a[i] - b[i]) <= tolerance))
            return AssertionFailure() << "(" << a[0] << ", " << a[1] << ", " << a[2] << ") is not ("
                                      << b[0] << ", " << b[1] << ", " << b[2] << ")";
    return AssertionSuccess();
}

AssertionResult has(const std::string& text, const std::string& part) {
    if (text.find(part) != text.npos) return AssertionSuccess();
    return AssertionFailure() << "no \"" << part << "\" in: " << text;
}

bool warns(const Rig& rig, const std::string& part) {
    for (const std::string& warning : rig.warnings)
        if (warning.find(part) != warning.npos) return true;
    return false;
}

constexpr const char* kLights =
    R"("lights": [{"position": [0, 0, 100]}, {"direction": [1, 0, 1]}])";
constexpr const char* kCamera = R"("camera": {"direction": [0, 1, 1]})";

std::string rig_of(const std::string& members) {
    return R"({"format": "burnish-rig", "version": 1, "sample": {"width": 40, "height": 20}, )" +
           members + "}";
}

Rig read(const std::string& text, const RigOverrides& overrides = {}) {
    const ScratchFolder folder;
    return read_rig(folder.write("r.json", text), false, overrides);
}

std::string error_of(const std::string& members) {
    return error_line([&] { read(rig_of(members)); });
}

void draw(const ScratchFolder& folder, std::string_view name, int width = 4, int height = 2) {
    write_image(folder / name, Image(width, height, 3, 0.5f), {});
}

TEST(RigJson, ManualsExampleReads) {
    std::ifstream file(test::source_folder() / "docs/reference/rig-file.md");
    const std::string manual(std::istreambuf_iterator<char>(file), {});
    const std::size_t start = manual.find("```json\n") + 8;
    const Rig rig = read(manual.substr(start, manual.find("```", start) - start));
    ASSERT_EQ(rig.lights.size(), 3u);
    EXPECT_TRUE(rig.camera.near);
    EXPECT_EQ(rig.lights[1].images.size(), 2u);
    EXPECT_TRUE(rig.warnings.empty()) << rig.warnings.front();
}

TEST(RigJson, ReadsEveryKey) {
    const Rig rig = read(rig_of(
        R"("units": "mm", "response": "linear", "mask": "m.png", "white": "w.exr",
           "camera": {"position": [0, -300, 400]},
           "lights": [{"image": "a.exr", "position": [10, 20, 30], "intensity": [1, 2, 3],
                       "emission_axis": [0, 0, -2], "emission_exponent": 1.5},
                      {"exposures": [{"image": "b1.exr", "exposure": 1},
                                     {"image": "b2.exr", "exposure": 0.25}],
                       "direction": [3, 0, 4], "intensity": 7,
                       "camera": {"direction": [0, 0, 1]}}])"));
    EXPECT_EQ(rig.response, RigResponse::linear);
    EXPECT_EQ(rig.width_mm, 40);
    EXPECT_EQ(rig.height_mm, 20);
    EXPECT_TRUE(rig.camera.near);
    EXPECT_EQ(rig.camera.at, (Vec3d{0, -300, 400}));
    EXPECT_EQ(rig.mask->filename(), "m.png");
    EXPECT_EQ(rig.white->filename(), "w.exr");
    EXPECT_EQ(rig.mask->parent_path(), rig.file.parent_path());
    ASSERT_EQ(rig.lights.size(), 2u);
    const RigLight &a = rig.lights[0], &b = rig.lights[1];
    EXPECT_TRUE(a.place.near);
    EXPECT_EQ(a.place.at, (Vec3d{10, 20, 30}));
    EXPECT_EQ(a.intensity, (Vec3d{1, 2, 3}));
    EXPECT_EQ(a.emission_axis, (Vec3d{0, 0, -1}));
    EXPECT_EQ(a.emission_exponent, 1.5);
    EXPECT_EQ(a.where, "lights[0]");
    EXPECT_FALSE(b.place.near);
    EXPECT_TRUE(near(b.place.at, {0.6, 0, 0.8}));
    EXPECT_EQ(b.intensity, (Vec3d{7, 7, 7}));
    ASSERT_EQ(b.images.size(), 2u);
    EXPECT_EQ(b.images[1].image.filename(), "b2.exr");
    EXPECT_EQ(b.images[1].exposure, 0.25);
    ASSERT_TRUE(b.camera);
    EXPECT_FALSE(b.camera->near);
}

TEST(RigJson, ErrorsNameTheKeyWhatIsExpectedAndWhatIsFound) {
    const auto with_light = [](const std::string& light) {
        return std::string(kCamera) + R"(, "lights": [{"direction": [0,0,1]}, {)" + light + "}]";
    };
    EXPECT_TRUE(has(error_of(std::string(kLights) + R"(, "camrea": {"direction": [0,0,1]})"),
                    "unknown key \"camrea\"; did you mean 'camera'?"));
    EXPECT_TRUE(has(error_of(with_light(R"("direction": [0,0,1], "intensty": 2)")),
                    "lights[1]: unknown key \"intensty\"; did you mean 'intensity'?"));
    EXPECT_TRUE(has(error_of(with_light(R"("image": "a.png")")),
                    R"(lights[1]: expected either "position" or "direction", found neither)"));
    EXPECT_TRUE(has(error_of(with_light(R"("position": [0,0,1], "direction": [0,0,1])")),
                    "lights[1]: expected either \"position\" or \"direction\", found both"));
    EXPECT_TRUE(has(error_of(with_light(R"("direction": [0,0,0])")),
                    "lights[1].direction: expected a direction that is not zero"));
    EXPECT_TRUE(has(error_of(with_light(R"("direction": [1,0,-0.5])")),
                    "lights[1]: expected a light above the sample (z > 0), found z = -0.4"));
    EXPECT_TRUE(has(error_of(with_light(R"("position": [1,0,0])")), "found z = 0"));
    EXPECT_TRUE(has(error_of(with_light(R"("position": [1,0,2e9])")),
                    "lights[1].position[2]: expected a number from -1e+06 to 1e+06"));
    EXPECT_TRUE(has(error_of(with_light(R"("direction": [0,0,1], "intensity": 0)")),
                    "lights[1].intensity"));
    EXPECT_TRUE(has(error_of(with_light(R"("direction": [0,0,1], "emission_exponent": 1)")),
                    "lights[1].emission_exponent: expected a light with a position"));
    EXPECT_TRUE(
        has(error_of(with_light(R"("position": [0,0,9], "emission_axis": [0,0,1])")),
            "lights[1].emission_axis: expected an axis that points from the light to the sample"));
    // For a light below the sample the position is the error, in whichever direction the light
    // shines.
    EXPECT_TRUE(has(error_of(with_light(R"("position": [0,0,-9], "emission_axis": [0,0,-1])")),
                    "lights[1]: expected a light above the sample"));
    EXPECT_TRUE(
        has(error_of(with_light(R"("direction": [0,0,1], "image": "a.png", "exposures": [])")),
            "lights[1]: expected \"image\" or \"exposures\", found both"));
    EXPECT_TRUE(has(error_of(with_light(R"("direction": [0,0,1], "exposures": [])")),
                    "lights[1].exposures: expected at least one exposure"));
    EXPECT_TRUE(has(error_of(with_light(R"("direction": [0,0,1], "image": "a\nb.png")")),
                    "lights[1].image: expected a file"));
    EXPECT_TRUE(has(error_of(kLights), "camera: expected a value, found none"));
    EXPECT_TRUE(has(error_of(std::string(kLights) + R"(, "camera": {"direction": [0,1,-1]})"),
                    "camera: expected a camera above the sample"));
    EXPECT_TRUE(has(error_of(std::string(kCamera) + R"(, "lights": [])"),
                    "lights: expected at least one light"));
    EXPECT_TRUE(has(error_of(std::string(kCamera) + R"(, "units": "cm", )" + kLights),
                    "units: expected \"mm\""));
    EXPECT_TRUE(has(error_of(std::string(kCamera) + R"(, "response": "log", )" + kLights),
                    R"(response: expected "linear" or "srgb", found "log")"));
    EXPECT_TRUE(
        has(error_line([] {
                read(R"({"format":"burnish-rig","version":1,"sample":{"width":0,"height":1}})");
            }),
            "sample.width"));
    EXPECT_TRUE(
        has(error_line([] { read(R"({"format":"burnish-rig","version":2})"); }), "version"));
}

TEST(RigJson, CameraMayComeFromTheCallerOrFromEveryLight) {
    const RigOverrides overrides{{}, RigPlace{false, {0, 3, 4}}, {}};
    EXPECT_TRUE(near(read(rig_of(kLights), overrides).camera.at, {0, 0.6, 0.8}));
    const Rig rig =
        read(rig_of(R"("lights": [{"direction": [0,0,1], "camera": {"position": [1,2,3]}}])"));
    EXPECT_EQ(rig.lights[0].camera->at, (Vec3d{1, 2, 3}));
}

TEST(RigJson, FlipsY) {
    RigOverrides overrides;
    overrides.flip_y = true;
    const Rig rig = read(rig_of(R"("camera": {"position": [1, 2, 3]}, "lights": [
        {"position": [4, 5, 6], "emission_axis": [0, -0.6, -0.8], "emission_exponent": 1,
         "camera": {"direction": [0, 0.6, 0.8]}}])"),
                         overrides);
    EXPECT_EQ(rig.camera.at, (Vec3d{1, -2, 3}));
    EXPECT_EQ(rig.lights[0].place.at, (Vec3d{4, -5, 6}));
    EXPECT_EQ(rig.lights[0].emission_axis, (Vec3d{0, 0.6, -0.8}));
    EXPECT_EQ(rig.lights[0].camera->at, (Vec3d{0, -0.6, 0.8}));
}

TEST(RigJson, WarnsOfWhatIsAllowedAndOdd) {
    EXPECT_TRUE(warns(read(rig_of(std::string(kCamera) +
                                  R"(, "lights": [{"direction":[0,0,1]},{"direction":[0,0,1]}])")),
                      "lights[1]: the light is where that of lights[0] is"));
    EXPECT_TRUE(
        warns(read(rig_of(std::string(kCamera) +
                          R"(, "lights": [{"direction":[0,0,1]},{"direction":[9,0,300]}])")),
              "lights[1].direction: a direction of length 300.1: is it a position?"));
    EXPECT_TRUE(
        read(rig_of(std::string(kCamera) +
                    R"(, "lights": [{"direction":[0,0,1]},{"direction":[0,1,1],"intensity":1}])"))
            .warnings.empty());
}

std::string sample_rig(const std::string& size, const std::string& camera,
                       const std::string& light) {
    return R"({"format": "burnish-rig", "version": 1, "sample": )" + size + R"(, "camera": )" +
           camera + R"(, "lights": [{"direction": [1, 0, 1], "intensity": 1}, )" + light + "]}";
}

// The same rig in millimeters is silent; in meters, or with one of its lengths in meters, it warns.
TEST(RigJson, WarnsOfLengthsInMeters) {
    const std::string in_mm = R"({"width": 40, "height": 30})", in_m = R"({"width": 0.04,
        "height": 0.03})",
                      far_camera = R"({"position": [0, 0, 300]})",
                      light = R"({"position": [0, 200, 300], "intensity": 1e5})";
    EXPECT_TRUE(read(sample_rig(in_mm, far_camera, light)).warnings.empty());
    const char* advice = "multiply all of them by 1000 if they are in meters";
    const Rig small = read(sample_rig(in_m, R"({"position": [0, 0, 0.3]})",
                                      R"({"position": [0, 0.2, 0.3], "intensity": 1})"));
    EXPECT_TRUE(warns(small, "sample: 0.04 x 0.03 mm"));
    EXPECT_TRUE(warns(small, advice));
    EXPECT_FALSE(warns(small, "from the middle"));  // its proportions are right
    const Rig near_camera = read(sample_rig(in_mm, R"({"position": [0, 0, 0.3]})", light));
    EXPECT_TRUE(
        warns(near_camera, "camera: 0.3 mm from the middle of a sample that is 40 mm wide"));
    const Rig near_light =
        read(sample_rig(in_mm, far_camera, R"({"position": [0, 0.3, 0.4], "intensity": 1e5})"));
    EXPECT_TRUE(warns(near_light, "lights[1]: the light is 0.5 mm from the middle"));
    EXPECT_TRUE(warns(near_light, advice));
    const Rig large = read(sample_rig(R"({"width": 40000, "height": 30000})", far_camera,
                                      R"({"position": [0, 0, 30000], "intensity": 1e9})"));
    EXPECT_TRUE(warns(large, "divide all of them by 1000 if they are in micrometers"));
    // The width that the caller states is that of the sample.
    RigOverrides overrides;
    overrides.width_mm = 40.0;
    EXPECT_FALSE(warns(read(sample_rig(in_m, far_camera, light), overrides), "sample:"));
}

TEST(RigJson, WarnsOfALightWithoutAnIntensityAmongOthersThatStateOne) {
    const auto lights = [](const char* first, const char* second) {
        return rig_of(std::string(kCamera) + R"(, "lights": [{"direction": [0, 0, 1])" + first +
                      R"(}, {"direction": [0, 1, 1])" + second + "}]");
    };
    EXPECT_TRUE(warns(read(lights("", R"(, "intensity": 0.8)")),
                      "lights[0]: no intensity, which 1 of 2 lights state: taken as 1"));
    EXPECT_TRUE(
        warns(read(lights(R"(, "intensity": [1, 1, 0.9])", "")), "lights[1]: no intensity"));
    for (const char* stated : {"", R"(, "intensity": 1)"})
        EXPECT_TRUE(read(lights("", stated)).warnings.empty());
    // 1 at a distance of 100 mm arrives as 1e-4.
    EXPECT_TRUE(warns(read(rig_of(std::string(kCamera) + ", " + kLights)),
                      "1 have a position and 1 a direction"));
}

TEST(RigJson, StacksNeedTheirPictures) {
    const ScratchFolder folder;
    const auto line = [&](const std::string& lights) {
        const auto path = folder.write(
            "r.json", rig_of(std::string(kCamera) + R"(, "lights": [)" + lights + "]"));
        return error_line([&] { read_rig(path, true); });
    };
    draw(folder, "a.png");
    EXPECT_TRUE(has(line(R"({"direction": [0,0,1]})"), "lights[0].image: expected a value"));
    EXPECT_TRUE(has(line(R"({"direction": [0,0,1], "image": "none.png"})"),
                    "lights[0].image: expected a picture that is there, found \"none.png\""));
    EXPECT_TRUE(
        has(line(R"({"direction": [0,0,1], "image": "a.png"},
                            {"direction": [0,1,1], "image": "a.png"})"),
            "lights[1]: expected a picture of its own, found \"a.png\", that of lights[0]"));
}

TEST(RigJson, WarnsOfPicturesOfOtherProportions) {
    const ScratchFolder folder;
    draw(folder, "a.png", 4, 2);
    draw(folder, "b.png", 4, 4);
    const auto of = [&](const std::string& name) {
        return read_rig(
            folder.write("r.json", rig_of(std::string(kCamera) +
                                          R"(, "lights": [{"direction": [0,0,1], "image": ")" +
                                          name + "\"}]")),
            true);
    };
    EXPECT_FALSE(warns(of("a.png"), "proportions"));
    EXPECT_TRUE(warns(of("b.png"), "proportions"));
}

TEST(RigJson, WarnsOfRawCameraFiles) {
    const ScratchFolder folder;
    const std::vector<std::byte> bytes = test::dng_of(Image(48, 24, 3, 0.5f));
    folder.write("a.dng", std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    const Rig rig = read_rig(
        folder.write("r.json", rig_of(std::string(kCamera) +
                                      R"(, "lights": [{"direction": [0,0,1], "image": "a.dng"}])")),
        true);
    EXPECT_TRUE(warns(rig, "linear camera RGB without white balance"));
    EXPECT_EQ(rig.response, RigResponse::linear);
    EXPECT_FALSE(warns(rig, "proportions")) << "the preview has others than the sensor";
}

TEST(RigJson, ResponseFollowsTheKindOfPictureWhenNothingIsSaid) {
    const auto of = [](const std::string& picture, const std::string& more = "",
                       const RigOverrides& overrides = {}) {
        return read(rig_of(std::string(kCamera) + more +
                           R"(, "lights": [{"direction": [0,0,1], "image": ")" + picture + "\"}]"),
                    overrides)
            .response;
    };
    for (const char* name : {"a.png", "a.JPG", "a.jpeg"}) EXPECT_EQ(of(name), RigResponse::srgb);
    for (const char* name : {"a.webp", "a.bmp", "a.tga", "a.HEIC"})
        EXPECT_EQ(of(name), RigResponse::srgb);
    for (const char* name : {"a.exr", "a.HDR", "a.tif", "a.tiff", "a.dng", "a.NEF", "a.cr3"})
        EXPECT_EQ(of(name), RigResponse::linear);
    EXPECT_EQ(of("a.png", R"(, "response": "linear")"), RigResponse::linear);
    EXPECT_EQ(of("a.exr", R"(, "response": "linear")", {RigResponse::srgb, {}, {}}),
              RigResponse::srgb);
}

TEST(RigJson, WarnsOfPicturesOfSeveralKindsWithoutAResponse) {
    const auto of = [](const std::string& more) {
        return read(rig_of(std::string(kCamera) + more + R"(, "lights": [
            {"direction": [0,0,1], "image": "a.exr"}, {"direction": [0,1,1], "image": "b.png"}])"));
    };
    EXPECT_TRUE(warns(of(""), "lights[1]: a picture of another kind than the first"));
    EXPECT_FALSE(warns(of(R"(, "response": "linear")"), "kind"));
}

TEST(RigJson, WidthMayComeFromTheCaller) {
    const std::string text = rig_of(std::string(kCamera) + ", " + kLights);
    const Rig rig = read(text, {{}, {}, 100.0});
    EXPECT_EQ(rig.width_mm, 100.0);
    EXPECT_EQ(rig.height_mm, 50.0);
}

TEST(RigJson, ComesBackTheSameWhenWritten) {
    const ScratchFolder folder;
    std::filesystem::create_directory(folder / "sub");
    const Rig rig = read_rig(
        folder.write("r.json", rig_of(
                                   R"("response": "linear", "mask": "sub/m.png", "white": "w.exr",
               "camera": {"position": [0.1, -300, 400]},
               "lights": [{"image": "sub/a b.exr", "position": [10, 20, 30.3],
                           "intensity": [1, 2, 3.7],
                           "emission_axis": [0.1, 0, -2], "emission_exponent": 1.5},
                          {"exposures": [{"image": "b1.exr", "exposure": 1},
                                         {"image": "b2.exr", "exposure": 0.3}],
                           "direction": [0.1, 0.2, 0.3], "intensity": 7,
                           "camera": {"direction": [0, 0.1, 1]}},
                          {"direction": [0.3, 0.1, 0.3]}])")),
        false);
    write_rig(folder / "sub/again.json", rig);
    EXPECT_TRUE(is_rig_file(folder / "sub/again.json"));
    const Rig again = read_rig(folder / "sub/again.json", false);
    EXPECT_EQ(again.response, rig.response);
    EXPECT_EQ(again.width_mm, rig.width_mm);
    EXPECT_EQ(again.height_mm, rig.height_mm);
    EXPECT_EQ(again.camera.near, rig.camera.near);
    EXPECT_EQ(again.camera.at, rig.camera.at);
    EXPECT_EQ(again.mask->lexically_normal(), *rig.mask);
    EXPECT_EQ(again.white->lexically_normal(), *rig.white);
    ASSERT_EQ(again.lights.size(), rig.lights.size());
    for (std::size_t i = 0; i < rig.lights.size(); ++i) {
        const RigLight &a = rig.lights[i], &b = again.lights[i];
        EXPECT_EQ(a.place.near, b.place.near);
        EXPECT_TRUE(near(a.place.at, b.place.at));
        EXPECT_EQ(a.intensity, b.intensity);
        EXPECT_TRUE(near(a.emission_axis, b.emission_axis));
        EXPECT_EQ(a.emission_exponent, b.emission_exponent);
        ASSERT_EQ(a.images.size(), b.images.size());
        for (std::size_t k = 0; k < a.images.size(); ++k) {
            EXPECT_EQ(a.images[k].image, b.images[k].image.lexically_normal());
            EXPECT_EQ(a.images[k].exposure, b.images[k].exposure);
        }
        ASSERT_EQ(a.camera.has_value(), b.camera.has_value());
        if (a.camera) {
            EXPECT_TRUE(near(a.camera->at, b.camera->at));
        }
    }
}

// --- geometry -----------------------------------------------------------------------------------

TEST(RigGeometry, PointsOfTheSampleHaveRowZeroAtTheTop) {
    Rig rig;
    rig.width_mm = 40;
    rig.height_mm = 20;
    EXPECT_TRUE(near(sample_point(rig, 4, 2, 0, 0), {-15, 5, 0}));
    EXPECT_TRUE(near(sample_point(rig, 4, 2, 3, 0), {15, 5, 0}));
    EXPECT_TRUE(near(sample_point(rig, 4, 2, 0, 1), {-15, -5, 0}));
    EXPECT_TRUE(near(sample_point(rig, 3, 3, 1, 1), {0, 0, 0}));
}

TEST(RigGeometry, NearLightFallsOffWithTheSquareAndTheLobe) {
    RigLight light;
    light.place = {true, {0, 0, 50}};
    light.intensity = {100, 200, 300};
    light.emission_exponent = 2;
    // Directly below: 1/r^2; at the 3-4-5 triangle: cos = 4/5 at r = 62.5.
    EXPECT_TRUE(near(arrival(light, {0, 0, 0}).irradiance_per_cosine, {0.04, 0.08, 0.12}, 1e-15));
    const Arrival aside = arrival(light, {-37.5, 0, 0});
    EXPECT_TRUE(near(aside.to_light, {0.6, 0, 0.8}));
    EXPECT_NEAR(aside.irradiance_per_cosine[0], 100 * 0.64 / (62.5 * 62.5), 1e-15);
    light.emission_axis = {0, 0, 1};  // it shines away from the sample
    EXPECT_EQ(arrival(light, {0, 0, 0}).irradiance_per_cosine[0], 0.0);
    light.emission_exponent = 0;  // without a lobe the axis has no effect
    EXPECT_NEAR(arrival(light, {0, 0, 0}).irradiance_per_cosine[0], 0.04, 1e-15);
}

// The plane below a source of intensity cos^m receives all of its power, 2 pi / (m + 1) by the
// integral over the hemisphere.
TEST(RigGeometry, PlaneBelowCatchesThePowerOfTheLight) {
    for (const double m : {0.5, 1.0, 3.0}) {
        RigLight light;
        light.place = {true, {0, 0, 10}};
        light.emission_exponent = m;
        double power = 0.0;
        // Rings with equal steps of the angle at the light: r = 10 tan a, dr = 10 / cos^2 a da.
        constexpr int kSteps = 20000;
        const double da = std::numbers::pi / 2 / kSteps;
        for (int k = 0; k < kSteps; ++k) {
            const double a = (k + 0.5) * da;
            const double r = 10 * std::tan(a), dr = 10 / (std::cos(a) * std::cos(a)) * da;
            const Arrival at = arrival(light, {r, 0, 0});
            power += at.irradiance_per_cosine[0] * at.to_light[2] * 2 * std::numbers::pi * r * dr;
        }
        // The midpoint rule has an error of da^1.5 at the square root's end for m = 0.5.
        EXPECT_NEAR(power, 2 * std::numbers::pi / (m + 1), 1e-5) << m;
    }
}

TEST(RigGeometry, FarLightIsTheSameEverywhere) {
    RigLight light;
    light.place = {false, {0.6, 0, 0.8}};
    light.intensity = {1, 2, 3};
    const Arrival at = arrival(light, {500, -300, 0});
    EXPECT_EQ(at.to_light, light.place.at);
    EXPECT_EQ(at.irradiance_per_cosine, light.intensity);
}

TEST(RigFile, IsToldByExtensionOrFormat) {
    const ScratchFolder folder;
    EXPECT_TRUE(is_rig_file(folder.write("a.LP", "")));
    EXPECT_TRUE(is_rig_file(folder.write("a.dome", "{}")));
    EXPECT_TRUE(is_rig_file(folder.write("a.json", rig_of(kLights))));
    EXPECT_FALSE(is_rig_file(folder.write("b.json", R"({"format": "burnish-scene"})")));
    EXPECT_FALSE(is_rig_file(folder / "none.json"));
}

}  // namespace
}  // namespace burnish
