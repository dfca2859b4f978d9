// The directions of rays.
#include "rays/vertex_rays.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

namespace burnish {
namespace {

TEST(EvenHemisphere, HoldsUnitDirectionsOfEvenArea) {
    for (const int count : {16, 64, 256, 1024}) {
        const std::vector<glm::vec3> directions = even_hemisphere(count);
        ASSERT_EQ(directions.size(), static_cast<std::size_t>(count));
        glm::dvec3 mean(0.0), square(0.0);
        double nearest = 2;
        for (std::size_t i = 0; i < directions.size(); ++i) {
            const glm::dvec3 w(directions[i]);
            EXPECT_NEAR(glm::length(w), 1.0, 1e-6);
            EXPECT_GT(w.z, 0.0);
            mean += w / static_cast<double>(count);
            square += w * w / static_cast<double>(count);
            for (std::size_t k = 0; k < i; ++k)
                nearest = std::min(nearest, glm::length(w - glm::dvec3(directions[k])));
        }
        // Over the hemisphere the means of w and of the squares are (0, 0, 1/2) and 1/3. A spiral of n
        // directions is within 1/n.
        EXPECT_LT(glm::length(mean - glm::dvec3(0, 0, 0.5)), 1.0 / count) << count;
        EXPECT_LT(glm::length(square - glm::dvec3(1.0 / 3)), 1.0 / count) << count;
        // Directions as far apart as can be, in a hexagonal lattice, keep sqrt(4 pi / (sqrt(3) n)).
        EXPECT_GT(nearest, 0.6 * std::sqrt(7.2552 / count)) << count;
    }
}

TEST(HemisphereAxes, AreOrthonormalAboutTheNormal) {
    std::mt19937 engine(3);
    std::normal_distribution<float> normal;
    std::vector<glm::vec3> normals = {{0, 0, 1}, {0, 0, -1}, {0, 1, 0}, {1, 0, 0}, {-1, 0, 0}};
    for (int i = 0; i < 200; ++i)
        normals.push_back(
            glm::normalize(glm::vec3(normal(engine), normal(engine), normal(engine))));
    for (std::uint32_t i = 0; i < normals.size(); ++i) {
        const HemisphereAxes axes(normals[i], i);
        const glm::vec3 x = axes({1, 0, 0}), y = axes({0, 1, 0}), z = axes({0, 0, 1});
        EXPECT_LT(glm::length(z - normals[i]), 1e-6f);
        for (const glm::vec3& axis : {x, y}) {
            EXPECT_NEAR(glm::length(axis), 1.0f, 1e-5f);
            EXPECT_NEAR(glm::dot(axis, normals[i]), 0.0f, 1e-5f);
        }
        EXPECT_NEAR(glm::dot(x, y), 0.0f, 1e-5f);
    }
}

// Neighbors have other angles, spread over the whole turn.
TEST(HemisphereAxes, TurnFromPointToPoint) {
    constexpr std::uint32_t kPoints = 1000;
    std::array<int, 8> eighths{};
    for (std::uint32_t i = 0; i < kPoints; ++i) {
        const glm::vec3 x = HemisphereAxes({0, 0, 1}, i)({1, 0, 0});
        const double turn = std::atan2(x.y, x.x) / 6.283185307179586 + 0.5;
        ++eighths[static_cast<std::size_t>(turn * 8) % 8];
    }
    // 125 each; by chance 3 standard deviations are 31.
    for (const int count : eighths) EXPECT_NEAR(count, 125, 31);
}

}  // namespace
}  // namespace burnish
