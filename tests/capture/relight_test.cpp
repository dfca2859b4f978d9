// Relighting compared with the closed forms of simulated samples, and errors compared with known
// noise.
#include "burnish/relight.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "burnish/image_io.hpp"
#include "capture/judge/relight_compare.hpp"
#include "support/program.hpp"
#include "tabulate_sample.hpp"
#include "truth_metrics.hpp"

namespace burnish::test {
namespace {

VirtualSample sample_of(std::string_view preset, double tilt_deg) {
    VirtualSettings settings;
    settings.width = 24;
    settings.height = 16;
    settings.width_mm = 30.0;
    settings.tilt_deg = tilt_deg;
    return make_virtual_sample(preset, settings);
}

// Largest and mean difference relative to the brightest and the mean sample.
struct Difference {
    double worst = 0.0, mean = 0.0;
};
Difference difference(const Image& a, const Image& truth) {
    double worst = 0.0, sum = 0.0, total = 0.0, most = 0.0;
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
        const auto t = static_cast<double>(truth.pixels[i]);
        const double d = std::abs(static_cast<double>(a.pixels[i]) - t);
        worst = std::max(worst, d);
        most = std::max(most, t);
        sum += d;
        total += t;
    }
    return {worst / most, sum / total};
}

// The areas on their 16 x 32 nodes have errors up to 0.003 (ndf_grid.hpp), which is a large
// relative error near the horizon where g is small: at most 0.3 % of the brightest sample here, and
// 0.17 % in the mean (velvet). Tables of 256 rings have smaller errors for these lobes.
constexpr double kWorst = 0.005, kMean = 0.0025;

TEST(Relight, IsTheClosedFormOfATabulatedSample) {
    for (const auto& preset : virtual_presets())
        for (const double tilt : {0.0, 8.0}) {
            const VirtualSample sample = sample_of(preset.name, tilt);
            const TabulatedMaterial material = tabulated(sample, {256, 512});
            const Rig rig = make_bar_rig(sample, 5, 3, {30.0, 300.0});
            const Relighter relighter(material);
            for (std::size_t k = 0; k < rig.lights.size(); ++k) {
                const Difference d =
                    difference(relighter.picture(rig, k), virtual_picture(sample, rig, k, {}));
                EXPECT_LT(d.worst, kWorst) << preset.name << ", tilt " << tilt << ", light " << k;
                EXPECT_LT(d.mean, kMean) << preset.name << ", tilt " << tilt << ", light " << k;
            }
        }
}

TEST(Relight, ALightsOwnCameraTakesThePlaceOfTheRigs) {
    const VirtualSample sample = sample_of(virtual_presets().front().name, 0.0);
    const TabulatedMaterial material = tabulated(sample, {256, 512});
    Rig rig = make_dome_rig(sample, 6, {0.0, 0.0});
    rig.lights[1].camera = RigPlace{true, {120.0, 60.0, 200.0}};
    rig.lights[2].camera = RigPlace{false, {0.6, 0.0, 0.8}};
    const Relighter relighter(material);
    for (std::size_t k = 0; k < 3; ++k) {
        const Difference d =
            difference(relighter.picture(rig, k), virtual_picture(sample, rig, k, {}));
        EXPECT_LT(d.worst, kWorst) << k;
        EXPECT_LT(d.mean, kMean) << k;
    }
    Rig without = rig;
    without.lights[2].camera.reset();
    EXPECT_GT(difference(relighter.picture(without, 2), relighter.picture(rig, 2)).mean, 0.05);
}

TEST(Relight, IsTheSumThatTheMaterialsFileDefines) {
    // A second derivation: truth_metrics.cpp, for flat texels.
    const VirtualSample sample = sample_of(virtual_presets().back().name, 0.0);
    const TabulatedMaterial material = tabulated(sample, {32, 96});
    const auto areas = areas_of(material);
    const Relighter relighter(material);
    const Rig rig = make_dome_rig(sample, 20, {40.0, 0.0});
    for (const RigLight& light : rig.lights)
        for (int row = 0; row < material.height; row += 5)
            for (int column = 0; column < material.width; column += 5) {
                const Vec3d expected =
                    material_brdf(material, areas, column, row, light.place.at, rig.camera.at);
                const Vec3d got =
                    relighter.brdf(static_cast<std::size_t>(row * material.width + column),
                                   light.place.at, rig.camera.at);
                for (std::size_t c = 0; c < 3; ++c)
                    EXPECT_NEAR(got[c], expected[c], 1e-5 * expected[c] + 1e-9);
            }
}

TEST(Relight, TexelsOutsideTheMaskAndBelowTheHorizonAreBlack) {
    const VirtualSample sample = sample_of(virtual_presets().front().name, 0.0);
    TabulatedMaterial material = tabulated(sample, {32, 96});
    material.exemplar[5] = TabulatedMaterial::kNoExemplar;
    // Leans away from the light, which is at 30 degrees.
    const float lean[] = {-0.9f, 0.0f, std::sqrt(1.0f - 0.81f)};
    std::copy_n(lean, 3, material.normal.pixels.begin() + 3 * 7);
    Rig rig = make_dome_rig(sample, 1, {0.0, 0.0});
    rig.lights[0].place.at = {std::sqrt(0.75), 0.0, 0.5};
    const Image picture = Relighter(material).picture(rig, 0);
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_EQ(picture.pixels[15 + c], 0.0f);
        EXPECT_EQ(picture.pixels[21 + c], 0.0f);
        EXPECT_GT(picture.pixels[18 + c], 0.0f);
    }
}

