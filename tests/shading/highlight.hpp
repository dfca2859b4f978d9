// Where a plate with a perturbed normal is brightest, and a plate that is really tilted.
#pragma once

#include <cmath>
#include <functional>

#include "lobes_under_test.hpp"

namespace burnish::test {

using verify::angle_deg;
using verify::brightest;
using verify::Radiance;

inline Radiance mapped_plate(const LobeCase& c, int method, vec3 n, vec3 wo) {
    const f64::Lobe lobe = f64::lobe_make(c.mdf, c.p0, c.p1);
    const f64::Perturbation p = perturbation(c, method, n);
    return [=](vec3 wi) {
        return f64::brdf_eval(f64::kBrdfMicrofacet, lobe, p, wi, wo) * f64::dot(p.n, wi);
    };
}

// A plate whose geometry lies in the plane of normal n: an unperturbed lobe in the frame that its
// own surface has. The height field z = -(n.x x + n.y y)/n.z carries the tangent to
// (1, 0, -n.x/n.z) and the bitangent to (0, 1, -n.y/n.z); grooves keep to their carried direction.
inline Radiance tilted_plate(const LobeCase& c, vec3 n, vec3 wo) {
    const bool along_x = c.mdf == f64::kMdfAshikhminShirley ? c.p0 >= c.p1 : c.p0 <= c.p1;
    const vec3 carried = along_x ? vec3{1, 0, -n.x / n.z} : vec3{0, 1, -n.y / n.z};
    const vec3 groove = f64::normalize(carried);
    const vec3 across = f64::cross(n, groove);
    const vec3 x_axis = along_x ? groove : -across;
    const vec3 y_axis = f64::cross(n, x_axis);
    const f64::Lobe lobe = f64::lobe_make(c.mdf, c.p0, c.p1);
    const f64::Perturbation flat = f64::perturb_make(f64::kMethodNone, {0, 0, 1}, true, false);
    const auto local = [=](vec3 w) {
        return vec3{f64::dot(x_axis, w), f64::dot(y_axis, w), f64::dot(n, w)};
    };
    return [=](vec3 wi) {
        return f64::brdf_eval(f64::kBrdfMicrofacet, lobe, flat, local(wi), local(wo)) *
               f64::dot(n, wi);
    };
}

// A plate whose surface is moved by the process of slope-shift or stretch: the unperturbed lobe's facets, moved with
// the vectors of the surface (docs/theory/processes.md, P1 and P2).
inline Radiance moved_plate(const LobeCase& c, int method, vec3 n, vec3 wo) {
    const vec3 x{1, 0, -n.x / n.z}, y{0, 1, -n.y / n.z};
    const vec3 z = method == f64::kMethodSlopeShift ? vec3{0, 0, 1} : n;
    const vec3 across = f64::cross(x, y);
    const double volume = f64::dot(across, z);
    const f64::Lobe lobe = f64::lobe_make(c.mdf, c.p0, c.p1);
    const f64::Perturbation flat = f64::perturb_make(f64::kMethodNone, {0, 0, 1}, true, false);
    // w in the vectors that those of the plate have become.
    const auto seen = [=](vec3 w) {
        return vec3{f64::dot(f64::cross(y, z), w), f64::dot(f64::cross(z, x), w),
                    f64::dot(across, w)} *
               (1 / volume);
    };
    return [=](vec3 wi) {
        const double cos_i = f64::dot(n, wi), cos_o = f64::dot(n, wo);
        if (!(cos_i > 0 && cos_o > 0)) return 0.0;
        const vec3 h = f64::normalize(wi + wo);
        const vec3 q{f64::dot(x, h), f64::dot(y, h), f64::dot(z, h)};
        const double l = f64::length(q);
        if (q.z <= 0) return 0.0;
        const double D = f64::lobe_D(lobe, flat, q * (1 / l)) * volume * volume /
                         (l * l * l * l * f64::length(across));
        return D * f64::smith_G2(lobe, seen(wi), seen(wo)) / (4 * cos_o);
    };
}

}  // namespace burnish::test
