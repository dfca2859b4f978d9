// Stacks of 25 lights: a table has more cells than a point has samples, and diffuse light cannot be
// told from a broad part of the distribution. The truth is a GGX lobe (Walter et al. 2007) of alpha
// 0.25 with F(1) = 0.04 on a painted ground, flat or waved, under a camera on the normal.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "capture/solve/capture_fit.hpp"
#include "capture/solve/shading_normal.hpp"
#include "core/constants.hpp"

namespace burnish::test {
namespace {

constexpr double kAlpha = 0.25, kF0 = 0.04;
constexpr int kWidth = 20, kHeight = 15;

Vec3d unit(const Vec3d& v) {
    const double length = std::hypot(v[0], v[1], v[2]);
    return {v[0] / length, v[1] / length, v[2] / length};
}

double dot(const Vec3d& a, const Vec3d& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Four rings of lights, as domes have them.
Rig few_lights() {
    Rig rig;
    rig.width_mm = 40.0;
    rig.height_mm = 30.0;
    rig.intensity_stated = true;
    for (const auto& [elevation_deg, count] : {std::pair(25, 8), {45, 8}, {65, 6}, {80, 3}})
        for (int k = 0; k < count; ++k) {
            const double turn = 2.0 * kPi * (k + 0.0075 * elevation_deg) / count;
            const double e = elevation_deg * kDegree;
            RigLight light;
            light.place.at = {std::cos(e) * std::cos(turn), std::cos(e) * std::sin(turn),
                              std::sin(e)};
            rig.lights.push_back(light);
        }
    return rig;
}

Vec3d wave_normal(int x, int y, double slope) {
    const double u = 4.0 * (x + 0.5) / kWidth - 2.0, v = 3.0 * (y + 0.5) / kHeight - 1.5;
    return unit({-slope * std::cos(3.0 * u), -slope * std::sin(3.0 * v), 1.0});
}

double albedo(int x, int y) {
    return (x / 5 + y / 5) % 2 == 0 ? 0.2 : 0.35;
}

double radiance(const Vec3d& n, const Vec3d& to_light, double ground, double f0) {
    const Vec3d eye{0.0, 0.0, 1.0};
    const Vec3d h = unit({to_light[0], to_light[1], to_light[2] + 1.0});
    const double nh = dot(n, h), a2 = kAlpha * kAlpha;
    const double d = a2 / (kPi * std::pow(nh * nh * (a2 - 1.0) + 1.0, 2.0));
    const auto g1 = [&](double c) { return 2.0 * c / (c + std::sqrt(a2 + (1.0 - a2) * c * c)); };
    const double ni = dot(n, to_light), no = dot(n, eye);
    const double f = f0 + (1.0 - f0) * std::pow(1.0 - dot(h, eye), 5.0);
    return ground / kPi * ni + f * d * g1(ni) * g1(no) / (4.0 * no);
}

std::vector<Image> wave_pictures(const Rig& rig, double slope, double f0) {
    std::vector<Image> pictures;
    for (const RigLight& light : rig.lights) {
        Image picture(kWidth, kHeight, 3, 0.0f);
        for (int y = 0; y < kHeight; ++y)
            for (int x = 0; x < kWidth; ++x)
                std::fill_n(picture.at(x, y), 3,
                            static_cast<float>(radiance(wave_normal(x, y, slope), light.place.at,
                                                        albedo(x, y), f0)));
        pictures.push_back(std::move(picture));
    }
    return pictures;
}

struct Fitted {
    double unexplained = 0.0, specular = 0.0, diffuse = 0.0;  // strengths: means over the texels
    double tilt_error_deg = 0.0;                              // mean
    double training_error = 0.0, tilted_error = 1.0;
};

Fitted fit(double slope, bool normals, std::uint64_t seed) {
    const Rig rig = few_lights();
    CaptureFitSettings settings;
    settings.eta = 1.5;
    settings.models = false;
    settings.normals = normals;
    settings.seed = seed;
    CaptureFit one(rig, wave_pictures(rig, slope, kF0), {}, settings, {});
    one.find_exemplars();
    one.fit_texels();
    const TabulatedMaterial m = one.material();
    Fitted out;
    out.unexplained = one.unexplained();
    out.training_error = one.report().training_error;
    out.tilted_error = one.report().tilted_error;
    const double count = kWidth * kHeight;
    for (int y = 0; y < kHeight; ++y)
        for (int x = 0; x < kWidth; ++x) {
            const std::size_t t = static_cast<std::size_t>(y * kWidth + x);
            const float* n = m.normal.pixels.data() + 3 * t;
            const Vec3d found{static_cast<double>(n[0]), static_cast<double>(n[1]),
                              static_cast<double>(n[2])};
            out.specular += static_cast<double>(m.specular.pixels[3 * t]) / count;
            out.diffuse += static_cast<double>(m.diffuse.pixels[3 * t]) / count;
            out.tilt_error_deg +=
                std::acos(std::min(dot(found, wave_normal(x, y, slope)), 1.0)) / kDegree / count;
        }
    return out;
}

// Slopes up to 0.05, 4 degrees. A flat fit explains the waves by leaning exemplars. Before the step
// along the diffuse direction was damped, the highlight was lost, with 14 % unexplained.
TEST(FewLights, AHighlightOnWavesIsNotLost) {
    for (const std::uint64_t seed : {1, 2}) {
        const Fitted flat = fit(0.05, false, seed);
        EXPECT_LT(flat.unexplained, 0.03) << seed;
        // The trial of normals tells that the sample is not flat (capture_fit_judge.cpp).
        EXPECT_LT(flat.tilted_error, 0.5 * flat.training_error) << seed;
        // What is seen of the lobe: k_s is that of the truth within a factor of 2.
        EXPECT_GT(flat.specular, 0.5 * kF0) << seed;
        EXPECT_LT(flat.specular, 2.0 * kF0) << seed;
    }
}

// Slopes up to 0.12, tilts up to 9.6 degrees and 6.3 on average.
TEST(FewLights, NormalsOfWavesAreFoundWithEverySeed) {
    for (const std::uint64_t seed : {0, 1, 2}) {
        const Fitted tilted = fit(0.12, true, seed);
        EXPECT_LT(tilted.unexplained, 0.02) << seed;
        EXPECT_LT(tilted.tilt_error_deg, 1.5) << seed;  // a quarter of the mean tilt
        EXPECT_NEAR(tilted.diffuse, 0.275, 0.03) << seed;
        EXPECT_GT(tilted.specular, 0.5 * kF0) << seed;
        EXPECT_LT(tilted.specular, 2.0 * kF0) << seed;
    }
}

// A matte ground with a highlight of alpha 0.25 at 0.04: the normal is that of the diffuse light.
TEST(ShadingNormal, IsThatOfTheDiffuseLight) {
    const Rig rig = few_lights();
    const LightGeometry geometry(rig, 1, 1);
    PointLights lights;
    geometry.at(0, lights);
    for (const double f0 : {0.0, kF0})
        for (int x = 0; x < kWidth; ++x) {
            const Vec3d truth = wave_normal(x, 4, 0.12);
            std::vector<float> values;
            for (const RigLight& light : rig.lights)
                values.insert(values.end(), 3,
                              static_cast<float>(radiance(truth, light.place.at, 0.3, f0)));
            PointSamples samples;
            gather_samples(lights, {0.0f, 0.0f, 1.0f}, values, {}, {}, samples);
            const Vec3f found = shading_normal(samples);
            const double cosine = truth[0] * static_cast<double>(found[0]) +
                                  truth[1] * static_cast<double>(found[1]) +
                                  truth[2] * static_cast<double>(found[2]);
            // Exact without a highlight but for single precision; with one, its skirts remain: a
            // fifth of the largest tilt.
            EXPECT_LT(std::acos(std::min(cosine, 1.0)) / kDegree, f0 > 0.0 ? 2.0 : 0.1) << x;
        }
}

TEST(ShadingNormal, IsUprightWhereNothingIsKnown) {
    const Rig rig = few_lights();
    const LightGeometry geometry(rig, 1, 1);
    PointLights lights;
    geometry.at(0, lights);
    const std::vector<float> black(3 * rig.lights.size(), 0.0f);
    PointSamples samples;
    gather_samples(lights, {0.0f, 0.0f, 1.0f}, black, {}, {}, samples);
    EXPECT_EQ(shading_normal(samples)[2], 1.0f);
    EXPECT_EQ(shading_normal({})[2], 1.0f);
}

}  // namespace
}  // namespace burnish::test
