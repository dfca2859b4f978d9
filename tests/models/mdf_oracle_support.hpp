// How closely values of a distribution must agree with the oracle, for the tests that ask.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "burnish/f64.hpp"
#include "burnish/shading_names.hpp"
#include "core/text.hpp"
#include "oracle/make_cases.hpp"
#include "oracle/oracle.hpp"

namespace burnish::test {

inline int index_of(std::span<const std::string_view> names, const std::string& name) {
    return index_of_name(names, name, "name", "test");
}

inline std::string describe(const oracle::MdfCase& c) {
    const auto vec = [](oracle::Vec3 v) {
        return "(" + std::to_string(static_cast<double>(v.x)) + ", " +
               std::to_string(static_cast<double>(v.y)) + ", " +
               std::to_string(static_cast<double>(v.z)) + ")";
    };
    return c.mdf + " " + std::to_string(static_cast<double>(c.p0)) + " " +
           std::to_string(static_cast<double>(c.p1)) + " " + c.method + " " + c.kind + " n " +
           vec(c.n) + " h " + vec(c.h);
}

// D, D_proj, D_conserving as the oracle has them.
inline std::array<double, 3> oracle_values(const oracle::MdfCase& c) {
    const oracle::MdfValue want = oracle::mdf_eval(c.mdf, c.p0, c.p1, c.method, c.n, c.h);
    return {static_cast<double>(want.D), static_cast<double>(want.D_proj),
            static_cast<double>(want.D_conserving)};
}

// What the rounding of the inputs to multiples of `unit` does to a value by itself (edges of the
// domain), in D_proj's scale.
inline double rounding_slack(const oracle::MdfCase& c, const std::array<double, 3>& want,
                             long double unit) {
    const double scale = want[0] > 0 ? std::max(want[1] / want[0], 1.0) : 1.0;
    return 4 * scale *
           static_cast<double>(oracle::mdf_wobble(c.mdf, c.p0, c.p1, c.method, c.n, c.h, unit));
}

// The inputs that a float implementation sees.
inline oracle::MdfCase rounded_to_float(oracle::MdfCase c) {
    const auto rounded = [](long double v) {
        return static_cast<long double>(static_cast<float>(v));
    };
    c.p0 = rounded(c.p0);
    c.p1 = rounded(c.p1);
    c.n = {rounded(c.n.x), rounded(c.n.y), rounded(c.n.z)};
    c.h = {rounded(c.h.x), rounded(c.h.y), rounded(c.h.z)};
    return c;
}

// u of single precision.
inline constexpr double kFloatUnit = 5.9604644775390625e-8;

// Single precision, relative, beyond rounding_slack: 64 u (1 + E + sqrt(e E)), where E =
// |ln(D/peak)| is exponent times |ln z| and e the larger exponent (2/alpha^2). The root is the
// rounding of the half vector itself against the lobe's width. The deformations squeeze the lobe
// against the rim of the disk, where positions are no finer: 1/n~z times that.
inline double float_bound(const oracle::MdfCase& c, double D_proj) {
    const bool exponents = c.mdf == "ashikhmin-shirley";
    const double sharp = static_cast<double>(exponents ? std::max(c.p0, c.p1)
                                                       : 2 / std::pow(std::min(c.p0, c.p1), 2.0L));
    const f64::Lobe lobe = f64::lobe_make(index_of(mdf_names(), c.mdf), static_cast<double>(c.p0),
                                          static_cast<double>(c.p1));
    const double exponent = std::abs(std::log(D_proj / lobe.projected_norm));
    const bool deforms = c.method.starts_with("deform");
    const double squeeze = deforms ? static_cast<double>(oracle::length(c.n) / c.n.z) : 1.0;
    return 64 * kFloatUnit * squeeze * (1 + exponent + std::sqrt(sharp * exponent));
}

}  // namespace burnish::test
