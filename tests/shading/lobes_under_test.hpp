// The lobes, methods and tilts that the shading tests go through.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "burnish/f32.hpp"
#include "burnish/f64.hpp"
#include "burnish/shading_names.hpp"
#include "core/constants.hpp"
#include "verify/sphere.hpp"

namespace burnish::test {

using f64::vec3;
using verify::Axes;
using verify::direction;
using verify::integrate_cap;

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

inline f64::Perturbation perturbation(const LobeCase& c, int method, vec3 n) {
    return f64::perturb_make(method, n, f64::lobe_grooves_along_x(c.mdf, c.p0, c.p1), false);
}

}  // namespace burnish::test
