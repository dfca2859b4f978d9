#include "burnish/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace burnish {

float Bounds::radius() const {
    // In double: the square of a large but finite float overflows a float.
    double sum = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        const double side = static_cast<double>(high[axis]) - static_cast<double>(low[axis]);
        sum += side * side;
    }
    constexpr double kLargest = std::numeric_limits<float>::max();
    return static_cast<float>(std::min(0.5 * std::sqrt(sum), kLargest));
}

Bounds bounds_of(const Mesh& mesh) {
    Bounds bounds;
    bool first = true;
    for (const glm::vec3& p : mesh.positions) {
        if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) continue;
        if (first) bounds = {p, p};
        first = false;
        for (int axis = 0; axis < 3; ++axis) {
            bounds.low[axis] = std::min(bounds.low[axis], p[axis]);
            bounds.high[axis] = std::max(bounds.high[axis], p[axis]);
        }
    }
    return bounds;
}

}  // namespace burnish
