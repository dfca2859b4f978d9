// Directions on the sphere, integrals over it, and where a function of the direction is greatest. Double precision.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>

#include "burnish/f64.hpp"
#include "core/constants.hpp"

namespace burnish::verify {

using f64::vec3;

// Angles in radians; theta from z, phi from x towards y.
inline vec3 direction(double theta, double phi) {
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

inline double angle_deg(vec3 a, vec3 b) {
    return std::atan2(f64::length(f64::cross(a, b)), f64::dot(a, b)) * kDegreesPerRadian;
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

using Radiance = std::function<double(vec3 wi)>;

// The direction that maximises `radiance`: a grid of `rings` over the sphere, then ever finer ones
// around the best point.
inline vec3 brightest(const Radiance& radiance, int first_rings = 360) {
    vec3 best{0, 0, 1};
    double best_value = -1;
    double reach = kPi;
    vec3 center = direction(1e-4, 0.3);
    for (int level = 0; level < 12; ++level) {
        const Axes axes(center);
        const int rings = level == 0 ? first_rings : 24;
        const int sectors = level == 0 ? 2 * first_rings : 48;
        for (int i = 0; i < rings; ++i) {
            for (int j = 0; j < sectors; ++j) {
                const vec3 wi = axes.at(reach * i / rings, 2 * kPi * j / sectors);
                const double value = radiance(wi);
                if (value > best_value) {
                    best_value = value;
                    best = wi;
                }
            }
        }
        center = best;
        reach = level == 0 ? 7.2 / first_rings : reach * 0.4;
    }
    return best;
}

}  // namespace burnish::verify
