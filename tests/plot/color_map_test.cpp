// The color maps: even steps, rising lightness, for color-blind eyes too.
#include "burnish/plot/color_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "burnish/image_io.hpp"

namespace burnish::plot {
namespace {

double distance(const Rgb& x, const Rgb& y) {
    const Oklab a = oklab_of(x), b = oklab_of(y);
    return std::hypot(a.L - b.L, a.a - b.a, a.b - b.b);
}

// Total color blindness for one of the cones: Machado, Oliveira & Fernandes, "A
// Physiologically-based Model for Simulation of Color Vision Deficiency", 2009, severity 1, on
// linear light.
using Matrix = std::array<std::array<double, 3>, 3>;
constexpr Matrix kProtan = {{{0.152286, 1.052583, -0.204868},
                             {0.114503, 0.786281, 0.099216},
                             {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix kDeutan = {{{0.367322, 0.860646, -0.227968},
                             {0.280085, 0.672501, 0.047413},
                             {-0.011820, 0.042940, 0.968881}}};
constexpr Matrix kTritan = {{{1.255528, -0.076749, -0.178779},
                             {-0.078411, 0.930809, 0.147602},
                             {0.004733, 0.691367, 0.303900}}};

Rgb seen_by(const Matrix& eye, const Rgb& color) {
    const auto linear = [](double v) {
        return static_cast<double>(linear_from_srgb(static_cast<float>(v)));
    };
    const std::array<double, 3> in = {linear(color.r), linear(color.g), linear(color.b)};
    const auto out = [&](std::size_t row) {
        const double v = eye[row][0] * in[0] + eye[row][1] * in[1] + eye[row][2] * in[2];
        return static_cast<double>(srgb_from_linear(static_cast<float>(std::clamp(v, 0.0, 1.0))));
    };
    return {out(0), out(1), out(2)};
}

TEST(ColorMap, OklabGoesThereAndBack) {
    // Ottosson's own example: white is (1, 0, 0).
    EXPECT_NEAR(oklab_of(kWhite).L, 1, 1e-6);
    EXPECT_NEAR(oklab_of(kWhite).a, 0, 1e-4);
    for (const Rgb color : {Rgb{0.2, 0.5, 0.9}, Rgb{1, 0, 0}, Rgb{0.01, 0.9, 0.3}}) {
        const Rgb back = display_of(oklab_of(color));
        // The inverse matrices are published to ten digits; the curve is single precision.
        EXPECT_NEAR(back.r, color.r, 1e-4);
        EXPECT_NEAR(back.g, color.g, 1e-4);
        EXPECT_NEAR(back.b, color.b, 1e-4);
    }
}

TEST(ColorMap, StepsOfEmberAreEvenAndItsLightnessRises) {
    constexpr int kSteps = 64;
    double least = 1, most = 0;
    for (int i = 0; i < kSteps; ++i) {
        const Rgb a = sequential_color(i / double{kSteps});
        const Rgb b = sequential_color((i + 1) / double{kSteps});
        least = std::min(least, distance(a, b));
        most = std::max(most, distance(a, b));
        EXPECT_GT(oklab_of(b).L, oklab_of(a).L) << i;
        for (const Matrix& eye : {kProtan, kDeutan, kTritan})
            EXPECT_GT(oklab_of(seen_by(eye, b)).L, oklab_of(seen_by(eye, a)).L) << i;
    }
    // 2 %: chords of a curved path differ from its arcs by that at most, here.
    EXPECT_LT(most / least, 1.02);
    EXPECT_LT(oklab_of(sequential_color(0)).L, 0.15);
    EXPECT_GT(oklab_of(sequential_color(1)).L, 0.95);
}

TEST(ColorMap, WhatIsOutsideIsTheEndAndNanTheStart) {
    EXPECT_EQ(sequential_color(-3), sequential_color(0));
    EXPECT_EQ(sequential_color(7), sequential_color(1));
    EXPECT_EQ(sequential_color(std::nan("")), sequential_color(0));
    EXPECT_EQ(sequential_color(std::numeric_limits<double>::infinity()), sequential_color(1));
    EXPECT_EQ(diverging_color(-2), diverging_color(-1));
}

TEST(ColorMap, BothSidesOfTideAreEquallyDarkAndDifferInHue) {
    for (const double t : {0.25, 0.5, 0.75, 1.0}) {
        const Oklab low = oklab_of(diverging_color(-t)), high = oklab_of(diverging_color(t));
        EXPECT_NEAR(low.L, high.L, 0.03) << t;
        EXPECT_LT(low.b, -0.02) << t;
        EXPECT_GT(high.b, 0.02) << t;
    }
}

TEST(ColorMap, LinesStandOutOnWhite) {
    const auto luminance = [](const Rgb& c) {
        const auto linear = [](double v) {
            return static_cast<double>(linear_from_srgb(static_cast<float>(v)));
        };
        return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
    };
    for (std::size_t i = 0; i < 7; ++i) {
        EXPECT_GE(1.05 / (luminance(series_color(i)) + 0.05), 3) << i;  // WCAG 2, 1.4.11
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_GT(distance(series_color(i), series_color(j)), 0.1) << i << " " << j;
    }
}

}  // namespace
}  // namespace burnish::plot
