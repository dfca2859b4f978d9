#include "burnish/mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "burnish/scene.hpp"

namespace burnish {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kLargest = std::numeric_limits<float>::max();

TEST(Bounds, HoldAllFinitePositions) {
    Mesh mesh;
    mesh.positions = {
        {1, 2, 3}, {kNan, -100, 0}, {-1, 5, 3}, {0, kInfinity, 0}, {0, 0, -kInfinity}};
    const Bounds bounds = bounds_of(mesh);
    EXPECT_EQ(bounds.low, glm::vec3(-1, 2, 3));
    EXPECT_EQ(bounds.high, glm::vec3(1, 5, 3));
    EXPECT_EQ(bounds.center(), glm::vec3(0, 3.5f, 3));
    EXPECT_FLOAT_EQ(bounds.radius(), 0.5f * std::sqrt(4.0f + 9.0f));
}

TEST(Bounds, OfNothingAreThePointAtTheOrigin) {
    Mesh mesh;
    EXPECT_EQ(bounds_of(mesh).high, glm::vec3(0.0f));
    mesh.positions = {{kNan, 1, 1}};
    EXPECT_EQ(bounds_of(mesh).low, glm::vec3(0.0f));
    EXPECT_EQ(bounds_of(mesh).radius(), 0.0f);
}

TEST(Bounds, OfTheLargestNumbersStayFinite) {
    Mesh mesh;
    mesh.positions = {glm::vec3(-kLargest), glm::vec3(kLargest)};
    EXPECT_TRUE(std::isfinite(bounds_of(mesh).radius()));
    EXPECT_EQ(bounds_of(mesh).center(), glm::vec3(0.0f));
    mesh.positions = {glm::vec3(kLargest)};
    EXPECT_EQ(bounds_of(mesh).center().x, kLargest);
}

// An erased instance keeps its slot and its id, and does not extend the bounds.
TEST(SceneBounds, LeaveErasedInstancesOut) {
    Scene scene;
    Mesh& mesh = scene.meshes.emplace_back();
    mesh.positions = {{0, 0, 0}, {1, 2, 3}};
    scene.materials.emplace_back();
    glm::mat4 moved(1.0f);
    moved[3][0] = 10.0f;
    scene.instances = {{0, 0, glm::mat4(1.0f)}, {0, 0, moved}};
    EXPECT_EQ(bounds_of(scene).high, glm::vec3(11, 2, 3));
    scene.instances[1].mesh = -1;
    EXPECT_EQ(bounds_of(scene).high, glm::vec3(1, 2, 3));
    scene.instances[0].mesh = -1;
    EXPECT_EQ(bounds_of(scene).high, glm::vec3(0.0f));
}

}  // namespace
}  // namespace burnish
