#include "reference/owen_points.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace burnish {
namespace {

constexpr std::uint32_t kSets[] = {0, 1, 0x12345678U, 0xffffffffU};

// A net: every box of 2^a x 2^b parts, a + b = 6, holds one of 64 points.
TEST(OwenPoints, AreOneToABoxOfEveryShapeInTheFirstTwoCoordinates) {
    for (const std::uint32_t set : kSets)
        for (const std::uint32_t first : {0U, 64U, 4096U})
            for (int a = 0; a <= 6; ++a) {
                std::set<int> boxes;
                for (std::uint32_t i = first; i < first + 64; ++i) {
                    const auto p = owen_point(i, set);
                    const int x = static_cast<int>(p[0] * std::exp2(static_cast<float>(a)));
                    const int y = static_cast<int>(p[1] * std::exp2(static_cast<float>(6 - a)));
                    boxes.insert(x * 64 + y);
                }
                EXPECT_EQ(boxes.size(), 64u) << set << " " << first << " " << a;
            }
}

TEST(OwenPoints, AreOneToAPartInEveryCoordinate) {
    for (const std::uint32_t set : kSets)
        for (std::size_t d = 0; d < 4; ++d) {
            std::set<int> parts;
            for (std::uint32_t i = 0; i < 256; ++i)
                parts.insert(static_cast<int>(owen_point(i, set)[d] * 256.0f));
            EXPECT_EQ(parts.size(), 256u) << set << " " << d;
        }
}

// The mean of x y over points of one index in many sets: 1/4 where the coordinates are independent of one another
// and of the set. Its standard deviation over 65536 sets is 0.22/256.
TEST(OwenPoints, OfDifferentSetsAreIndependent) {
    for (std::size_t d = 0; d < 4; ++d) {
        double mean = 0.0, product = 0.0, neighbors = 0.0;
        constexpr int kCount = 65536;
        float before = 0.5f;
        for (std::uint32_t set = 0; set < kCount; ++set) {
            const auto p = PathPoints(1, set, 0).group(3);
            mean += static_cast<double>(p[d]) / kCount;
            product += static_cast<double>(p[d] * p[(d + 1) % 4]) / kCount;
            neighbors += static_cast<double>(p[d] * before) / kCount;
            before = p[d];
        }
        EXPECT_NEAR(mean, 0.5, 5 * 0.29 / 256) << d;
        EXPECT_NEAR(product, 0.25, 5 * 0.22 / 256) << d;
        EXPECT_NEAR(neighbors, 0.25, 5 * 0.22 / 256) << d;
    }
}

TEST(OwenPoints, OfTwoGroupsOfAPathAreIndependent) {
    double product = 0.0;
    constexpr int kCount = 65536;
    for (std::uint32_t pixel = 0; pixel < kCount; ++pixel) {
        const PathPoints points(0, pixel, 5);
        product += static_cast<double>(points.group(64)[0] * points.group(65)[0]) / kCount;
    }
    EXPECT_NEAR(product, 0.25, 5 * 0.22 / 256);
}

}  // namespace
}  // namespace burnish
