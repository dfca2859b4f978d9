#include "maps/normal/bumps.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "support/test_folder.hpp"

namespace burnish {
namespace {

glm::vec3 normal_at(const Image& map, int x, int y) {
    const float* p = map.at(x, y);
    return {2.0f * p[0] - 1.0f, 2.0f * p[1] - 1.0f, 2.0f * p[2] - 1.0f};
}

double degrees_between(const glm::vec3& a, const glm::vec3& b) {
    return std::asin(std::min(1.0f, glm::length(glm::cross(a, b)))) * 180.0 / 3.14159265358979;
}

TEST(Bumps, NormalsAreUnitAndNoSteeperThanAsked) {
    const Image map = bump_normal_map(256, {.count = 36, .max_tilt_deg = 40.0, .dimples = 0.5});
    double steepest = 0.0;
    for (int y = 0; y < map.height; ++y) {
        for (int x = 0; x < map.width; ++x) {
            const glm::vec3 n = normal_at(map, x, y);
            ASSERT_NEAR(glm::length(n), 1.0f, 1e-5f);
            steepest = std::max(steepest, degrees_between(n, {0, 0, 1}));
        }
    }
    EXPECT_LE(steepest, 40.001);
    EXPECT_GE(steepest, 39.5) << "the steepest slope is reached";
}

// The closed-form normals against differences of the separately computed height. At the border the
// neighbors of the first column are in the last one.
TEST(Bumps, NormalsAreThoseOfTheHeightAcrossTheSeam) {
    for (const int count : {1, 4, 9, 64}) {
        const BumpOptions options{
            .count = count, .max_tilt_deg = 30.0, .irregularity = 1.0, .dimples = 0.3, .seed = 5};
        const int size = 512;
        const Image exact = bump_normal_map(size, options);
        const Image differences = normal_map_from_height(bump_height_map(size, options), 1.0);
        double worst = 0.0, border = 0.0;
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                const double angle =
                    degrees_between(normal_at(exact, x, y), normal_at(differences, x, y));
                worst = std::max(worst, angle);
                if (x == 0 || y == 0 || x == size - 1 || y == size - 1)
                    border = std::max(border, angle);
            }
        }
        // Differences over two texels have the error of the third derivative, largest for small
        // bumps.
        EXPECT_LT(worst, count < 64 ? 1.5 : 6.0) << count;
        EXPECT_LE(border, worst);
    }
}

TEST(Bumps, UpInThePictureIsUp) {
    const Image map = bump_normal_map(64, {.count = 1, .irregularity = 0.0});
    // One bump in the middle: its left flank faces left, its upper flank faces up.
    EXPECT_LT(normal_at(map, 16, 32).x, -0.2f);
    EXPECT_GT(normal_at(map, 48, 32).x, 0.2f);
    EXPECT_GT(normal_at(map, 32, 16).y, 0.2f);
    EXPECT_LT(normal_at(map, 32, 48).y, -0.2f);
    const Image dimple = bump_normal_map(64, {.count = 1, .irregularity = 0.0, .dimples = 1.0});
    EXPECT_GT(normal_at(dimple, 16, 32).x, 0.2f);
}

TEST(Bumps, SeedDecides) {
    const BumpOptions one{.seed = 1}, two{.seed = 2};
    EXPECT_EQ(bump_normal_map(64, one).pixels, bump_normal_map(64, one).pixels);
    EXPECT_NE(bump_normal_map(64, one).pixels, bump_normal_map(64, two).pixels);
}

TEST(Bumps, RefusesWhatMakesNoSense) {
    EXPECT_THROW(bump_normal_map(0), UsageError);
    EXPECT_THROW(bump_normal_map(100000), UsageError);
    EXPECT_THROW(bump_normal_map(64, {.count = 0}), UsageError);
    EXPECT_THROW(bump_normal_map(64, {.max_tilt_deg = 90.0}), UsageError);
    EXPECT_THROW(bump_normal_map(64, {.max_tilt_deg = NAN}), UsageError);
    EXPECT_THROW(bump_height_map(64, {.irregularity = 2.0}), UsageError);
    EXPECT_THROW(normal_map_from_height(Image(), 1.0), Error);
    EXPECT_THROW(normal_map_from_height(Image(4, 4, 3), 1.0), Error);
}

TEST(NormalMapFromHeight, PlaneWaveHasItsAnalyticSlope) {
    const int size = 256;
    Image height(size, size, 1);
    const double turn = 2.0 * 3.14159265358979 / size;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            *height.at(x, y) = static_cast<float>(std::sin(turn * (3 * x + 2 * y)));
    const Image map = normal_map_from_height(height, 10.0);
    for (int y = 0; y < size; y += 5) {
        for (int x = 0; x < size; x += 5) {
            const double slope = 10.0 * turn * std::cos(turn * (3 * x + 2 * y));
            const glm::vec3 n = glm::normalize(glm::vec3(-3.0 * slope, 2.0 * slope, 1.0));
            ASSERT_LT(degrees_between(normal_at(map, x, y), n), 0.1);
        }
    }
}

}  // namespace
}  // namespace burnish
