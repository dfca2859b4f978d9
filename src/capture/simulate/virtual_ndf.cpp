#include "burnish/virtual_ndf.hpp"

#include <algorithm>
#include <cmath>

#include "burnish/f64.hpp"

namespace burnish {

namespace {

f64::Lobe lobe_of(const VirtualLobe& lobe) {
    return f64::lobe_from_alpha(static_cast<int>(lobe.mdf), lobe.alpha_x, lobe.alpha_y);
}

// A lean by the slopes s maps h to h' with slopes m - s: D(h) = P(m - s) / h_z^4 and P(m') = D(h')
// h'_z^4.
double leaning_D(const VirtualLobe& lobe, const Vec3d& h) {
    const Vec3d own = rotated_about_z({h[0] - lobe.lean_x * h[2], h[1] - lobe.lean_y * h[2], h[2]},
                                      -lobe.rotation);
    const f64::vec3 direction = f64::normalize(f64::vec3(own[0], own[1], own[2]));
    const double ratio = direction.z / h[2];
    const f64::Perturbation flat =
        f64::perturb_make(f64::kMethodNone, f64::vec3(0.0, 0.0, 1.0), true, false);
    return f64::lobe_D(lobe_of(lobe), flat, direction) * ratio * ratio * ratio * ratio;
}

// Int max(k.m + k_z, 0) P(m) dm over the slopes m of the lobe without its lean. k need not be unit
// and may lie below the horizon. Above it the integral is k_z (1 + Lambda); below it, that of the
// mirrored k less the mirrored k's z (Smith; Heitz 2014 section 5).
double resting_area(const VirtualLobe& lobe, const Vec3d& k) {
    const double z = std::abs(k[2]);
    const double lateral = std::hypot(k[0], k[1]);
    if (lateral <= 1e-12 * z) return std::max(k[2], 0.0);
    // Lambda z has a finite limit at the horizon; a z of at least 1e-9 keeps Lambda itself finite.
    const f64::vec3 up(k[0], k[1], std::max(z, 1e-9 * lateral));
    const double lambda_z = f64::smith_lambda(lobe_of(lobe), up) * up.z;
    return lambda_z + std::max(k[2], 0.0);
}

}  // namespace

Vec3d rotated_about_z(const Vec3d& v, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]};
}

double VirtualNdf::D(const Vec3d& h) const {
    if (h[2] <= 0.0) return 0.0;
    double sum = 0.0;
    for (const VirtualLobe& lobe : lobes) sum += lobe.weight * leaning_D(lobe, h);
    return sum;
}

double VirtualNdf::area(const Vec3d& k) const {
    double sum = 0.0;
    for (const VirtualLobe& lobe : lobes) {
        const double z = k[2] + k[0] * lobe.lean_x + k[1] * lobe.lean_y;
        sum += lobe.weight * resting_area(lobe, rotated_about_z({k[0], k[1], z}, -lobe.rotation));
    }
    return sum;
}

}  // namespace burnish
