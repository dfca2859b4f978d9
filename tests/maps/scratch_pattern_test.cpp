// Properties of the whole pattern: no seams, lattices or repeats, and the requested directions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "scratch_support.hpp"

namespace burnish {
namespace {

// Mean square of the differences between column x and the next, or between rows.
std::vector<double> steps(const ScratchMaps& maps, bool between_rows) {
    const int n = maps.size;
    std::vector<double> sums(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
            const int next = (i + 1) % n;
            const double a =
                static_cast<double>(between_rows ? *maps.height.at(j, i) : *maps.height.at(i, j));
            const double b = static_cast<double>(between_rows ? *maps.height.at(j, next)
                                                              : *maps.height.at(next, j));
            sums[static_cast<std::size_t>(i)] += (a - b) * (a - b) / n;
        }
    }
    return sums;
}

class Pattern : public testing::TestWithParam<std::string_view> {};

TEST_P(Pattern, HasNoStepAtTheEdgeOfTheTile) {
    const ScratchMaps maps = preset_maps(GetParam(), 512);
    for (const bool rows : {false, true}) {
        std::vector<double> all = steps(maps, rows);
        const double seam = all.back();
        std::nth_element(all.begin(), all.begin() + 500, all.end());
        // The seam is no steeper than the 12th steepest of the 512 steps inside.
        EXPECT_LE(seam, all[500] * 1.0001) << rows;
    }
}

// Largest autocorrelation of the height over shifts of the tile: a lattice or a repeated motif
// shows as a peak away from 0. `along_x`: lines of one direction correlate along themselves by
// nature, so only shifts across them count.
double largest_correlation(const ScratchMaps& maps, int least_x, int least_y) {
    const int n = maps.size;
    double mean = 0.0;
    for (const float h : maps.height.pixels) mean += static_cast<double>(h) / (n * n);
    std::vector<float> centered(maps.height.pixels.size());
    double variance = 0.0;
    for (std::size_t i = 0; i < centered.size(); ++i) {
        centered[i] = static_cast<float>(static_cast<double>(maps.height.pixels[i]) - mean);
        variance += static_cast<double>(centered[i] * centered[i]);
    }
    double largest = 0.0;
    for (int sy = 0; sy <= n / 2; sy += 1) {
        for (int sx = -n / 2; sx < n / 2; sx += 1) {
            if (std::abs(sx) < least_x && sy < least_y) continue;
            // A third of the shifts suffices, because peaks are wider.
            if ((std::abs(sx) + sy) % 3 != 0) continue;
            double sum = 0.0;
            for (int y = 0; y < n; y += 2) {
                const float* a = centered.data() + static_cast<std::size_t>(y * n);
                const float* b = centered.data() + static_cast<std::size_t>((y + sy) % n * n);
                for (int x = 0; x < n; x += 2)
                    sum += static_cast<double>(a[x] * b[(x + sx + n) % n]);
            }
            largest = std::max(largest, 4.0 * sum / variance);
        }
    }
    return largest;
}

TEST(ScratchLattice, ThereIsNoneInTheRandomPresets) {
    // 128 texels of 0.39 mm: 2,000 to 3,000 strokes blur into noise. Its random peaks, over 5,000
    // shifts with some hundreds of independent patches, stay below 0.25.
    for (const std::string_view name : {"fine-random", "swirl-marks", "deep-gouges"}) {
        const ScratchMaps maps = preset_maps(name, 128);
        EXPECT_LT(largest_correlation(maps, 12, 12), 0.3) << name;
    }
}

TEST(ScratchLattice, TheTestSeesOne) {
    // A motif that occurs twice, a quarter of the tile apart.
    ScratchMaps maps = preset_maps("fine-random", 128);
    const Image once = maps.height;
    for (int y = 0; y < 128; ++y)
        for (int x = 0; x < 128; ++x)
            *maps.height.at(x, y) += *once.at((x + 32) % 128, (y + 34) % 128);
    EXPECT_GT(largest_correlation(maps, 12, 12), 0.45);
}

// The slopes of straight strokes at angle a are along their normals: the major axis of E[s s^T] is
// across the grooves.
double groove_angle_deg(const ScratchMaps& maps) {
    const SlopeMoments& m = maps.moments.back().texels.front();
    const double across =
        0.5 * std::atan2(2.0 * static_cast<double>(m.sxy), static_cast<double>(m.sxx - m.syy));
    const double groove = across * 180.0 / std::numbers::pi + 90.0;
    return groove > 90.0 ? groove - 180.0 : groove;
}

TEST(ScratchFields, AConstantOneIsCounterClockwiseWithYUp) {
    for (const double angle : {0.0, 20.0, 70.0, -40.0}) {
        ScratchSettings settings = one_layer(512, 200, 12, 0.4, 0.02);
        settings.layers[0].field = ScratchField::constant;
        settings.layers[0].angle_deg = angle;
        settings.layers[0].range_deg = 3.0;
        const ScratchMaps maps = made(settings);
        EXPECT_NEAR(groove_angle_deg(maps), angle, 1.0);
        const float* line = maps.direction.at(17, 300);
        EXPECT_NEAR(0.5 * std::atan2(line[1], line[0]) * 180 / std::numbers::pi, angle, 3.01);
    }
}

TEST(ScratchFields, CircularAndRadialOnesAre) {
    for (const ScratchField field : {ScratchField::circular, ScratchField::radial}) {
        ScratchSettings settings = one_layer(512, 400, 8, 0.4, 0.02);
        settings.layers[0].field = field;
        const ScratchMaps maps = made(settings);
        double radial = 0.0, around = 0.0;
        for (int y = 0; y < 512; ++y) {
            for (int x = 0; x < 512; ++x) {
                const double px = x - 255.5, py = 255.5 - y, r = std::hypot(px, py);
                if (r < 20) continue;
                const auto [sx, sy] = slope_at(maps, x, y);
                const double out =
                    (static_cast<double>(sx) * px + static_cast<double>(sy) * py) / r;
                const double side =
                    (static_cast<double>(sy) * px - static_cast<double>(sx) * py) / r;
                radial += out * out;
                around += side * side;
            }
        }
        // Grooves slope across themselves, and along themselves only at their ends.
        const bool rings = field == ScratchField::circular;
        EXPECT_GT(rings ? radial : around, 50 * (rings ? around : radial));
    }
}

TEST(ScratchFields, AnImageSteersThemAndArrowsAreLines) {
    // Left half at 30 degrees, right half at -60, with the arrow of every other texel reversed.
    ScratchInputs inputs;
    inputs.direction = Image(64, 64, 3, 0.0f);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) {
            const double angle = (x < 32 ? 30.0 : -60.0) * std::numbers::pi / 180.0;
            const double sign = (x + y) % 2 == 0 ? 1.0 : -1.0;
            inputs.direction.at(x, y)[0] = static_cast<float>(0.5 + 0.5 * sign * std::cos(angle));
            inputs.direction.at(x, y)[1] = static_cast<float>(0.5 + 0.5 * sign * std::sin(angle));
        }
    }
    ScratchSettings settings = one_layer(256, 300, 3, 0.4, 0.02);
    settings.layers[0].field = ScratchField::image;
    const ScratchMaps maps = made(settings, inputs);
    std::complex<double> left = 0.0, right = 0.0;
    for (int y = 0; y < 256; ++y) {
        for (int x = 0; x < 256; ++x) {
            const auto [sx, sy] = slope_at(maps, x, y);
            const std::complex<double> s(static_cast<double>(sx), static_cast<double>(sy));
            if (x > 20 && x < 108) left += s * s;
            if (x > 148 && x < 236) right += s * s;
        }
    }
    // Slopes are across the grooves, at 120 and 30 degrees; the square doubles the angle.
    EXPECT_NEAR(std::arg(left) * 180 / std::numbers::pi, 240.0 - 360.0, 6.0);
    EXPECT_NEAR(std::arg(right) * 180 / std::numbers::pi, 60.0, 6.0);
}

