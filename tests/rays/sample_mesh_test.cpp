// The points of a scene, and edges that are split between them.
#include "rays/sample_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "shapes.hpp"

namespace burnish::test {
namespace {

WorldMesh in_world(const Mesh& mesh, int instance = 0) {
    WorldMesh world;
    world.positions = mesh.positions;
    world.normals = mesh.normals;
    world.indices = mesh.indices;
    world.instance = instance;
    return world;
}

double area_of(const SampleMesh& mesh) {
    double area = 0;
    for (std::uint32_t m = 0; m < mesh.meshes().size(); ++m)
        for (std::uint32_t t = 0; 3 * t < mesh.meshes()[m].indices.size(); ++t) {
            const auto corners = mesh.corners_of({m, t});
            area += glm::length(glm::cross(glm::dvec3(corners[1] - corners[0]),
                                           glm::dvec3(corners[2] - corners[0]))) /
                    2;
        }
    return area;
}

// How many inner edges of the unit square of y = 0 are not those of two triangles.
int gaps_of(const SampleMesh& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> counts;
    for (std::size_t m = 0; m < mesh.meshes().size(); ++m) {
        const auto points = mesh.points_of(m);
        const auto& indices = mesh.meshes()[m].indices;
        for (std::size_t i = 0; i < indices.size(); ++i) {
            const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
            const std::uint32_t a = points[indices[i]], b = points[indices[next]];
            ++counts[std::minmax(a, b)];
        }
    }
    int gaps = 0;
    for (const auto& [edge, count] : counts) {
        const glm::vec3 a = glm::abs(mesh.position(edge.first)),
                        b = glm::abs(mesh.position(edge.second)),
                        middle = glm::abs(mesh.position(edge.first) + mesh.position(edge.second));
        const bool outline =
            (a.x == 1 && b.x == 1 && middle.x == 2) || (a.z == 1 && b.z == 1 && middle.z == 2);
        if (count != (outline ? 1 : 2)) ++gaps;
    }
    return gaps;
}

TEST(SampleMesh, HasOnePointForVerticesOfOnePlaceAndNormal) {
    // A ball of 12 rows has 11 rings of 24 places, and two poles.
    const SampleMesh ball({in_world(sphere({0, 0, 0}, 1.0, 12))});
    EXPECT_EQ(ball.points(), 11u * 24 + 2);
    // The corners of a box have three normals each, which stay apart.
    EXPECT_EQ(SampleMesh({in_world(box({0, 0, 0}, {1, 1, 1}, 1))}).points(), 24u);
    // Two halves of a square, as two meshes: three rows of three places.
    const SampleMesh halves({in_world(rectangle({-1, 0, 1}, {1, 0, 0}, {0, 0, -2}, 1, 2)),
                             in_world(rectangle({0, 0, 1}, {1, 0, 0}, {0, 0, -2}, 1, 2), 1)});
    EXPECT_EQ(halves.points(), 9u);
    for (std::size_t m = 0; m < 2; ++m)
        for (std::size_t i = 0; i < halves.meshes()[m].positions.size(); ++i)
            EXPECT_EQ(halves.position(halves.points_of(m)[i]), halves.meshes()[m].positions[i]);
}

TEST(SampleMesh, SplitsEveryEdgeOnce) {
    SampleMesh square({in_world(ground(1.0, 1))});
    const std::size_t count = square.split([](std::uint32_t, std::uint32_t) { return true; }, 100);
    EXPECT_EQ(count, 5u);
    EXPECT_EQ(square.points(), 9u);
    EXPECT_EQ(square.meshes()[0].positions.size(), 9u);
    EXPECT_EQ(square.meshes()[0].indices.size(), 3u * 8);
    EXPECT_DOUBLE_EQ(area_of(square), 4.0);
    EXPECT_EQ(gaps_of(square), 0);
    // Middles, between the two vertices that are told.
    ASSERT_EQ(square.added(0).size(), 5u);
    for (std::size_t i = 0; i < 5; ++i) {
        const auto [a, b] = square.added(0)[i];
        const auto& positions = square.meshes()[0].positions;
        EXPECT_EQ(positions[4 + i], 0.5f * positions[a] + 0.5f * positions[b]);
    }
}

// Any choice of edges keeps the square closed, and its area.
TEST(SampleMesh, SplitsAnyEdgesWithoutAGap) {
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        SampleMesh halves({in_world(rectangle({-1, 0, 1}, {1, 0, 0}, {0, 0, -2}, 3, 4)),
                           in_world(rectangle({0, 0, 1}, {1, 0, 0}, {0, 0, -2}, 2, 4), 1)});
        for (int pass = 0; pass < 4; ++pass) {
            const std::size_t most = seed % 3 == 0 ? 7 : 1000;
            const std::size_t before = halves.points();
            const std::size_t count = halves.split(
                [&](std::uint32_t a, std::uint32_t b) {
                    return (std::min(a, b) * 7919 + std::max(a, b) * 104729 + seed * 31) % 3 == 0;
                },
                most);
            EXPECT_LE(count, most);
            EXPECT_EQ(halves.points(), before + count);
            EXPECT_EQ(gaps_of(halves), 0) << seed << ", " << pass;
            EXPECT_NEAR(area_of(halves), 4.0, 1e-6);
        }
    }
}

TEST(SampleMesh, KeepsItsFirstVerticesAndHasUnitNormals) {
    const Mesh before = sphere({0, 0, 0}, 1.0, 6);
    SampleMesh ball({in_world(before)});
    ball.split([](std::uint32_t, std::uint32_t) { return true; }, 10'000);
    const WorldMesh& after = ball.meshes()[0];
    ASSERT_GT(after.positions.size(), before.positions.size());
    for (std::size_t i = 0; i < before.positions.size(); ++i)
        EXPECT_EQ(after.positions[i], before.positions[i]);
    for (const glm::vec3& normal : after.normals) EXPECT_NEAR(glm::length(normal), 1.0f, 1e-6f);
}

// Every corner of every triangle is in the fan of its point, once.
TEST(SampleMesh, FansHoldTheTrianglesAboutEveryPoint) {
    const SampleMesh ball({in_world(sphere({0, 0, 0}, 1.0, 6)), in_world(ground(1.0, 3), 1)});
    const SampleMesh::Fans fans = ball.fans();
    std::size_t corners = 0;
    for (std::uint32_t point = 0; point < ball.points(); ++point) {
        std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
        for (const SampleMesh::Corner& corner : fans.of(point)) {
            const auto positions = ball.corners_of(corner);
            EXPECT_NE(std::ranges::find(positions, ball.position(point)), positions.end());
            EXPECT_TRUE(seen.emplace(corner.mesh, corner.triangle).second);
            ++corners;
        }
    }
    std::size_t wanted = 0;
    for (const WorldMesh& mesh : ball.meshes()) wanted += mesh.indices.size();
    EXPECT_EQ(corners, wanted);
}

}  // namespace
}  // namespace burnish::test
