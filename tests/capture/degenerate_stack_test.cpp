// Stacks in which a part is missing altogether: no highlight, no difference between pictures or
// pixels, one direction of light, one pixel, the unit of the pictures. Each gives a material that
// can be written, or is refused in a line before the fit.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "burnish/capture_fit.hpp"
#include "burnish/error.hpp"
#include "burnish/relight.hpp"
#include "burnish/tabulated_file.hpp"
#include "capture/stack/light_level.hpp"
#include "core/constants.hpp"
#include "support/test_folder.hpp"

namespace burnish::test {
namespace {

Rig distant_lights(const std::vector<Vec3d>& directions) {
    Rig rig;
    rig.width_mm = rig.height_mm = 10.0;
    for (const Vec3d& d : directions) {
        RigLight light;
        const double length = std::hypot(d[0], d[1], d[2]);
        light.place.at = {d[0] / length, d[1] / length, d[2] / length};
        rig.lights.push_back(light);
    }
    return rig;
}

const std::vector<Vec3d> kFourSides = {{1, 0, 1}, {0, 1, 1}, {-1, 0, 1}, {0, -1, 1}};

// Of each light: value(light, x, y) in all channels.
std::vector<Image> pictures_of(const Rig& rig, int size,
                               const std::function<double(std::size_t, int, int)>& value) {
    std::vector<Image> pictures;
    for (std::size_t k = 0; k < rig.lights.size(); ++k) {
        Image picture(size, size, 3, 0.0f);
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x)
                for (int c = 0; c < 3; ++c)
                    picture.at(x, y)[c] = static_cast<float>(value(k, x, y));
        pictures.push_back(std::move(picture));
    }
    return pictures;
}

void expect_finite(const TabulatedMaterial& m) {
    const auto finite = [](const std::vector<float>& values) {
        return std::all_of(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
    };
    EXPECT_GE(m.exemplars, 1);
    EXPECT_TRUE(finite(m.D));
    EXPECT_TRUE(finite(m.diffuse.pixels));
    EXPECT_TRUE(finite(m.specular.pixels));
    EXPECT_TRUE(finite(m.normal.pixels));
    EXPECT_TRUE(finite(m.angle));
    const ScratchFolder folder;
    write_tabulated_material(folder / "m.exr", m);  // throws for what a file cannot hold
}

TabulatedMaterial fit(const Rig& rig, const std::vector<Image>& pictures, bool normals) {
    CaptureFitSettings settings;
    settings.normals = normals;
    TabulatedMaterial m = fit_capture(rig, pictures, {}, settings);
    expect_finite(m);
    // Every one of these stacks shows some light.
    const auto sum = [](const Image& image) {
        return std::accumulate(image.pixels.begin(), image.pixels.end(), 0.0);
    };
    EXPECT_GT(sum(m.diffuse) + sum(m.specular), 0.0);
    return m;
}

class DegenerateStack : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Normals, DegenerateStack, testing::Bool(),
                         [](const auto& instance) { return instance.param ? "Tilt" : "Flat"; });

// A card of albedo 0.6: I = albedo (n.i) / pi under a distant light of intensity 1.
TEST_P(DegenerateStack, AMatteCardIsDiffuse) {
    const Rig rig = distant_lights(kFourSides);
    const double albedo = 0.6;
    const auto pictures = pictures_of(
        rig, 8, [&](std::size_t k, int, int) { return albedo * rig.lights[k].place.at[2] / kPi; });
    const TabulatedMaterial m = fit(rig, pictures, GetParam());
    for (const float diffuse : m.diffuse.pixels) EXPECT_NEAR(diffuse, albedo, 0.01 * albedo);
    for (const float specular : m.specular.pixels) EXPECT_LT(specular, 0.01);
}

TEST_P(DegenerateStack, PicturesThatAreAllAlike) {
    const Rig rig = distant_lights({{1, 0, 1}, {0, 1, 2}, {-1, 0, 4}, {0.2, -1, 3}});
    fit(rig, pictures_of(rig, 8, [](std::size_t, int, int) { return 0.25; }), GetParam());
}

TEST_P(DegenerateStack, OnePictureWithLight) {
    const Rig rig = distant_lights(kFourSides);
    fit(rig, pictures_of(rig, 8, [](std::size_t k, int, int) { return k == 2 ? 0.5 : 0.0; }),
        GetParam());
}

TEST_P(DegenerateStack, OnePixelWithLight) {
    const Rig rig = distant_lights(kFourSides);
    fit(rig,
        pictures_of(rig, 8, [](std::size_t, int x, int y) { return x == 3 && y == 5 ? 0.5 : 0.0; }),
        GetParam());
}

TEST_P(DegenerateStack, OnePixel) {
    const Rig rig = distant_lights(kFourSides);
    fit(rig, pictures_of(rig, 1, [](std::size_t k, int, int) { return 0.1 + 0.05 * double(k); }),
        GetParam());
}

TEST_P(DegenerateStack, OneDirectionOfLight) {
    const Rig rig = distant_lights({{1, 0, 1}, {1, 0, 1}, {1, 0, 1}});
    fit(rig, pictures_of(rig, 8, [](std::size_t, int x, int) { return 0.1 + 0.01 * x; }),
        GetParam());
}

// ---- the unit of the pictures

// Lamps at positions in mm; a card of the given albedo and gradient under lamps of `intensity`.
Rig near_lights() {
    Rig rig;
    rig.width_mm = rig.height_mm = 100.0;
    for (const Vec3d& at : {Vec3d{200, 0, 300}, Vec3d{0, 250, 280}, Vec3d{-220, 30, 350},
                            Vec3d{40, -260, 320}, Vec3d{10, 5, 400}}) {
        RigLight light;
        light.place = {true, at};
        rig.lights.push_back(light);
    }
    return rig;
}

std::vector<Image> card_pictures(const Rig& rig, int size, double intensity) {
    return pictures_of(rig, size, [&](std::size_t k, int x, int y) {
        const double albedo = 0.2 + 0.3 * x / std::max(size - 1, 1);
        const Arrival in = arrival(rig.lights[k], sample_point(rig, size, size, x, y));
        return albedo / kPi * in.to_light[2] * in.irradiance_per_cosine[0] * intensity;
    });
}

// Largest difference of relit pictures from those of the fit, relative to the brightest pixel.
double relit_difference(const TabulatedMaterial& m, const Rig& rig,
                        const std::vector<Image>& pictures) {
    Rig relit = rig;
    multiply_intensities(relit, recorded_factor(m.metadata, rig));
    const Relighter relighter(m);
    double worst = 0.0, most = 0.0;
    for (std::size_t k = 0; k < rig.lights.size(); ++k) {
        const Image picture = relighter.picture(relit, k);
        for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
            const auto truth = static_cast<double>(pictures[k].pixels[i]);
            worst = std::max(worst, std::abs(static_cast<double>(picture.pixels[i]) - truth));
            most = std::max(most, truth);
        }
    }
    return worst / most;
}

