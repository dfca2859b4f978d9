// Surfaces that touch, double or end at a point: nothing shades itself, and nothing looks through a wall.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "shapes.hpp"

namespace burnish::test {
namespace {

std::shared_ptr<const Visibility> found_of(const Scene& scene) {
    return VisibilityFinder(scene, kWhole).visibility();
}

double share_up(const VertexVisibility& vertex) {
    return f64::blocked_about(blocked_of(vertex), {0, 1, 0});
}

// 64 triangles meet at the tip of a cone.
TEST(SelfShading, AConeIsWholeUpToItsTip) {
    for (const double height : {0.05, 0.5, 3.0}) {
        const glm::dvec2 slope = glm::normalize(glm::dvec2(height, 0.3));
        const Scene scene = scene_of({surface(64, 4, true, [&](double u, double v) {
            const glm::dvec3 out(std::sin(6.283185307179586 * u), 0,
                                 std::cos(6.283185307179586 * u));
            const glm::dvec3 normal = out * slope.x + glm::dvec3(0, slope.y, 0);
            return Place{out * (0.3 * v) + glm::dvec3(0, height * (1 - v), 0),
                         v == 0 ? glm::dvec3(0, 1, 0) : normal};
        })});
        EXPECT_TRUE(is_open(found_of(scene)->instances.at(0))) << height;
    }
}

// Normals as exporters average them over the corner of a box.
TEST(SelfShading, ABoxWithSmoothNormalsIsWhole) {
    Scene scene = scene_of({box({-1, -1, -1}, {1, 1, 1}, 1)});
    for (std::size_t i = 0; i < scene.meshes[0].positions.size(); ++i)
        scene.meshes[0].normals[i] = glm::normalize(scene.meshes[0].positions[i]);
    EXPECT_TRUE(is_open(found_of(scene)->instances.at(0)));
}

// A card of two faces in one plane, and a mesh that is there twice.
TEST(SelfShading, FacesInOnePlaneAreWhole) {
    const Mesh front = ground(0.5, 6);
    const Mesh back = rectangle({-0.5, 0, -0.5}, {1, 0, 0}, {0, 0, 1}, 6, 6);
    ASSERT_LT(back.normals[0].y, 0.0f);
    const Mesh ball = sphere({0, 0, 0}, 0.5, 16);
    const std::vector<Scene> scenes = {scene_of({front, back}), scene_of({joined(front, back)}),
                                       scene_of({front, front}), scene_of({ball, ball})};
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        const auto found = found_of(scenes[i]);
        EXPECT_TRUE(found->warnings.empty());
        for (const InstanceVisibility& instance : found->instances)
            EXPECT_TRUE(is_open(instance)) << "scene " << i;
    }
}

// Triangles whose corners turn clockwise about their vertices' normals, as some files have them: normals say
// which side is seen.
TEST(SelfShading, NormalsDecideAgainstTheOrderOfCorners) {
    Scene scene = scene_of({ground(0.5, 8)});
    std::vector<std::uint32_t>& indices = scene.meshes[0].indices;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
        std::swap(indices[i + 1], indices[i + 2]);
    EXPECT_TRUE(is_open(found_of(scene)->instances.at(0)));
    scene.meshes.push_back(disc({0, 0.4, 0}, 0.5, {0, -1, 0}));
    scene.instances.push_back({1, 0, glm::mat4(1.0f)});
    const std::size_t middle = vertex_at(scene.meshes[0], glm::dvec3(0.0));
    const double share = share_up(found_of(scene)->instances.at(0).vertices.at(middle));
    EXPECT_NEAR(share, 0.25 / (0.25 + 0.16), 0.05);
}

// A wall stands before the corners of a large floor of two triangles: it is behind them. Rays start beside a
// vertex, up to 5 percent of a triangle's length away; split triangles are short.
TEST(SelfShading, NothingStartsBeyondAThinWall) {
    for (const bool split : {false, true})
        for (const double distance : {0.3, 0.1, 0.03, 0.01}) {
            if (!split && distance < 0.1) continue;
            const Scene scene = scene_of({ground(1.0, 1), rectangle({1 - distance, -0.1, -1.5},
                                                                    {0, 0, 3}, {0, 1, 0}, 1, 1)});
            const std::size_t corner = vertex_at(scene.meshes[0], {1, 0, 1});
            const auto found = VisibilityFinder(scene, {256, split}).visibility();
            const f64::Harmonics h = blocked_of(found->instances.at(0).vertices.at(corner));
            // Not all of the half is blocked, as the wall ends.
            EXPECT_LT(h.x1.x, -0.1) << split << ", " << distance;
        }
}

// A wall that cuts through the middle of the floor's cells.
TEST(SelfShading, AWallThatCutsTrianglesHasTwoSides) {
    const Scene scene =
        scene_of({ground(0.5, 10), rectangle({0.03, -1, -50}, {0, 0, 100}, {0, 51, 0}, 1, 1)});
    const auto found = found_of(scene);
    for (std::size_t i = 0; i < scene.meshes[0].positions.size(); ++i) {
        const glm::vec3 p = scene.meshes[0].positions[i];
        const f64::Harmonics h = blocked_of(found->instances.at(0).vertices.at(i));
        const double side = p.x < 0.03f ? 1 : -1;
        EXPECT_NEAR(h.x1.x, side * std::sqrt(3.0) / 4, 0.02) << p.x << ", " << p.z;
    }
}

// Edges are split about a wall. The vertices that are added, and the first ones, are each on their own side.
TEST(SelfShading, SplitVerticesBesideAWallAreOnTheirSide) {
    for (const double at : {0.513, 0.2, -0.777, 0.97}) {
        const Scene scene =
            scene_of({ground(1.0, 1), rectangle({at, -0.1, -1.5}, {0, 0, 3}, {0, 1, 0}, 1, 1)});
        const auto found = VisibilityFinder(scene, {}).visibility();
        const InstanceVisibility& floor = found->instances.at(0);
        ASSERT_TRUE(floor.mesh);
        for (std::size_t i = 0; i < floor.vertices.size(); ++i) {
            const double x = static_cast<double>(floor.mesh->positions[i].x) - at;
            // 1 mm: where rays start beside a vertex.
            if (std::abs(x) < 1e-3) continue;
            EXPECT_LE(blocked_of(floor.vertices[i]).x1.x * x, 0.0) << at << ", " << x;
        }
    }
}

// The foot of a solid that is sunk into the floor.
TEST(SelfShading, WhatIsWithinASolidIsDark) {
    const Scene scene =
        scene_of({ground(1.0, 20), box({-0.33, -0.2, -0.33}, {0.33, 0.5, 0.33}, 4)});
    const auto found = found_of(scene);
    EXPECT_TRUE(found->warnings.empty());
    for (std::size_t i = 0; i < scene.meshes[0].positions.size(); ++i) {
        const glm::vec3 p = glm::abs(scene.meshes[0].positions[i]);
        const double share = share_up(found->instances.at(0).vertices.at(i));
        if (std::max(p.x, p.z) < 0.33f) {
            // 0.0044: the mean of band 2 over 256 rays is not quite 0.
            EXPECT_NEAR(share, 1.0, 0.006) << p.x << ", " << p.z;
        }
        if (std::max(p.x, p.z) > 0.33f) {
            EXPECT_LT(share, 0.6) << p.x << ", " << p.z;
        }
    }
}

}  // namespace
}  // namespace burnish::test
