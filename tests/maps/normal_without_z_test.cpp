// Normal maps whose blue holds nothing.
#include "maps/normal/normal_without_z.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <vector>

namespace burnish {
namespace {

// A dome: n = (x, y, z) over a disc, flat around it. `blue` makes the blue of z.
template <typename Stored, typename Blue>
Texture dome(int channels, TexelType type, double steepness, Blue blue) {
    constexpr int kSide = 16;
    Texture map{"dome.png", kSide, kSide, channels, type, ColorSpace::linear, {}};
    std::vector<Stored> texels;
    const double most = std::is_same_v<Stored, float>
                            ? 1.0
                            : static_cast<double>(std::numeric_limits<Stored>::max());
    const auto stored = [&](double code) {
        return static_cast<Stored>(std::is_same_v<Stored, float> ? code : std::round(code * most));
    };
    for (int y = 0; y < kSide; ++y) {
        for (int x = 0; x < kSide; ++x) {
            const double nx = steepness * (x - 7.5) / 8, ny = steepness * (7.5 - y) / 8;
            const double nz = std::sqrt(std::max(1.0 - nx * nx - ny * ny, 0.0));
            const double codes[] = {0.5 * nx + 0.5, 0.5 * ny + 0.5, blue(nz), 1.0};
            for (int c = 0; c < channels; ++c) texels.push_back(stored(codes[c]));
        }
    }
    map.texels.resize(texels.size() * sizeof(Stored));
    std::memcpy(map.texels.data(), texels.data(), map.texels.size());
    return map;
}

const auto kWhole = [](double z) { return 0.5 * z + 0.5; };
const auto kZero = [](double) { return 0.0; };

template <typename Stored>
void expect_completed(TexelType type) {
    for (const int channels : {3, 4}) {
        for (const double constant : {0.0, 0.5, 1.0}) {
            const Texture map = dome<Stored>(channels, type, 0.6, [=](double) { return constant; });
            const auto xy = normal_map_without_z(map);
            ASSERT_TRUE(xy) << constant;
            EXPECT_EQ(xy->channels, 2);
            ASSERT_EQ(xy->texels.size(), 256 * 2 * sizeof(Stored));
            for (std::size_t i = 0; i < 256; ++i)
                EXPECT_EQ(std::memcmp(xy->texels.data() + i * 2 * sizeof(Stored),
                                      map.texels.data() +
                                          i * static_cast<std::size_t>(channels) * sizeof(Stored),
                                      2 * sizeof(Stored)),
                          0);
        }
        EXPECT_FALSE(normal_map_without_z(dome<Stored>(channels, type, 0.6, kWhole)));
    }
}

TEST(NormalWithoutZ, IsTwoChannelsInEveryDepth) {
    expect_completed<std::uint8_t>(TexelType::u8);
    expect_completed<std::uint16_t>(TexelType::u16);
    expect_completed<float>(TexelType::f32);
}

// Relief so shallow that z is 255 of 255 throughout is a whole map.
TEST(NormalWithoutZ, AShallowMapIsWhole) {
    const Texture map = dome<std::uint8_t>(3, TexelType::u8, 0.04, kWhole);
    for (std::size_t i = 2; i < map.texels.size(); i += 3)
        ASSERT_EQ(map.texels[i], std::byte{0xFF});
    EXPECT_FALSE(normal_map_without_z(map));
}

TEST(NormalWithoutZ, AFlatPictureAndTwoChannelsStay) {
    EXPECT_FALSE(normal_map_without_z(dome<std::uint8_t>(3, TexelType::u8, 0.0, kZero)));
    Texture two = *normal_map_without_z(dome<std::uint8_t>(3, TexelType::u8, 0.6, kZero));
    EXPECT_FALSE(normal_map_without_z(two));
}

TEST(NormalWithoutZ, BlackPaddingDoesNotCount) {
    Texture map = dome<std::uint8_t>(3, TexelType::u8, 0.6, [](double) { return 0.5; });
    for (std::size_t i = 0; i < 30; ++i) map.texels[i] = std::byte{0};
    EXPECT_TRUE(normal_map_without_z(map));
    EXPECT_NE(normal_without_z_warning("a.png").find("z is taken from them"), std::string::npos);
}

}  // namespace
}  // namespace burnish
