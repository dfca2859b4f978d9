// Stacks in which a part is missing altogether: no highlight, no difference between pictures or
// pixels, one direction of light, one pixel. Each gives a material of finite numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "burnish/capture_fit.hpp"
#include "core/constants.hpp"

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

}  // namespace
}  // namespace burnish::test
