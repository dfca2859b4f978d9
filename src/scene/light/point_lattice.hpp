// Lattices of points in the unit square, the most even sets of their number.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

namespace burnish {

// `count` points i (1/count, generator/count), modulo 1.
struct PointLattice {
    std::int64_t generator = 1;  // in [1, count), without a common divisor with count
    // Edges of a cell between the points: the shortest vector from point to point, and the shortest
    // beside it. The cells about all points fill the square once.
    glm::dvec2 edge[2];
};

// The lattice whose nearest points are farthest apart, for count >= 1. Of several, one whose nearest
// points are neighbors along x rather than along y.
PointLattice point_lattice(int count);

}  // namespace burnish