// In mm an intensity of 1 makes the card a hundred thousand times as bright as a white diffuser.
TEST_P(DegenerateStack, NearLightsOfNoStatedIntensityGetOneFromThePictures) {
    const Rig rig = near_lights();
    const auto pictures = card_pictures(rig, 8, 1e5);
    const TabulatedMaterial m = fit(rig, pictures, GetParam());
    // Its brightest pixels have an albedo of 0.5, and are chosen to have that of white paper. The
    // percentile lies within the columns of the brightest pixels.
    const float brightest = *std::max_element(m.diffuse.pixels.begin(), m.diffuse.pixels.end());
    EXPECT_NEAR(static_cast<double>(brightest), kChosenBrightness, 0.02);
    EXPECT_NEAR(std::stod(m.metadata.at("burnish:chosen_intensity")), 1e5 * 0.5 / kChosenBrightness,
                2e3);
    EXPECT_LT(relit_difference(m, rig, pictures), 0.01);
}

// The material does not depend on the unit of the pictures, and relit pictures come out in it. Units
// near 1e-6 make the card plausible as it is, and are left alone.
TEST_P(DegenerateStack, HugeAndTinyUnits) {
    const Rig rig = near_lights();
    const TabulatedMaterial usual = fit(rig, card_pictures(rig, 4, 1e5), GetParam());
    for (const double unit : {1e-12, 1e6}) {
        const auto pictures = card_pictures(rig, 4, 1e5 * unit);
        const TabulatedMaterial m = fit(rig, pictures, GetParam());
        // Five lights hardly tell a tilt from a color: there rounding decides by up to a tenth.
        for (std::size_t i = 0; i < m.diffuse.pixels.size(); ++i)
            EXPECT_NEAR(m.diffuse.pixels[i], usual.diffuse.pixels[i], GetParam() ? 0.1 : 0.01)
                << unit;
        // The fit leaves up to 1.5 % of the brightest sample unexplained, in any unit.
        EXPECT_LT(relit_difference(m, rig, pictures), 0.02) << unit;
    }
}

TEST_P(DegenerateStack, AnAbsurdUnitOfAnyOtherDegenerateStack) {
    const Rig rig = distant_lights(kFourSides);
    for (const double unit : {1e-6, 1e6}) {
        fit(rig, pictures_of(rig, 8, [&](std::size_t, int, int) { return 0.25 * unit; }),
            GetParam());
        fit(rig, pictures_of(rig, 8, [&](std::size_t k, int, int) { return k == 2 ? unit : 0.0; }),
            GetParam());
        fit(rig,
            pictures_of(rig, 8,
                        [&](std::size_t, int x, int y) { return x == 3 && y == 5 ? unit : 0.0; }),
            GetParam());
        fit(rig, pictures_of(rig, 1, [&](std::size_t k, int, int) { return unit * double(k + 1); }),
            GetParam());
    }
}

