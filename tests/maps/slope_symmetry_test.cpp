#include "maps/normal/slope_symmetry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "maps/normal/bumps.hpp"

namespace burnish {
namespace {

Texture texture_of(const Image& map, bool green_down) {
    Texture t{"map", map.width, map.height, 3, TexelType::u8, ColorSpace::linear, {}};
    for (std::size_t i = 0; i < map.pixels.size(); ++i) {
        const float value = green_down && i % 3 == 1 ? 1.0f - map.pixels[i] : map.pixels[i];
        t.texels.push_back(static_cast<std::byte>(std::lround(value * 255.0f)));
    }
    return t;
}

TEST(SlopeSymmetry, TellsWhichWayGreenPoints) {
    const Image bumps = bump_normal_map(256);
    EXPECT_GT(slope_symmetry(texture_of(bumps, false)), 0.9);
    EXPECT_LT(slope_symmetry(texture_of(bumps, true)), -0.9);
}

TEST(SlopeSymmetry, SaysNothingOfFlatMapsAndNoise) {
    EXPECT_EQ(slope_symmetry(texture_of(Image(64, 64, 3, 0.5f), false)), 0.0);
    Image noise(256, 256, 3, 1.0f);
    std::mt19937 random(3);
    std::uniform_real_distribution<float> tilt(0.4f, 0.6f);
    for (std::size_t i = 0; i < noise.pixels.size(); ++i)
        if (i % 3 < 2) noise.pixels[i] = tilt(random);
    // 65,000 texels: five deviations of the correlation of independent values.
    EXPECT_NEAR(slope_symmetry(texture_of(noise, false)), 0.0, 0.02);
}

}  // namespace
}  // namespace burnish