TEST(ScratchMask, LeavesTheUnwornAloneAndKeepsAShareOfTheRest) {
    ScratchInputs inputs;
    inputs.wear_mask = Image(90, 90, 1);  // a different size from the map's
    for (int y = 0; y < 90; ++y)
        for (int x = 0; x < 90; ++x)
            *inputs.wear_mask.at(x, y) = x < 30 ? 0.0f : x < 60 ? 0.5f : 1.0f;
    ScratchSettings settings = one_layer(256, 3000, 2, 0.2, 0.01);
    const ScratchMaps maps = made(settings, inputs);
    double covered[3] = {};
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x) {
            const int third = x * 3 / 256;
            const int into = x - third * 256 / 3;
            if (into < 12 || into > 72) continue;  // the mask is interpolated at its edges
            covered[third] += *maps.height.at(x, y) < 0.0f ? 1.0 : 0.0;
        }
    EXPECT_EQ(covered[0], 0.0);
    // Random strokes cover 1 - exp(-density), so the exponent of the half-worn third is half. Its
    // own noise, from some 250 strokes, is 6 % in each of two numbers.
    const double area = 61.0 * 256.0;
    const double half = -std::log(1.0 - covered[1] / area),
                 full = -std::log(1.0 - covered[2] / area);
    EXPECT_NEAR(half / full, 0.5, 0.12);
}

INSTANTIATE_TEST_SUITE_P(Scratch, Pattern,
                         testing::ValuesIn(scratch_preset_names().begin(),
                                           scratch_preset_names().end()),
                         [](const auto& given) {
                             std::string name(given.param);
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

}  // namespace
}  // namespace burnish