TEST_P(DegenerateStack, ThreeLights) {
    const Rig rig = distant_lights({{1, 0, 1}, {0, 1, 1}, {-1, -1, 1}});
    fit(rig,
        pictures_of(rig, 8, [](std::size_t k, int x, int) { return 0.1 + 0.02 * x * double(k); }),
        GetParam());
}

// A broken pixel of a sensor: a color beyond half floats is cut, not refused after the fit.
TEST_P(DegenerateStack, OnePixelAMillionTimesAsBright) {
    const Rig rig = distant_lights(kFourSides);
    const TabulatedMaterial m =
        fit(rig,
            pictures_of(rig, 16,
                        [](std::size_t, int x, int y) { return x == 3 && y == 5 ? 1e6 : 0.1; }),
            GetParam());
    // The others keep their light: codes of the square root hold 1e-7 of the brightest to 5 %.
    EXPECT_NEAR(Relighter(m).picture(rig, 0).at(0, 0)[0], 0.1f, 0.006f);
    EXPECT_EQ(*std::max_element(m.diffuse.pixels.begin(), m.diffuse.pixels.end()), 65504.0f);
}

// Whatever is written is in the units of stated intensities.
TEST(StatedIntensity, IsKeptOrRefusedBeforeTheFit) {
    Rig rig = near_lights();
    multiply_intensities(rig, 1e5);
    ASSERT_TRUE(rig.intensity_stated);
    Rig plain = near_lights();
    const TabulatedMaterial m = fit_capture(rig, card_pictures(plain, 8, 3e5));
    EXPECT_FALSE(m.metadata.contains("burnish:chosen_intensity"));
    // 3 x the albedo of 0.5: whiter than white, as stated.
    EXPECT_NEAR(*std::max_element(m.diffuse.pixels.begin(), m.diffuse.pixels.end()), 1.5f, 0.02f);

    plain.intensity_stated = true;  // of 1
    bool fitted = false;
    const Progress progress(
        [&](std::string_view stage, double) { fitted = fitted || stage != "reading pictures"; });
    for (const double intensity : {1e8, 1e-8}) {
        const std::string line = error_line(
            [&] { fit_capture(plain, card_pictures(plain, 8, intensity), {}, {}, progress); });
        EXPECT_NE(line.find("intensity: expected intensities"), line.npos) << line;
    }
    EXPECT_FALSE(fitted);
}

// Beyond what single precision squares.
TEST(StatedIntensity, PicturesInAbsurdUnitsAreRefused) {
    const Rig rig = distant_lights(kFourSides);
    for (const double unit : {1e-20, 1e20}) {
        const std::string line = error_line([&] {
            fit_capture(rig, pictures_of(rig, 4, [&](std::size_t, int, int) { return unit; }));
        });
        EXPECT_NE(line.find("pictures: expected pictures whose brightest sample"), line.npos)
            << line;
    }
}

// Far lights of intensity 1 under which a card is darker than white: nothing is absurd.
TEST(StatedIntensity, IsNotMissedWhereThePicturesArePlausible) {
    const Rig rig = distant_lights(kFourSides);
    const TabulatedMaterial m =
        fit_capture(rig, pictures_of(rig, 4, [](std::size_t, int, int) { return 0.02; }));
    EXPECT_TRUE(m.metadata.empty());
    EXPECT_NEAR(m.diffuse.pixels[0], kPi * 0.02 * std::sqrt(2.0), 0.001);
}

TEST(RecordedLevel, IsThatOfTheFitOrOfItsIrradiance) {
    Rig rig = near_lights();
    std::map<std::string, std::string> metadata;
    Rig fitted = rig;
    multiply_intensities(fitted, 5e4);
    record_level({1e5, 5e4}, fitted, metadata);
    EXPECT_EQ(recorded_factor(metadata, rig), 5e4);
    rig.lights.pop_back();  // fewer of the same lamps
    EXPECT_EQ(recorded_factor(metadata, rig), 5e4);
    EXPECT_EQ(recorded_factor({}, rig), 1.0);
    EXPECT_EQ(recorded_factor(metadata, fitted), 1.0);  // states its own
    // Far lights of intensity 1 have an irradiance of 1: they get the fit's, I / r^2 in the mean.
    double mean = 0.0;
    for (const RigLight& light : near_lights().lights) {
        const Vec3d& p = light.place.at;
        mean += 5e4 / (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / 5.0;
    }
    EXPECT_NEAR(recorded_factor(metadata, distant_lights(kFourSides)), mean, 1e-9);
}

}  // namespace
}  // namespace burnish::test
