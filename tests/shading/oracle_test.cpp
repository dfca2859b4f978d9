// The shading text against the independent oracle (tests/oracle): values of every distribution
// under every method and of every reflectance model, in double and in single precision.
#include "oracle/oracle.hpp"

#include <gtest/gtest.h>

#include "lobes_under_test.hpp"
#include "models/mdf_oracle_support.hpp"
#include "oracle/make_cases.hpp"

namespace burnish::test {
namespace {

using oracle::Vec3;

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

TEST(Oracle, DistributionsInDoubleAgreeToNineDigits) {
    for (const oracle::MdfCase& c : oracle::mdf_cases(11, 44 * 600)) {
        const std::array<double, 3> want = oracle_values(c), got = eval_f64(c);
        const double slack = rounding_slack(c, want, 1.2e-16L) + 1e-300;
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(got[k], want[k], 1e-9 * want[k] + slack) << describe(c);
        if (testing::Test::HasFailure()) return;
    }
}

// Against double at the same, float-rounded, inputs.
TEST(Oracle, SinglePrecisionStaysWithinItsBound) {
    double worst = 0;
    for (const oracle::MdfCase& exact : oracle::mdf_cases(12, 44 * 600)) {
        const oracle::MdfCase c = rounded_to_float(exact);
        const std::array<double, 3> want = eval_f64(c), got = eval_f32(c);
        if (want[1] < 1e-30) {
            continue;
        }  // float's own floor
        const double slack = rounding_slack(c, want, static_cast<long double>(kFloatUnit));
        const double bound = float_bound(c, want[1]);
        for (std::size_t k = 0; k < 3; ++k) {
            const double error = std::max(std::abs(got[k] - want[k]) - slack, 0.0) / want[k];
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
