#include "maps/normal/height_occlusion.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace burnish {
namespace {

TEST(HeightOcclusion, APlaneIsOpen) {
    const Image open = height_occlusion(Image(32, 32, 1, 5.0f), 0.1, 0.1);
    for (const float value : open.pixels) EXPECT_EQ(value, 1.0f);
}

// At the foot of a long step of 45 degrees seen from one texel away: half of the directions see a
// horizon. In direction phi towards the step the nearest wall is 1/cos phi away and h high, which
// leaves 1/(1 + h^2 cos^2 phi); the mean of that over the circle is (1 + 1/sqrt(1 + h^2))/2.
TEST(HeightOcclusion, AtTheFootOfAWallItIsTheIntegral) {
    constexpr int kSide = 256;
    const double h = 8.0;  // wall, in texels; the foot is 8 texels away
    Image step(kSide, kSide, 1);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) *step.at(x, y) = x < kSide / 2 ? static_cast<float>(h) : 0;
    const Image open = height_occlusion(step, 1.0, 1.0);
    const double slope = h / 8.0;
    const double wanted = 0.5 * (1 + 1 / std::sqrt(1 + slope * slope));
    // 8 texels from the wall, counted from middle to middle. 12 directions, and steps that grow by half see
    // the wall up to half too far away: 0.04 of 0.15.
    EXPECT_NEAR(*open.at(kSide / 2 + 7, kSide / 2), wanted, 0.04);
    // On the wall nothing is higher.
    EXPECT_EQ(*open.at(kSide / 4, kSide / 2), 1.0f);
}

// The tile repeats: shifting it shifts the result.
TEST(HeightOcclusion, TheTileRepeats) {
    constexpr int kSide = 48;
    Image height(kSide, kSide, 1), shifted(kSide, kSide, 1);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const auto bump = [&](int i, int j) {
                return static_cast<float>((i * 7 + j * 13) % 11) +
                       3.0f * std::sin(0.4f * static_cast<float>(i));
            };
            *height.at(x, y) = bump(x, y);
            *shifted.at((x + 20) % kSide, (y + 31) % kSide) = bump(x, y);
        }
    const Image a = height_occlusion(height, 2.0, 1.0), b = height_occlusion(shifted, 2.0, 1.0);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x)
            ASSERT_EQ(*a.at(x, y), *b.at((x + 20) % kSide, (y + 31) % kSide));
}

}  // namespace
}  // namespace burnish