// A stack of constant pictures with known errors, and the rendered pictures.
struct KnownStack {
    Folder folder;
    TabulatedMaterial material;
    Rig rig;
    std::vector<Image> rendered;

    KnownStack() {
        const VirtualSample sample = sample_of(virtual_presets().front().name, 0.0);
        material = tabulated(sample, {8, 16});
        rig = make_dome_rig(sample, 3, {0.0, 0.0});
        for (std::size_t k = 0; k < 3; ++k) {
            // A ramp from 0 to 2: no value occurs eight times.
            Image image(material.width, material.height, 3);
            for (std::size_t i = 0; i < image.pixels.size(); ++i)
                image.pixels[i] =
                    2.0f * static_cast<float>(i) / static_cast<float>(image.pixels.size() - 1);
            rendered.push_back(image);
        }
    }
    void write(std::size_t k, const Image& image, const char* type = "exr") {
        const auto path = folder.path(fmt::format("{}.{}", k, type));
        write_image(path, image, {});
        rig.lights[k].images = {{path, 1.0}};
    }
    StackError error() {
        StackComparison comparison(rig, material);
        for (std::size_t k = 0; k < rendered.size(); ++k) comparison.add(k, rendered[k]);
        return comparison.result();
    }
};

TEST(RelightComparison, FindsTheNoiseThatWasAdded) {
    KnownStack stack;
    const double sigma[] = {0.02, 0.1, 0.05};
    for (std::size_t k = 0; k < 3; ++k) {
        Image image = stack.rendered[k];
        // The sign alternates, so that the root mean square is exactly sigma. The darkest and the
        // brightest values stay, as pictures are never negative and the peak is 2.
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            image.pixels[i] += static_cast<float>(i % 2 ? sigma[k] : -sigma[k]);
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            image.pixels[i] = std::max(image.pixels[i], 0.0f);
        }
        image.pixels.back() = 2.0f;
        stack.write(k, image);
    }
    const StackError error = stack.error();
    // 1 % to 5 % of the samples are clamped to 0 and have smaller errors.
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(error.lights[k].rmse, sigma[k], 0.05 * sigma[k]) << k;
    EXPECT_EQ(error.worst, 1u);
    EXPECT_NEAR(error.peak, 2.0 + 0.1, 0.01);  // the last but one value, minus a step, plus sigma
    EXPECT_NEAR(error.psnr_worst, 20 * std::log10(error.peak / 0.1), 0.4);
    EXPECT_NEAR(error.psnr_median, 20 * std::log10(error.peak / 0.05), 0.4);
    EXPECT_NEAR(error.psnr_mean,
                (error.lights[0].psnr + error.lights[1].psnr + error.lights[2].psnr) / 3, 1e-9);
    EXPECT_EQ(error.samples, 3 * stack.rendered[0].pixels.size());
    EXPECT_NEAR(error.rmse, std::sqrt((0.0004 + 0.01 + 0.0025) / 3), 0.003);
}

