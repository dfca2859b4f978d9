// Coarse triangles of a mesh: few, closed, and near the surface.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "burnish/builtin_meshes.hpp"

namespace burnish {
namespace {

// By the divergence theorem: one sixth of the sum of the determinants of the triangles.
double volume_of(const Mesh& mesh, const std::vector<std::uint32_t>& indices) {
    double sum = 0;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const glm::dvec3 a(mesh.positions[indices[i]]), b(mesh.positions[indices[i + 1]]),
            c(mesh.positions[indices[i + 2]]);
        sum += glm::dot(a, glm::cross(b, c));
    }
    return sum / 6;
}

TEST(CoarseMesh, OfASphereIsAClosedSphereOfFewTriangles) {
    const Mesh sphere = make_builtin_mesh("sphere", 100'000);
    const std::vector<std::uint32_t> coarse = coarse_indices(sphere, 5'000);
    ASSERT_FALSE(coarse.empty());
    ASSERT_EQ(coarse.size() % 3, 0u);
    EXPECT_LE(coarse.size() / 3, 5'000u);
    // The seam may hold more vertices than the rest; half of what was asked for is used at least.
    EXPECT_GE(coarse.size() / 3, 2'500u);
    EXPECT_LT(*std::ranges::max_element(coarse), sphere.positions.size());
    // A triangle of a sphere of radius r with 2 500 equal ones has an area of 4 pi r^2 / 2500: its
    // middle lies s^2 / (6 r) = 0.002 r deep (equilateral, side s = 0.108 r). The volume loses three
    // times that share. Triangles are not equal: twice as much.
    const double r = 0.5, ball = 4.0 / 3.0 * std::numbers::pi * r * r * r;
    EXPECT_NEAR(volume_of(sphere, coarse), ball, 0.012 * ball);
    for (std::size_t i = 0; i < coarse.size(); i += 3) {
        const glm::vec3 &a = sphere.positions[coarse[i]], &b = sphere.positions[coarse[i + 1]],
                        &c = sphere.positions[coarse[i + 2]];
        const glm::vec3 normal = glm::cross(b - a, c - a);
        // Slivers at the seam have no area but that of rounding: 6e-8 of their sides of 0.03.
        EXPECT_GT(glm::dot(normal, a + b + c), -1e-9f) << "triangle " << i / 3 << " faces inwards";
    }
}

TEST(CoarseMesh, IsNotMadeOfFewTriangles) {
    const Mesh sphere = make_builtin_mesh("sphere", 1'000);
    EXPECT_TRUE(coarse_indices(sphere, sphere.indices.size() / 3).empty());
    EXPECT_TRUE(coarse_indices(Mesh{}, 100).empty());
}

}  // namespace
}  // namespace burnish
