// How much of a point's light is diffuse and how much specular, when the specular's shape is known:
// least squares of two unknowns that are never negative.
#pragma once

#include <algorithm>

namespace burnish {

struct Strengths {
    double diffuse = 0.0, specular = 0.0;
};

// The d, s >= 0 that make |y - d u - s v|^2 least, from its sums of products.
inline Strengths solve_strengths(double uu, double uv, double vv, double uy, double vy) {
    const double determinant = uu * vv - uv * uv;
    double d = 0.0, s = -1.0;
    // Below this share u and v are the same to rounding, and all light counts as diffuse.
    if (determinant > 1e-9 * uu * vv) {
        d = (uy * vv - vy * uv) / determinant;
        s = (vy * uu - uy * uv) / determinant;
    }
    if (s < 0.0) return {uu > 0.0 ? std::max(uy / uu, 0.0) : 0.0, 0.0};
    if (d < 0.0) return {0.0, vv > 0.0 ? std::max(vy / vv, 0.0) : 0.0};
    return {d, s};
}

}  // namespace burnish
