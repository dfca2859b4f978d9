// Height, normals, moments and direction of a scratch map against one another and against closed
// forms of one stroke.
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "scratch_support.hpp"

namespace burnish {
namespace {

double height_at(const ScratchMaps& maps, int x, int y) {
    const int n = maps.size;
    return static_cast<double>(*maps.height.at((x % n + n) % n, (y % n + n) % n));
}

// Slopes recomputed from the heights in double, with wrapping by remainders.
struct Slopes {
    double x, y;
};
Slopes differences(const ScratchMaps& maps, int x, int y) {
    const double mm = maps.tile_mm / maps.size;
    Slopes s{0.0, 0.0};
    for (int i = -1; i <= 1; ++i) {
        const double weight = (i == 0 ? 10.0 : 3.0) / 16.0;
        s.x += weight * (height_at(maps, x + 1, y + i) - height_at(maps, x - 1, y + i)) / (2 * mm);
        s.y += weight * (height_at(maps, x + i, y - 1) - height_at(maps, x + i, y + 1)) / (2 * mm);
    }
    return s;
}

class EveryPreset : public testing::TestWithParam<std::string_view> {};

TEST_P(EveryPreset, NormalsAreThoseOfTheHeight) {
    const ScratchMaps maps = preset_maps(GetParam(), 512);
    const Image normals = normal_map(maps);
    double worst = 0.0;
    for (int y = 0; y < maps.size; ++y) {
        for (int x = 0; x < maps.size; ++x) {
            const Slopes s = differences(maps, x, y);
            const double scale = 1.0 / std::sqrt(1.0 + s.x * s.x + s.y * s.y);
            const float* n = normals.at(x, y);
            const double expected[] = {-s.x * scale, -s.y * scale, scale};
            for (int c = 0; c < 3; ++c)
                worst =
                    std::max(worst, std::abs(2.0 * static_cast<double>(n[c]) - 1.0 - expected[c]));
        }
    }
    // Rounding of (1 + n) / 2 and of the difference of two heights in float.
    EXPECT_LT(worst, 2e-6);
}

TEST_P(EveryPreset, MomentsOfEveryLevelAreMeansOfTheFullMap) {
    const ScratchMaps maps = preset_maps(GetParam(), 256);
    ASSERT_EQ(maps.moments.size(), 8u);  // 128 ... 1
    for (const MomentLevel& level : maps.moments) {
        const int share = maps.size / level.size;
        double worst = 0.0, largest = 0.0;
        for (int y = 0; y < level.size; ++y) {
            for (int x = 0; x < level.size; ++x) {
                double sums[5] = {};
                for (int j = 0; j < share; ++j) {
                    for (int i = 0; i < share; ++i) {
                        const Slopes s = differences(maps, x * share + i, y * share + j);
                        const double terms[] = {s.x, s.y, s.x * s.x, s.y * s.y, s.x * s.y};
                        for (int c = 0; c < 5; ++c) sums[c] += terms[c] / (share * share);
                    }
                }
                const SlopeMoments& m = level.texels[static_cast<std::size_t>(y * level.size + x)];
                const float found[] = {m.sx, m.sy, m.sxx, m.syy, m.sxy};
                for (int c = 0; c < 5; ++c) {
                    worst = std::max(worst, std::abs(static_cast<double>(found[c]) - sums[c]));
                    largest = std::max(largest, std::abs(sums[c]));
                }
                // Variances are not negative, except for rounding.
                EXPECT_GE(m.sxx - m.sx * m.sx, -1e-6f);
                EXPECT_GE(m.syy - m.sy * m.sy, -1e-6f);
            }
        }
        EXPECT_LT(worst, 1e-6 * std::max(largest, 0.1)) << level.size;
    }
}

TEST_P(EveryPreset, IsTheSameOnOneThreadAndOnTwo) {
    const auto on = [&](std::size_t threads) {
        const oneapi::tbb::global_control limit(
            oneapi::tbb::global_control::max_allowed_parallelism, threads);
        return preset_maps(GetParam(), 300);  // blocks of 128, 128 and 44
    };
    const ScratchMaps one = on(1), two = on(2);
    EXPECT_EQ(one.height.pixels, two.height.pixels);
    EXPECT_EQ(one.direction.pixels, two.direction.pixels);
    EXPECT_EQ(one.moments.back().texels.front().sxx, two.moments.back().texels.front().sxx);
}

INSTANTIATE_TEST_SUITE_P(Scratch, EveryPreset,
                         testing::ValuesIn(scratch_preset_names().begin(),
                                           scratch_preset_names().end()),
                         [](const auto& given) {
                             std::string name(given.param);
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

// The grain of a height is the direction of least change: the minor axis of the mean outer product
// of its slopes. Compared in neighborhoods where one line dominates both.
TEST(ScratchDirection, IsThatOfTheStructureTensor) {
    ScratchSettings settings = one_layer(512, 60, 14, 0.8, 0.05);
    settings.layers[0].curvature_per_mm = constant_spread(0.05);
    const ScratchMaps maps = made(settings);
    int compared = 0;
    double sum = 0.0;
    for (int y = 4; y < maps.size - 4; y += 3) {
        for (int x = 4; x < maps.size - 4; x += 3) {
            double xx = 0, yy = 0, xy = 0, c = 0, s = 0;
            int known = 0;
            for (int j = -4; j <= 4; ++j) {
                for (int i = -4; i <= 4; ++i) {
                    const Slopes slope = differences(maps, x + i, y + j);
                    xx += slope.x * slope.x;
                    yy += slope.y * slope.y;
                    xy += slope.x * slope.y;
                    c += static_cast<double>(maps.direction.at(x + i, y + j)[0]);
                    s += static_cast<double>(maps.direction.at(x + i, y + j)[1]);
                    const float* line = maps.direction.at(x + i, y + j);
                    known += line[0] != 0.0f || line[1] != 0.0f ? 1 : 0;
                }
            }
            const double tensor = std::hypot(xx - yy, 2 * xy);
            const bool alone = known > 30 && std::hypot(c, s) > 0.97 * known;
            if (!alone || tensor < 0.98 * (xx + yy) || xx + yy < 0.1) continue;
            // The major axis of the slopes is 90 degrees from the groove: the opposite double
            // angle.
            const double difference =
                0.5 * std::acos(std::clamp(
                          -(c * (xx - yy) + s * 2 * xy) / (tensor * std::hypot(c, s)), -1.0, 1.0));
            sum += difference;
            ++compared;
            // Strokes bend by 2.5 degrees over nine texels, and the feet of other strokes cross
            // them.
            EXPECT_LT(difference * 180.0 / kPi, 6.0) << x << "," << y;
        }
    }
    ASSERT_GT(compared, 300);
    EXPECT_LT(sum / compared * 180.0 / kPi, 1.0);
}

// A section through the middle of one straight stroke: the cap of a sphere through its width and
// depth.
TEST(ScratchProfiles, RoundIsACapOfASphere) {
    ScratchSettings settings = one_layer(1000, 1, 30, 4, 0.5);
    settings.layers[0].field = ScratchField::constant;
    const ScratchMaps maps = made(settings);
    const auto lowest = std::min_element(maps.height.pixels.begin(), maps.height.pixels.end());
    const auto place = static_cast<int>(lowest - maps.height.pixels.begin());
    const int x = place % maps.size, y = place / maps.size;
    const double radius = (2.0 * 2.0 + 0.5 * 0.5) / (2 * 0.5), texel = 0.05;
    EXPECT_NEAR(height_at(maps, x, y), -0.5, 1e-3);  // the middle is between texels
    for (int i = -45; i <= 45; ++i) {
        const double v = i * texel;
        const double cap =
            std::abs(v) < 2.0 ? std::sqrt(radius * radius - v * v) - (radius - 0.5) : 0.0;
        // Half a texel, the offset of the middle, times the steepest slope, 0.53.
        EXPECT_NEAR(height_at(maps, x, y + i), -cap, 0.53 * 0.5 * texel + 1e-4) << i;
    }
}

TEST(ScratchProfiles, AHemisphereIsPressedInAtFullTaperAndEqualSides) {
    // As long as wide, and half as deep: the pit of K11. Volume 2/3 pi r^3.
    const ScratchSettings settings = one_layer(800, 1, 10, 10, 5);
    const ScratchMaps maps = made(settings);
    const double texel = settings.tile_mm / settings.size;
    double volume = 0.0;
    for (const float h : maps.height.pixels) volume -= static_cast<double>(h) * texel * texel;
    EXPECT_NEAR(volume, 2.0 / 3.0 * kPi * 125.0, 0.005 * 2.0 / 3.0 * kPi * 125.0);
}

TEST(ScratchProfiles, ABurrLiftsAShareOfWhatItDigs) {
    ScratchSettings settings = one_layer(1000, 1, 30, 4, 0.3);
    settings.layers[0].profile = ScratchProfile::burr;
    const ScratchMaps maps = made(settings);
    double dug = 0.0, lifted = 0.0;
    for (const float h : maps.height.pixels)
        (h < 0 ? dug : lifted) += std::abs(static_cast<double>(h));
    // Groove 2 * 0.6 * 2/3 = 0.8; lips 2 * 0.4 * (4/3) / 12 = 0.0889.
    EXPECT_NEAR(lifted / dug, 0.0889 / 0.8, 0.003);
}

// The average of a finer map equals the coarser one, also where strokes are narrower than a texel.
TEST(ScratchSizes, GiveTheSameSurface) {
    for (const double width : {0.06, 0.6}) {
        ScratchSettings settings = one_layer(256, 60, 8, width, 0.02);
        settings.layers[0].curvature_per_mm = constant_spread(0.05);
        const ScratchMaps coarse = made(settings);
        settings.size = 1024;
        const ScratchMaps fine = made(settings);
        double mean_coarse = 0, mean_fine = 0, cross = 0, square_coarse = 0, square_fine = 0;
        for (int y = 0; y < 256; ++y) {
            for (int x = 0; x < 256; ++x) {
                double mean = 0.0;
                for (int j = 0; j < 16; ++j)
                    mean += height_at(fine, 4 * x + j % 4, 4 * y + j / 4) / 16.0;
                const double other = height_at(coarse, x, y);
                mean_fine += mean;
                mean_coarse += other;
                cross += mean * other;
                square_fine += mean * mean;
                square_coarse += other * other;
            }
        }
        // Where thin strokes cross, the wider strokes of the coarse map overlap slightly more.
        EXPECT_NEAR(mean_coarse / mean_fine, 1.0, 0.03) << width;
        EXPECT_GT(cross / std::sqrt(square_fine * square_coarse), width < 0.1 ? 0.85 : 0.99);
    }
}

}  // namespace
}  // namespace burnish
