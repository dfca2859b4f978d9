#include "scene/light/point_lattice.hpp"

#include <cmath>
#include <cstdlib>
#include <numeric>
#include <utility>

namespace burnish {
namespace {

// In units of 1/count.
struct Vector {
    std::int64_t x = 0, y = 0;
};

std::int64_t dot(Vector a, Vector b) {
    return a.x * b.x + a.y * b.y;
}

// The two shortest vectors that make the lattice, by the reduction of Lagrange and Gauss.
std::pair<Vector, Vector> shortest(std::int64_t count, std::int64_t generator) {
    Vector a{1, generator}, b{0, count};
    if (dot(b, b) < dot(a, a)) std::swap(a, b);
    while (true) {
        const auto times = static_cast<std::int64_t>(
            std::llround(static_cast<double>(dot(a, b)) / static_cast<double>(dot(a, a))));
        b = {b.x - times * a.x, b.y - times * a.y};
        if (dot(b, b) >= dot(a, a)) return {a, b};
        std::swap(a, b);
    }
}

}  // namespace

PointLattice point_lattice(int count) {
    const std::int64_t n = count;
    PointLattice best;
    Vector nearest;
    for (std::int64_t generator = 1; generator == 1 || generator < n; ++generator) {
        if (std::gcd(generator, n) != 1) continue;
        const auto [a, b] = shortest(n, generator);
        const std::int64_t more = dot(a, a) - dot(nearest, nearest);
        if (more < 0 || (more == 0 && std::abs(a.x) <= std::abs(nearest.x))) continue;
        nearest = a;
        best.generator = generator;
        const auto edge = [n](Vector v) {
            return glm::dvec2(static_cast<double>(v.x), static_cast<double>(v.y)) /
                   static_cast<double>(n);
        };
        best.edge[0] = edge(a);
        best.edge[1] = edge(b);
    }
    return best;
}

}  // namespace burnish