TEST(RelightComparison, TheSamePicturesAreInfinitelyAlike) {
    KnownStack stack;
    for (std::size_t k = 0; k < 3; ++k) stack.write(k, stack.rendered[k]);
    const StackError error = stack.error();
    EXPECT_EQ(error.rmse, 0.0);
    const double none = std::numeric_limits<double>::infinity();
    EXPECT_EQ(error.psnr_median, none);
    EXPECT_EQ(error.psnr_mean, none);
    EXPECT_EQ(error.psnr_worst, none);
}

TEST(RelightComparison, ClippedAndMaskedSamplesDoNotCount) {
    KnownStack stack;
    const std::size_t samples = stack.rendered[0].pixels.size();
    // Clipped at 1.5 in a float picture, which repeats its largest value.
    for (std::size_t k = 0; k < 2; ++k) {
        Image image = stack.rendered[k];
        for (float& v : image.pixels) v = std::min(v, 1.5f);
        stack.write(k, image);
    }
    // 8-bit codes clip at 1: half of the ramp is lost. The exposure is 1/8.
    Image codes = stack.rendered[2];
    for (float& v : codes.pixels) v = srgb_from_linear(std::min(v, 1.0f));
    stack.rig.response = RigResponse::srgb;
    stack.write(2, codes, "png");
    // Large errors outside the mask must not count.
    stack.material.exemplar[0] = TabulatedMaterial::kNoExemplar;
    for (auto& image : stack.rendered)
        for (std::size_t c = 0; c < 3; ++c) image.pixels[c] = 100.0f;
    const StackError error = stack.error();
    for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_NEAR(static_cast<double>(error.lights[k].samples),
                    0.75 * static_cast<double>(samples) - 3, 2.0);
        EXPECT_EQ(error.lights[k].rmse, 0.0);
        EXPECT_TRUE(std::isinf(error.lights[k].psnr));
    }
    EXPECT_NEAR(static_cast<double>(error.lights[2].samples),
                0.5 * static_cast<double>(samples) - 3, 4.0);
    // An 8-bit code spans at most 0.9 % of white; the error of uniformly distributed values is at
    // most 0.0026.
    EXPECT_LT(error.lights[2].rmse, 0.0026);
    EXPECT_NEAR(error.peak, 1.5, 0.002);
}

// A card of one value is not clipped, though all of its samples are the largest.
TEST(RelightComparison, AnEvenCardIsCompared) {
    KnownStack stack;
    for (std::size_t k = 0; k < 3; ++k) {
        stack.write(k, Image(24, 16, 3, 0.5f));
        stack.rendered[k] = Image(24, 16, 3, 0.45f);
    }
    const StackError error = stack.error();
    EXPECT_EQ(error.samples, 3u * 24 * 16 * 3);
    EXPECT_NEAR(error.rmse, 0.05, 1e-6);
}

TEST(RelightComparison, RefusesWhatCannotBeCompared) {
    KnownStack stack;
    for (std::size_t k = 0; k < 3; ++k) stack.write(k, stack.rendered[k]);
    stack.write(1, Image(5, 4, 3, 0.5f));
    expect_parts(refusal_of([&] { stack.error(); }), {"1.exr", "24 x 16", "5 x 4"});
    for (std::size_t k = 0; k < 3; ++k) stack.write(k, Image(24, 16, 3, 0.0f));
    expect_parts(refusal_of([&] { stack.error(); }), {"lights", "black"});
}

}  // namespace
}  // namespace burnish::test
