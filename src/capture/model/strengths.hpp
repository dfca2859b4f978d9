// Separates a point's light into diffuse and specular light when the shape of the specular lobe is
// known: nonnegative least squares in two unknowns.
#pragma once

#include <algorithm>

namespace burnish {

struct Strengths {
    double diffuse = 0.0, specular = 0.0;
};

// Largest specular strength. A larger one means that no sample sees more than the far tail of the
// lobe, which says nothing of its strength: a half float, as which files hold it, ends here.
inline constexpr double kMostStrength = 65504.0;

// Finds d, s >= 0 that minimize |y - d u - s v|^2, from the inner products of u, v and y.
inline Strengths solve_strengths(double uu, double uv, double vv, double uy, double vy) {
    const double determinant = uu * vv - uv * uv;
    double d = 0.0, s = -1.0;
    // Below this relative determinant u and v are parallel within rounding, and all light counts as
    // diffuse.
    if (determinant > 1e-9 * uu * vv) {
        d = (uy * vv - vy * uv) / determinant;
        s = (vy * uu - uy * uv) / determinant;
    }
    if (s < 0.0 || s > kMostStrength) return {uu > 0.0 ? std::max(uy / uu, 0.0) : 0.0, 0.0};
    if (d < 0.0) {
        const double alone = vv > 0.0 ? std::max(vy / vv, 0.0) : 0.0;
        return alone <= kMostStrength ? Strengths{0.0, alone}
                                      : Strengths{uu > 0.0 ? std::max(uy / uu, 0.0) : 0.0, 0.0};
    }
    return {d, s};
}

}  // namespace burnish
