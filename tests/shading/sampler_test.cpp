// Samplers: densities integrate to one, samples follow them (chi-square, corrected for the number
// of tests), and the forward maps invert the methods.
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "chi_square.hpp"
#include "lobes_under_test.hpp"
#include "oracle/oracle.hpp"

namespace burnish::test {
namespace {

const vec3 kTilted = direction(40 * kPi / 180, 0.9);

class MethodSampler : public testing::TestWithParam<int> {};

constexpr double kFamilyError = 0.01;  // chance that any of a family of tests fails by luck

TEST_P(MethodSampler, FollowsItsDensity) {
    const int method = GetParam();
    const double tests = static_cast<double>(lobe_cases().size()) * kMethods;
    for (const LobeCase& c : lobe_cases()) {
        const f64::Lobe lobe = f64::lobe_make(c.mdf, c.p0, c.p1);
        const f64::Perturbation p = perturbation(c, method, kTilted);
        double integral = 0;
        const double p_value =
            sampler_p_value([&](vec3 h) { return f64::lobe_pdf(lobe, p, h); },
                            [&](double a, double b, double s) {
                                return f64::lobe_sample(lobe, p, {a, b}, s);
                            },
                            Axes(p.n), static_cast<unsigned>(7 + method * 31 + c.mdf), integral);
        EXPECT_GT(p_value, kFamilyError / tests) << label(c, method);
        EXPECT_NEAR(integral, 1.0, 5e-3) << label(c, method);
    }
}

constexpr std::array<int, 3> kVisibleNormalMethods = {f64::kMethodFollowGrain,
                                                      f64::kMethodSlopeShift, f64::kMethodStretch};

// Visible normals, by the half vectors that brdf_sample's directions imply.
TEST(Sampler, VisibleNormalsFollowTheirDensity) {
    const LobeCase cases[] = {{f64::kMdfGgx, 0.15, 0.5},
                              {f64::kMdfGgx, 0.8, 0.3},
                              {f64::kMdfGgx, 0.7, 0.7},
                              {f64::kMdfGgx, 1.3, 1.1}};
    const vec3 views[] = {kTilted, {0, 0, 1}, direction(1.2, 4.0), direction(1.1, 0.9)};
    for (const int method : kVisibleNormalMethods) {
        for (const LobeCase& c : cases) {
            for (const vec3& wo : views) {
                const f64::Lobe lobe = f64::lobe_make(c.mdf, c.p0, c.p1);
                const f64::Perturbation p = perturbation(c, method, kTilted);
                if (f64::dot(p.n, wo) < 0.05) {
                    continue;
                }
                double integral = 0, pdf = 0;
                const double p_value = sampler_p_value(
                    [&](vec3 h) { return f64::visible_normal_pdf(lobe, p, wo, h); },
                    [&](double a, double b, double s) {
                        return f64::normalize(
                            f64::brdf_sample(f64::kBrdfMicrofacet, lobe, p, wo, {a, b}, s, pdf) +
                            wo);
                    },
                    Axes(p.n), 99, integral);
                EXPECT_GT(p_value, kFamilyError / 48) << label(c, method);
                EXPECT_NEAR(integral, 1.0, 5e-3) << label(c, method);
            }
        }
    }
}

// f cos / pdf <= G2 / G1 <= 1, and brdf_pdf is the density that brdf_sample reports. G1 of GGX is
// 2 / (1 + sqrt(1 + tan^2)), tan the slope of wo in the space scaled by the roughness pair.
TEST(Sampler, VisibleNormalsBoundTheWeight) {
    std::mt19937 generator(17);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int i = 0; i < 40000; ++i) {
        const LobeCase c{f64::kMdfGgx, 0.02 + 1.3 * uniform(generator) * uniform(generator),
                         0.02 + 1.3 * uniform(generator) * uniform(generator)};
        const f64::Lobe lobe = f64::lobe_make(c.mdf, c.p0, c.p1);
        const vec3 n = direction(1.2 * uniform(generator), 2 * kPi * uniform(generator));
        const int method = kVisibleNormalMethods[static_cast<std::size_t>(i % 3)];
        const f64::Perturbation p = perturbation(c, method, n);
        const vec3 wo = direction(1.5 * uniform(generator), 2 * kPi * uniform(generator));
        double pdf = 0;
        const vec3 wi = f64::brdf_sample(f64::kBrdfMicrofacet, lobe, p, wo,
                                         {uniform(generator), uniform(generator)}, 0, pdf);
        if (pdf == 0 || f64::dot(n, wi) <= 0) {
            continue;
        }
        const double f = f64::brdf_eval(f64::kBrdfMicrofacet, lobe, p, wi, wo);
        const vec3 v = f64::perturb_direction(p, wo), l = f64::perturb_direction(p, wi);
        const auto lambda = [&](vec3 w) {
            return (std::sqrt(1 +
                              (std::pow(c.p0 * w.x, 2) + std::pow(c.p1 * w.y, 2)) / (w.z * w.z)) -
                    1) /
                   2;
        };
        const double unbounded = (1 + lambda(v)) / (1 + lambda(v) + lambda(l));
        EXPECT_LE(f * f64::dot(n, wi) / pdf, unbounded * (1 + 1e-6)) << label(c, method);
        EXPECT_NEAR(f64::brdf_pdf(f64::kBrdfMicrofacet, lobe, p, wi, wo) / pdf, 1, 1e-6);
    }
}

// The cap from which reflections are drawn holds all that reach the eye's side of the surface: the
// density is positive wherever the model is, grazing views and roughness above 1 included.
TEST(Sampler, VisibleNormalsReachEveryReflectionAboveTheHorizon) {
    std::mt19937 generator(23);
    std::uniform_real_distribution<double> uniform(0, 1);
    const f64::Perturbation flat = f64::perturb_make(f64::kMethodNone, {0, 0, 1}, true, false);
    for (int i = 0; i < 200000; ++i) {
        const f64::Lobe lobe =
            f64::lobe_make(f64::kMdfGgx, std::pow(10.0, -2 + 2.2 * uniform(generator)),
                           std::pow(10.0, -2 + 2.2 * uniform(generator)));
        const auto above = [&] {
            // Directions crowd at the horizon, where the cap ends.
            return direction(std::acos(std::pow(uniform(generator), 4)),
                             2 * kPi * uniform(generator));
        };
        const vec3 wo = above(), wi = above();
        EXPECT_GT(f64::brdf_pdf(f64::kBrdfMicrofacet, lobe, flat, wi, wo), 0.0)
            << lobe.p0 << " " << lobe.p1 << " " << wo.z << " " << wi.z;
        if (testing::Test::HasFailure()) return;
    }
}

// The mean of the weights is the energy that the second derivation (oracle.hpp) reflects, integrated on a
// grid.
TEST(Sampler, VisibleNormalsReflectTheEnergyOfTheModel) {
    const f64::Perturbation flat = f64::perturb_make(f64::kMethodNone, {0, 0, 1}, true, false);
    for (const double tilt : {0.3, 1.0, 1.4}) {
        for (const LobeCase& c :
             {LobeCase{f64::kMdfGgx, 0.2, 0.5}, LobeCase{f64::kMdfGgx, 0.7, 0.7},
              LobeCase{f64::kMdfGgx, 1.2, 0.4}}) {
            const vec3 wo = direction(tilt, 0.7);
            const auto reflected = [&](vec3 wi) {
                return wi.z <= 0 ? 0.0
                                 : wi.z * static_cast<double>(oracle::brdf_eval(
                                              "ggx", {c.p0, c.p1, 1.0L}, {wi.x, wi.y, wi.z},
                                              {wo.x, wo.y, wo.z}));
            };
            const vec3 mirror{-wo.x, -wo.y, wo.z};
            const double energy = integrate_cap(reflected, mirror, kPi, 300, 300);
            std::mt19937 generator(31);
            std::uniform_real_distribution<double> uniform(0, 1);
            const f64::Lobe lobe = f64::lobe_make(c.mdf, c.p0, c.p1);
            double sum = 0;
            constexpr int kDraws = 100000;
            for (int i = 0; i < kDraws; ++i) {
                double pdf = 0;
                const vec3 wi = f64::brdf_sample(f64::kBrdfMicrofacet, lobe, flat, wo,
                                                 {uniform(generator), uniform(generator)}, 0, pdf);
                if (pdf > 0 && wi.z > 0)
                    sum += f64::brdf_eval(f64::kBrdfMicrofacet, lobe, flat, wi, wo) * wi.z / pdf;
            }
            // Weights lie in [0, 1]: the standard deviation of the mean is below 0.5 / sqrt(100000),
            // 0.0016, and the grid errs by less than 0.001.
            EXPECT_NEAR(sum / kDraws, energy, 0.006) << tilt << " " << c.p0 << " " << c.p1;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Methods, MethodSampler, testing::Range(0, kMethods));

// perturb_forward is the inverse of the map that perturb_point evaluates.
TEST(ForwardMap, InvertsThePoint) {
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> uniform(0, 1);
    const LobeCase c{f64::kMdfGgx, 0.3, 0.6};
    for (int method = 0; method < kMethods; ++method) {
        if (method == f64::kMethodNormalMap || method == f64::kMethodRotateApprox) {
            continue;
        }
        for (int i = 0; i < 2000; ++i) {
            const vec3 n = direction(1.2 * uniform(generator), 2 * kPi * uniform(generator));
            const f64::Perturbation p = perturbation(c, method, n);
            const vec3 m = direction(1.5 * uniform(generator), 2 * kPi * uniform(generator));
            const f64::LobePoint q =
                f64::lobe_point_unit(f64::perturb_point(p, f64::perturb_forward(p, m)));
            EXPECT_NEAR(q.x, m.x, 1e-9) << label(c, method);
            EXPECT_NEAR(q.y, m.y, 1e-9) << label(c, method);
        }
    }
}

// The deformations' determinants against finite differences of the map on the disk.
TEST(ForwardMap, JacobianMatchesFiniteDifferences) {
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> uniform(0, 1);
    const LobeCase c{f64::kMdfGgx, 0.3, 0.6};
    for (int method : {f64::kMethodDeformLinear, f64::kMethodDeformSmooth}) {
        for (int i = 0; i < 500; ++i) {
            const vec3 n = direction(1.1 * uniform(generator), 2 * kPi * uniform(generator));
            const vec3 h = direction(1.3 * uniform(generator), 2 * kPi * uniform(generator));
            const f64::Perturbation p = perturbation(c, method, n);
            if (std::hypot(h.x - n.x, h.y - n.y) < 0.02) {
                continue;
            }  // kink at C'
            const auto q = [&](double dx, double dy) {
                const double x = h.x + dx, y = h.y + dy;
                return f64::perturb_point(p, {x, y, std::sqrt(1 - x * x - y * y)});
            };
            if (q(0, 0).weight == 0) {
                continue;
            }
            const double e = 1e-6;
            const f64::LobePoint px = q(e, 0), mx = q(-e, 0), py = q(0, e), my = q(0, -e);
            const double det =
                ((px.x - mx.x) * (py.y - my.y) - (px.y - mx.y) * (py.x - my.x)) / (4 * e * e);
            EXPECT_NEAR(f64::deform_jacobian(method, n, h), det, 1e-5 * (1 + std::abs(det)))
                << label(c, method);
        }
    }
}

}  // namespace
}  // namespace burnish::test
