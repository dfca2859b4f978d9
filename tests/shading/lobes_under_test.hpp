// The lobes, methods and tilts that the shading tests go through, and quadrature on the sphere.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "burnish/f32.hpp"
#include "burnish/f64.hpp"
#include "burnish/shading_names.hpp"
#include "core/constants.hpp"

namespace burnish::test {

using f64::vec3;

struct LobeCase {
    int mdf;
    double p0, p1;
};

inline std::vector<LobeCase> lobe_cases() {
    return {{f64::kMdfAshikhminShirley, 200, 10},
            {f64::kMdfAshikhminShirley, 1, 40},
            {f64::kMdfWard, 0.15, 0.5},
            {f64::kMdfWard, 0.4, 0.2},
            {f64::kMdfBeckmann, 0.15, 0.5},
            {f64::kMdfGgx, 0.15, 0.5},
            {f64::kMdfGgx, 0.8, 0.3}};
}

inline constexpr int kMethods = 11;

inline std::string label(const LobeCase& c, int method) {
    return std::string(mdf_names()[static_cast<std::size_t>(c.mdf)]) + "(" + std::to_string(c.p0) +
           "," + std::to_string(c.p1) + ") " +
           std::string(method_names()[static_cast<std::size_t>(method)]);
}

inline vec3 direction(double theta, double phi) {
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

inline f64::Perturbation perturbation(const LobeCase& c, int method, vec3 n) {
    return f64::perturb_make(method, n, f64::lobe_grooves_along_x(c.mdf, c.p0, c.p1), false);
}

// Any orthonormal frame about n, by cross products (not by the text under test).
struct Axes {
    vec3 t, b, n;
    explicit Axes(vec3 axis) : n(axis) {
        const vec3 helper = std::abs(axis.x) < 0.5 ? vec3{1, 0, 0} : vec3{0, 1, 0};
        t = f64::normalize(f64::cross(helper, axis));
        b = f64::cross(axis, t);
    }
    vec3 at(double theta, double phi) const {
        const vec3 v = direction(theta, phi);
        return t * v.x + b * v.y + n * v.z;
    }
};

// Int f dw over the cap theta < theta_max about `axis`: midpoints, theta = u^2 theta_max so that
// points crowd where lobes are narrow.
inline double integrate_cap(const std::function<double(vec3)>& f, vec3 axis, double theta_max,
                            int n_theta, int n_phi) {
    const Axes axes(axis);
    double sum = 0;
    for (int i = 0; i < n_theta; ++i) {
        const double u = (i + 0.5) / n_theta;
        const double theta = theta_max * u * u;
        double ring = 0;
        for (int j = 0; j < n_phi; ++j) {
            ring += f(axes.at(theta, 2 * kPi * (j + 0.5) / n_phi));
        }
        sum += ring * std::sin(theta) * 2 * theta_max * u;
    }
    return sum / n_theta * 2 * kPi / n_phi;
}

}  // namespace burnish::test
