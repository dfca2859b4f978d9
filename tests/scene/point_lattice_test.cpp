// Lattices of points: one point in each row and column, cells that fill the square, and distance.
#include "scene/light/point_lattice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

namespace burnish::test {
namespace {

double nearest_whole(double v) {
    return v - std::round(v);
}

// The least distance between two points, by trying all pairs with the first; the square is a torus.
double least_distance(int count, std::int64_t generator) {
    double least = 2;
    for (int i = 1; i < count; ++i)
        least = std::min(
            least, std::hypot(nearest_whole(static_cast<double>(i) / count),
                              nearest_whole(static_cast<double>(generator * i % count) / count)));
    return least;
}

TEST(PointLattice, HasAPointInEachRow) {
    for (int count = 1; count <= 200; ++count) {
        std::vector<int> rows(static_cast<std::size_t>(count));
        const PointLattice lattice = point_lattice(count);
        for (int i = 0; i < count; ++i)
            ++rows[static_cast<std::size_t>(lattice.generator * i % count)];
        EXPECT_EQ(std::ranges::count(rows, 1), count);
    }
}

TEST(PointLattice, KeepsItsPointsAsFarApartAsAnyGeneratorDoes) {
    for (const int count : {2, 3, 5, 8, 9, 16, 21, 32, 64, 100, 144}) {
        const PointLattice lattice = point_lattice(count);
        const double found = least_distance(count, lattice.generator);
        for (std::int64_t generator = 1; generator < count; ++generator) {
            if (std::gcd(generator, static_cast<std::int64_t>(count)) == 1) {
                EXPECT_GE(found, least_distance(count, generator) - 1e-12) << count;
            }
        }
        EXPECT_NEAR(std::hypot(lattice.edge[0].x, lattice.edge[0].y), found, 1e-12) << count;
    }
}

// Both edges lead from point to point, and their parallelogram has the share of one point.
TEST(PointLattice, HasCellsThatFillTheSquare) {
    for (int count = 1; count <= 300; ++count) {
        const PointLattice lattice = point_lattice(count);
        const glm::dvec2 a = lattice.edge[0], b = lattice.edge[1];
        EXPECT_NEAR(std::abs(a.x * b.y - a.y * b.x), 1.0 / count, 1e-12) << count;
        for (const glm::dvec2& edge : lattice.edge) {
            const double index = std::round(edge.x * count);
            EXPECT_NEAR(edge.x * count, index, 1e-9);
            EXPECT_NEAR(
                nearest_whole(edge.y - static_cast<double>(lattice.generator) * index / count), 0,
                1e-9)
                << count;
            EXPECT_LE(std::max(std::abs(edge.x), std::abs(edge.y)), 1.0);
        }
    }
}

}  // namespace
}  // namespace burnish::test
