// The shading text against the independent oracle (tests/oracle): values of every distribution
// under every method and of every reflectance model, in double and in single precision.
#include "oracle/oracle.hpp"

#include <gtest/gtest.h>

#include "lobes_under_test.hpp"
#include "oracle/make_cases.hpp"

namespace burnish::test {
namespace {

using oracle::Vec3;

int index_of(std::span<const std::string_view> names, const std::string& name) {
    return index_of_name(names, name, "name", "test");
}

// D, D_proj, D_conserving of the text in either precision.
#define BURNISH_DEFINE_EVAL(ns)                                                                    \
    std::array<double, 3> eval_##ns(const oracle::MdfCase& c) {                                    \
        using F = ns::Float;                                                                       \
        const int mdf = index_of(mdf_names(), c.mdf), method = index_of(method_names(), c.method); \
        const F p0 = static_cast<F>(c.p0), p1 = static_cast<F>(c.p1);                              \
        const auto unit = [](Vec3 v) {                                                             \
            return ns::normalize(                                                                  \
                ns::vec3(static_cast<F>(v.x), static_cast<F>(v.y), static_cast<F>(v.z)));          \
        };                                                                                         \
        const ns::vec3 n = unit(c.n), h = unit(c.h);                                               \
        const ns::Lobe lobe = ns::lobe_make(mdf, p0, p1);                                          \
        const bool along_x = ns::lobe_grooves_along_x(mdf, p0, p1);                                \
        const ns::Perturbation p = ns::perturb_make(method, n, along_x, false);                    \
        const ns::Perturbation conserving = ns::perturb_make(method, n, along_x, true);            \
        return {static_cast<double>(ns::lobe_paper_D(lobe, p, h)),                                 \
                static_cast<double>(ns::lobe_D(lobe, p, h)),                                       \
                static_cast<double>(ns::lobe_D(lobe, conserving, h))};                             \
    }
BURNISH_DEFINE_EVAL(f64)
BURNISH_DEFINE_EVAL(f32)

std::string describe(const oracle::MdfCase& c) {
    const auto vec = [](Vec3 v) {
        return "(" + std::to_string(static_cast<double>(v.x)) + ", " +
               std::to_string(static_cast<double>(v.y)) + ", " +
               std::to_string(static_cast<double>(v.z)) + ")";
    };
    return c.mdf + " " + std::to_string(static_cast<double>(c.p0)) + " " +
           std::to_string(static_cast<double>(c.p1)) + " " + c.method + " " + c.kind + " n " +
           vec(c.n) + " h " + vec(c.h);
}

TEST(Oracle, DistributionsInDoubleAgreeToNineDigits) {
    constexpr long double kEpsilon = 1.2e-16L;
    for (const oracle::MdfCase& c : oracle::mdf_cases(11, 36 * 600)) {
        const oracle::MdfValue want = oracle::mdf_eval(c.mdf, c.p0, c.p1, c.method, c.n, c.h);
        const std::array<double, 3> got = eval_f64(c);
        // Beyond 1e-9 only what the rounding of the inputs themselves does (edges of the domain).
        const long double wobble =
            4 * oracle::mdf_wobble(c.mdf, c.p0, c.p1, c.method, c.n, c.h, kEpsilon);
        const long double scale = want.D > 0 ? want.D_proj / want.D : 1.0L;
        const double slack = static_cast<double>(wobble * std::max(scale, 1.0L)) + 1e-300;
        EXPECT_NEAR(got[0], static_cast<double>(want.D), 1e-9 * static_cast<double>(want.D) + slack)
            << describe(c);
        EXPECT_NEAR(got[1], static_cast<double>(want.D_proj),
                    1e-9 * static_cast<double>(want.D_proj) + slack)
            << describe(c);
        EXPECT_NEAR(got[2], static_cast<double>(want.D_conserving),
                    1e-9 * static_cast<double>(want.D_conserving) + slack)
            << describe(c);
        if (testing::Test::HasFailure()) return;
    }
}

// Single precision against double at the same, float-rounded, inputs: relative error within
// 64 u (1 + E + sqrt(e E)), u = 2^-24, where E = |ln(D/peak)| is exponent times |ln z| and e the
// larger exponent (2/alpha^2). The root is the rounding of the half vector itself against the
// lobe's width; the edges of the domain add their wobble. The deformations squeeze the lobe against
// the rim of the disk, where positions are no finer: 1/n~z times that.
TEST(Oracle, SinglePrecisionStaysWithinItsBound) {
    constexpr double kUnit = 5.9604644775390625e-8;
    double worst = 0;
    for (oracle::MdfCase c : oracle::mdf_cases(12, 36 * 600)) {
        const auto rounded = [](long double v) {
            return static_cast<long double>(static_cast<float>(v));
        };
        c.p0 = rounded(c.p0);
        c.p1 = rounded(c.p1);
        c.n = {rounded(c.n.x), rounded(c.n.y), rounded(c.n.z)};
        c.h = {rounded(c.h.x), rounded(c.h.y), rounded(c.h.z)};
        const bool exponents = c.mdf == "ashikhmin-shirley";
        const double sharp = static_cast<double>(
            exponents ? std::max(c.p0, c.p1) : 2 / std::pow(std::min(c.p0, c.p1), 2.0L));
        const std::array<double, 3> want = eval_f64(c), got = eval_f32(c);
        if (want[1] < 1e-30) {
            continue;
        }  // float's own floor
        const f64::Lobe lobe = f64::lobe_make(index_of(mdf_names(), c.mdf),
                                              static_cast<double>(c.p0), static_cast<double>(c.p1));
        const double exponent = std::abs(std::log(want[1] / lobe.projected_norm));
        const double wobble =
            4 *
            static_cast<double>(oracle::mdf_wobble(c.mdf, c.p0, c.p1, c.method, c.n, c.h, kUnit)) *
            std::max(want[1] / std::max(want[0], 1e-30), 1.0);
        const bool deforms = c.method.starts_with("deform");
        const double squeeze = deforms ? static_cast<double>(oracle::length(c.n) / c.n.z) : 1.0;
        const double bound = 64 * kUnit * squeeze * (1 + exponent + std::sqrt(sharp * exponent));
        for (std::size_t k = 0; k < 3; ++k) {
            const double error = std::max(std::abs(got[k] - want[k]) - wobble, 0.0) / want[k];
            worst = std::max(worst, error / bound);
            EXPECT_LE(error, bound) << describe(c) << " want " << want[k] << " got " << got[k];
        }
        if (testing::Test::HasFailure()) return;
    }
    RecordProperty("worst_share_of_bound", std::to_string(worst));
}

double model_value(const oracle::BrdfCase& c) {
    const auto unit = [](Vec3 v) {
        return f64::normalize(
            vec3(static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)));
    };
    const vec3 i = unit(c.i), o = unit(c.o);
    const bool gmd = c.brdf == "ward-gmd";
    int brdf = f64::kBrdfMicrofacet, mdf = f64::kMdfGgx;
    if (c.brdf == "ashikhmin-shirley") {
        brdf = f64::kBrdfAshikhminShirley;
    }
    if (gmd) {
        brdf = f64::kBrdfWardGmd;
    }
    if (c.brdf == "ggx-separable") {
        brdf = f64::kBrdfMicrofacetSeparable;
    }
    if (c.brdf == "beckmann") {
        mdf = f64::kMdfBeckmann;
    }
    const auto p = [&](std::size_t k) { return static_cast<double>(c.p[k]); };
    const f64::Lobe lobe = f64::lobe_make(f64::brdf_mdf(brdf, mdf), p(gmd ? 1 : 0), p(gmd ? 2 : 1));
    const f64::Perturbation flat = f64::perturb_make(f64::kMethodNone, {0, 0, 1}, true, false);
    const double f = f64::brdf_eval(brdf, lobe, flat, i, o);
    if (gmd) {
        return p(0) * f;
    }
    const vec3 h = f64::normalize(i + o);
    return f * f64::fresnel_schlick(p(2), f64::dot(i, h));
}

TEST(Oracle, ReflectanceModelsAgreeToNineDigits) {
    for (const oracle::BrdfCase& c : oracle::brdf_cases(13, 20000)) {
        const double want = static_cast<double>(oracle::brdf_eval(c.brdf, c.p, c.i, c.o));
        const double wobble =
            4 * static_cast<double>(oracle::brdf_wobble(c.brdf, c.p, c.i, c.o, 1.2e-16L));
        // 1e-60: with F0 = 0 and i = o Schlick's (1 - i.h)^5 is the fifth power of rounding error.
        EXPECT_NEAR(model_value(c), want, 1e-9 * want + wobble + 1e-60)
            << c.brdf << " " << c.kind << " i.z " << static_cast<double>(c.i.z) << " o.z "
            << static_cast<double>(c.o.z) << " p0 " << static_cast<double>(c.p[0]) << " p1 "
            << static_cast<double>(c.p[1]);
        if (testing::Test::HasFailure()) return;
    }
}

}  // namespace
}  // namespace burnish::test
