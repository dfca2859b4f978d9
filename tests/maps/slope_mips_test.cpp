// Mips of slopes: means and variances against sums over the texels below each.
#include "maps/normal/slope_mips.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <numbers>

#include "maps/normal/bumps.hpp"

namespace burnish::test {
namespace {

struct Rgb {
    float r, g, b;
};

Texture float_map(int width, int height, const std::function<Rgb(int, int)>& texel) {
    Texture map{"map", width, height, 3, TexelType::f32, ColorSpace::linear, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Rgb c = texel(x, y);
            const auto* bytes = reinterpret_cast<const std::byte*>(&c);
            map.texels.insert(map.texels.end(), bytes, bytes + sizeof c);
        }
    }
    return map;
}

Rgb encoded(double slope_x, double slope_y) {
    const double z = 1 / std::sqrt(1 + slope_x * slope_x + slope_y * slope_y);
    return {static_cast<float>(0.5 + 0.5 * slope_x * z),
            static_cast<float>(0.5 + 0.5 * slope_y * z), static_cast<float>(0.5 + 0.5 * z)};
}

Texture bumps(int width, int height) {
    return float_map(width, height, [](int x, int y) {
        return encoded(std::sin(0.7 * x + 0.3 * y), 0.5 * std::cos(1.1 * x) + 0.2 * y / 8);
    });
}

const SlopeTexel& at(const SlopeLevel& level, int x, int y) {
    return level.texels[static_cast<std::size_t>(y * level.width + x)];
}

TEST(SlopeMips, SidesHalveDownToOne) {
    const std::vector<SlopeLevel> levels = slope_mips(bumps(13, 4));
    ASSERT_EQ(levels.size(), 4u);
    const int widths[] = {13, 6, 3, 1}, heights[] = {4, 2, 1, 1};
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(levels[i].width, widths[i]);
        EXPECT_EQ(levels[i].height, heights[i]);
    }
}

// By area, also for odd sides: E[s^2] - E[s]^2 in double over the texels below.
TEST(SlopeMips, EveryTexelHasTheMomentsOfWhatItCovers) {
    for (const auto& [width, height] : {std::pair{16, 8}, std::pair{13, 7}, std::pair{5, 1}}) {
        const std::vector<SlopeLevel> levels = slope_mips(bumps(width, height));
        for (const SlopeLevel& level : levels) {
            // After level 1 the texels of an odd side are means of means; the last level covers all
            // texels.
            const bool first = &level <= &levels[1], last = &level == &levels.back();
            if (!first && !last) continue;
            for (int y = 0; y < level.height; ++y) {
                for (int x = 0; x < level.width; ++x) {
                    const double x0 = x * static_cast<double>(width) / level.width;
                    const double x1 = (x + 1) * static_cast<double>(width) / level.width;
                    const double y0 = y * static_cast<double>(height) / level.height;
                    const double y1 = (y + 1) * static_cast<double>(height) / level.height;
                    double area = 0, s = 0, ss = 0, t = 0, tt = 0;
                    for (int j = 0; j < height; ++j) {
                        for (int i = 0; i < width; ++i) {
                            const double w =
                                std::max(std::min(x1, i + 1.0) - std::max(x0, i * 1.0), 0.0) *
                                std::max(std::min(y1, j + 1.0) - std::max(y0, j * 1.0), 0.0);
                            const SlopeTexel& f = at(levels[0], i, j);
                            const double a = static_cast<double>(f.x), b = static_cast<double>(f.y);
                            area += w;
                            s += w * a;
                            ss += w * a * a;
                            t += w * b;
                            tt += w * b * b;
                        }
                    }
                    const SlopeTexel& found = at(level, x, y);
                    EXPECT_NEAR(found.x, s / area, 1e-6);
                    EXPECT_NEAR(found.y, t / area, 1e-6);
                    EXPECT_NEAR(found.variance_x, ss / area - s * s / area / area, 1e-6);
                    EXPECT_NEAR(found.variance_y, tt / area - t * t / area / area, 1e-6);
                }
            }
        }
    }
}

// E[s t] - E[s] E[t] over the texels below, in double: blocks of 2^level texels a side.
TEST(SlopeMips, CovariancesAreThoseOfWhatATexelCovers) {
    constexpr int kSize = 16;
    const std::vector<SlopeLevel> levels = slope_mips(float_map(kSize, kSize, [](int x, int y) {
        const double along = std::sin(0.9 * x + 0.7 * y);
        return encoded(0.6 * along + 0.1 * std::cos(2.1 * y), -0.4 * along + 0.2 * x / kSize);
    }));
    const std::vector<std::vector<float>> covariances = slope_covariances(levels);
    ASSERT_EQ(covariances.size(), levels.size());
    for (std::size_t l = 0; l < levels.size(); ++l) {
        const int side = levels[l].width, block = kSize / side;
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                double s = 0, t = 0, st = 0;
                for (int j = 0; j < block; ++j) {
                    for (int i = 0; i < block; ++i) {
                        const SlopeTexel& f = at(levels[0], x * block + i, y * block + j);
                        s += static_cast<double>(f.x);
                        t += static_cast<double>(f.y);
                        st += static_cast<double>(f.x) * static_cast<double>(f.y);
                    }
                }
                const double n = block * block;
                // Texels are floats near 1: 6e-8 each.
                EXPECT_NEAR(covariances[l][static_cast<std::size_t>(y * side + x)],
                            st / n - s / n * t / n, 1e-6)
                    << "level " << l;
            }
        }
    }
    EXPECT_LT(covariances.back()[0], -0.1f);  // the slopes run against each other
}

TEST(SlopeMips, CovariancesOfOddSidesAreThoseOfTheWhole) {
    const std::vector<SlopeLevel> levels = slope_mips(bumps(13, 7));
    double s = 0, t = 0, st = 0;
    for (const SlopeTexel& f : levels[0].texels) {
        s += static_cast<double>(f.x) / (13 * 7);
        t += static_cast<double>(f.y) / (13 * 7);
        st += static_cast<double>(f.x) * static_cast<double>(f.y) / (13 * 7);
    }
    EXPECT_NEAR(slope_covariances(levels).back()[0], st - s * t, 1e-6);
}

// Over whole waves, a sine of slope amplitude A has mean 0 and variance A^2/2.
TEST(SlopeMips, ASineHasHalfItsSquare) {
    const Texture map = float_map(64, 64, [](int x, int) {
        return encoded(0.8 * std::sin(2 * std::numbers::pi * 4 * (x + 0.5) / 64), 0);
    });
    const SlopeTexel all = slope_mips(map).back().texels[0];
    EXPECT_NEAR(all.x, 0, 1e-6);
    EXPECT_NEAR(all.variance_x, 0.32, 1e-5);
    EXPECT_NEAR(all.variance_y, 0, 1e-12);
}

// The slopes of the bumps' height, by differences, halfway down a smooth flank.
TEST(SlopeMips, TheFinestLevelHasTheSlopesOfTheHeight) {
    const int size = 256;
    BumpOptions options;
    options.count = 4;
    const Image normals = bump_normal_map(size, options), height = bump_height_map(size, options);
    const Texture map = float_map(size, size, [&](int x, int y) {
        const float* n = normals.at(x, y);
        return Rgb{n[0], n[1], n[2]};
    });
    const SlopeLevel finest = slope_mips(map).front();
    double worst = 0;
    for (int y = 1; y < size - 1; ++y) {
        for (int x = 1; x < size - 1; ++x) {
            const double right =
                0.5 * static_cast<double>(*height.at(x + 1, y) - *height.at(x - 1, y));
            const double up =
                0.5 * static_cast<double>(*height.at(x, y - 1) - *height.at(x, y + 1));
            worst = std::max(worst, std::abs(static_cast<double>(at(finest, x, y).x) + right));
            worst = std::max(worst, std::abs(static_cast<double>(at(finest, x, y).y) + up));
        }
    }
    // Differences over two texels of a bump of 60 texels: the discontinuity of the curvature at its
    // rim.
    EXPECT_LT(worst, 0.03);
}

TEST(SlopeMips, BrokenTexelsAreFlatAndSteepOnesHeld) {
    constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
    constexpr float kInfinite = std::numeric_limits<float>::infinity();
    const Rgb texels[] = {{0, 0, 0},         {0.5f, 0.5f, 0.5f}, {kNan, 0.5f, 1},
                          {1, kInfinite, 1}, {0.5f, 0.5f, kNan}, {1, 0.5f, 0.5f + 1e-6f}};
    const Texture map = float_map(6, 1, [&](int x, int) { return texels[x]; });
    const SlopeLevel level = slope_mips(map).front();
    for (int i = 0; i < 5; ++i) {
        EXPECT_EQ(at(level, i, 0).x, 0.0f) << i;
        EXPECT_EQ(at(level, i, 0).y, 0.0f) << i;
    }
    EXPECT_NEAR(at(level, 5, 0).x, kSteepestSlope, 1e-4);
}

// The same normal in every bit depth, and in two channels.
TEST(SlopeMips, DepthsAndChannelsAgree) {
    const auto one = [](TexelType type, int channels, std::vector<std::byte> bytes) {
        const SlopeTexel t =
            slope_mips({"map", 1, 1, channels, type, ColorSpace::linear, std::move(bytes)})[0]
                .texels[0];
        EXPECT_NEAR(t.x, 0.6 / 0.8, 0.01);
        EXPECT_NEAR(t.y, 0.0, 0.01);
    };
    const auto b = [](int v) { return static_cast<std::byte>(v); };
    // 0.8 and 0.9: normals (0.6, 0, 0.8).
    one(TexelType::u8, 3, {b(204), b(128), b(230)});
    one(TexelType::u8, 2, {b(204), b(128)});
    one(TexelType::u8, 4, {b(204), b(128), b(230), b(9)});
    const std::uint16_t words[] = {52428, 32768, 58982};
    const auto* bytes = reinterpret_cast<const std::byte*>(words);
    one(TexelType::u16, 3, {bytes, bytes + sizeof words});
}

}  // namespace
}  // namespace burnish::test
