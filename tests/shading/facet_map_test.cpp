// slope-shift and stretch: the lobe of a plate whose surface is moved by a linear map. The second derivation is
// oracle/facet_maps.hpp, from the vectors of the surface; the sums here are over the facets of the base plate or over
// half vectors, never by the map under test.
#include <gtest/gtest.h>

#include <array>
#include <random>

#include "burnish/scene.hpp"
#include "highlight.hpp"
#include "lobes_under_test.hpp"
#include "maps/normal/slope_mips.hpp"
#include "oracle/facet_maps.hpp"

namespace burnish::test {
namespace {

constexpr std::array<int, 2> kMoved = {f64::kMethodSlopeShift, f64::kMethodStretch};
constexpr std::array<double, 5> kTilts = {0, 15, 30, 45, 60};

std::string named(int method) {
    return std::string(method_names()[static_cast<std::size_t>(method)]);
}

oracle::Vec3 wide(vec3 v) {
    return {v.x, v.y, v.z};
}

vec3 narrow(oracle::Vec3 v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

vec3 tilted(double tilt_deg, double azimuth_deg) {
    return direction(tilt_deg * kPi / 180, azimuth_deg * kPi / 180);
}

const f64::Perturbation& flat() {
    static const f64::Perturbation p = f64::perturb_make(f64::kMethodNone, {0, 0, 1}, true, false);
    return p;
}

template <typename Each>
void for_each_case(const Each& each) {
    for (const LobeCase& c : lobe_cases())
        for (const int method : kMoved)
            for (const double tilt : kTilts)
                for (const double azimuth : {20.0, 130.0}) each(c, method, tilted(tilt, azimuth));
}

std::string label(const LobeCase& c, int method, vec3 n) {
    return test::label(c, method) + " tilt " + std::to_string(std::acos(n.z) * 180 / kPi);
}

// A facet's own direction and area on the displaced plate, for one of the base plate's: `area` counts a unit of
// the displaced plate. By the oracle.
struct MovedFacet {
    vec3 h;
    double area;
};

MovedFacet moved(int method, vec3 n, vec3 m) {
    const oracle::Vec3 v = oracle::moved_facet(named(method), wide(n), wide(m));
    const oracle::Vec3 plate = oracle::moved_facet(named(method), wide(n), {0, 0, 1});
    const double length = static_cast<double>(oracle::length(v));
    return {narrow(v) * (1 / length), length / static_cast<double>(oracle::length(plate))};
}

// Int f D0 dm over the facets of the base plate.
double over_facets(const LobeCase& c, const std::function<double(vec3 m)>& f, int rings = 120) {
    const f64::Lobe lobe = f64::lobe_make(c.mdf, c.p0, c.p1);
    return integrate_cap([&](vec3 m) { return f64::lobe_D(lobe, flat(), m) * f(m); }, {0, 0, 1},
                         kPi / 2, rings, 2 * rings);
}

// Signed: facets that overhang the displaced plate count against those that face it. 3e-4: a lobe that slope-shift
// narrows to a quarter, and the horizon of the base plate, where broad lobes end with a step, lie across the grid.
TEST(FacetMap, DistributionsIntegrateToOneAboutThePerturbedNormal) {
    double worst = 0;
    for_each_case([&](const LobeCase& c, int method, vec3 n) {
        const f64::Lobe lobe = f64::lobe_make(c.mdf, c.p0, c.p1);
        const f64::Perturbation p = perturbation(c, method, n);
        const double sum = integrate_cap(
            [&](vec3 h) { return f64::lobe_D(lobe, p, h) * f64::dot(n, h); }, n, kPi, 400, 400);
        worst = std::max(worst, std::abs(sum - 1));
        EXPECT_NEAR(sum, 1.0, 3e-4) << label(c, method, n);
    });
    RecordProperty("worst", std::to_string(worst));
    if (std::getenv("BURNISH_PRINT_FACETS")) std::printf("Int D (n~.h): %.2g\n", worst);
}

TEST(FacetMap, WithoutATiltAllIsTheBaseLobe) {
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> uniform(0, 1);
    const auto any = [&] { return direction(1.5 * uniform(generator), 6.3 * uniform(generator)); };
    for (const LobeCase& c : lobe_cases()) {
        const f64::Lobe lobe = f64::lobe_make(c.mdf, c.p0, c.p1);
        for (const int method : kMoved) {
            const f64::Perturbation p = perturbation(c, method, {0, 0, 1});
            for (int i = 0; i < 200; ++i) {
                const vec3 wi = any(), wo = any(), h = f64::normalize(wi + wo);
                // 1e-12: an exponent of 200 times the rounding of a normalization.
                const double D = f64::lobe_D(lobe, flat(), h);
                EXPECT_NEAR(f64::lobe_D(lobe, p, h), D, 1e-12 * D);
                for (int brdf = 0; brdf <= f64::kBrdfCookTorrance; ++brdf) {
                    const f64::Lobe own =
                        f64::brdf_mdf(brdf, c.mdf) == c.mdf
                            ? lobe
                            : f64::lobe_make(f64::kMdfBeckmann, f64::lobe_alpha_x(lobe),
                                             f64::lobe_alpha_y(lobe));
                    const double f = f64::brdf_eval(brdf, own, p, wi, wo);
                    const double base = f64::brdf_eval(brdf, own, flat(), wi, wo);
                    EXPECT_NEAR(f, base, 1e-12 * base) << test::label(c, method) << brdf;
                }
            }
        }
    }
}

// The area that a direction sees of the displaced plate is the sum over its facets, by quadrature, and (n~.w)/G1 by
// the closed form. GGX and Beckmann: exact; the others within their fit of G1 (smith_test.cpp, 0.0115).
TEST(FacetMap, ClosedMaskingIsTheVisibleArea) {
    double exact = 0, fitted = 0;
    for_each_case([&](const LobeCase& c, int method, vec3 n) {
        const f64::Lobe lobe = f64::lobe_make(c.mdf, c.p0, c.p1);
        const f64::Perturbation p = perturbation(c, method, n);
        for (const vec3& w : {tilted(10, 0), tilted(50, 200), tilted(70, 20), tilted(75, 300)}) {
            const double cosine = f64::dot(n, w);
            const double g = f64::smith_G1(lobe, f64::perturb_direction(p, w));
            if (cosine <= 0) {
                EXPECT_EQ(g, 0.0) << label(c, method, n);
                continue;
            }
            const double area = over_facets(c, [&](vec3 m) {
                const MovedFacet facet = moved(method, n, m);
                return facet.area * std::max(f64::dot(facet.h, w), 0.0);
            });
            const bool has_fit = c.mdf == f64::kMdfAshikhminShirley || c.mdf == f64::kMdfWard;
            const double error = std::abs(g - cosine / area);
            (has_fit ? fitted : exact) = std::max(has_fit ? fitted : exact, error);
            // 5e-4: the sum's own error, at directions near the horizon of n~.
            EXPECT_NEAR(g, cosine / area, has_fit ? 0.0125 : 5e-4) << label(c, method, n);
        }
    });
    if (std::getenv("BURNISH_PRINT_FACETS"))
        std::printf("G1: exact %.2g, fitted %.2g\n", exact, fitted);
}

// Light that facets reflect once, as a sum over the facets that wo sees and the closed masking of both directions:
// at most all of it, and what brdf_sample's own weights give.
double reflected_share(const LobeCase& c, int method, vec3 n, vec3 wo) {
    const f64::Lobe lobe = f64::lobe_make(c.mdf, c.p0, c.p1);
    const f64::Perturbation p = perturbation(c, method, n);
    const auto lambda = [&](vec3 w) {
        return f64::smith_lambda(lobe, f64::perturb_direction(p, w));
    };
    const double seen = f64::dot(n, wo) * (1 + lambda(wo));
    return over_facets(
               c,
               [&](vec3 m) {
                   const MovedFacet facet = moved(method, n, m);
                   const double o_h = f64::dot(facet.h, wo);
                   const vec3 wi = f64::reflect_about(wo, facet.h);
                   if (o_h <= 0 || f64::dot(n, wi) <= 0) return 0.0;
                   return facet.area * o_h * (1 + lambda(wo)) / (1 + lambda(wo) + lambda(wi));
               },
               80) /
           seen;
}

TEST(FacetMap, ReflectsNoMoreThanAllLight) {
    double most = 0, apart = 0;
    for_each_case([&](const LobeCase& c, int method, vec3 n) {
        const f64::Lobe lobe = f64::lobe_make(c.mdf, c.p0, c.p1);
        const f64::Perturbation p = perturbation(c, method, n);
        for (const vec3& wo : {vec3{0, 0, 1}, tilted(50, 200), tilted(70, 20)}) {
            if (f64::dot(n, wo) < 0.05) continue;
            const double share = reflected_share(c, method, n, wo);
            std::mt19937 generator(5);
            std::uniform_real_distribution<double> uniform(0, 1);
            double sum = 0, squares = 0;
            constexpr int kDraws = 20000;
            for (int i = 0; i < kDraws; ++i) {
                double pdf = 0;
                const vec3 wi = f64::brdf_sample(f64::kBrdfMicrofacet, lobe, p, wo,
                                                 {uniform(generator), uniform(generator)}, 0, pdf);
                if (pdf <= 0 || f64::dot(n, wi) <= 0) continue;
                const double weight =
                    f64::brdf_eval(f64::kBrdfMicrofacet, lobe, p, wi, wo) * f64::dot(n, wi) / pdf;
                sum += weight;
                squares += weight * weight;
            }
            const double mean = sum / kDraws;
            const double error = std::sqrt(squares / kDraws / kDraws);
            // Fits of Smith's term gain what they err by at grazing views.
            const bool has_fit = c.mdf == f64::kMdfAshikhminShirley || c.mdf == f64::kMdfWard;
            EXPECT_LE(share, has_fit ? 1.012 : 1.001) << label(c, method, n) << " " << wo.z;
            EXPECT_NEAR(mean, share, 5 * error + 3e-3) << label(c, method, n) << " " << wo.z;
            most = std::max(most, share);
            apart = std::max(apart, std::abs(mean - share));
        }
    });
    if (std::getenv("BURNISH_PRINT_FACETS"))
        std::printf("furnace: most %.5f, samples apart %.2g\n", most, apart);
}

TEST(FacetMap, IsReciprocal) {
    std::mt19937 generator(11);
    std::uniform_real_distribution<double> uniform(0, 1);
    for_each_case([&](const LobeCase& c, int method, vec3 n) {
        const f64::Lobe lobe = f64::lobe_make(c.mdf, c.p0, c.p1);
        const f64::Perturbation p = perturbation(c, method, n);
        for (int i = 0; i < 50; ++i) {
            const vec3 wi = direction(1.5 * uniform(generator), 6.3 * uniform(generator));
            const vec3 wo = direction(1.5 * uniform(generator), 6.3 * uniform(generator));
            const double f = f64::brdf_eval(f64::kBrdfMicrofacet, lobe, p, wi, wo);
            EXPECT_NEAR(f64::brdf_eval(f64::kBrdfMicrofacet, lobe, p, wo, wi), f, 1e-12 * f);
        }
    });
}

// Measured: below 0.01 degrees, where the search ends.
TEST(FacetMap, HighlightsAreThoseOfTheProcess) {
    double worst = 0;
    for (const LobeCase& c :
         {LobeCase{f64::kMdfGgx, 0.1, 0.5}, LobeCase{f64::kMdfGgx, 0.6, 0.2},
          LobeCase{f64::kMdfBeckmann, 0.2, 0.6}, LobeCase{f64::kMdfWard, 0.1, 0.5},
          LobeCase{f64::kMdfAshikhminShirley, 200, 10}}) {
        for (const int method : kMoved) {
            for (const double tilt : {15.0, 30.0, 45.0}) {
                const vec3 n = tilted(tilt, 143);
                for (const vec3& wo : {vec3{0, 0, 1}, direction(0.5, 1.0)}) {
                    const Radiance mapped = mapped_plate(c, method, n, wo);
                    const Radiance truth = moved_plate(c, method, n, wo);
                    const double angle = angle_deg(brightest(mapped, 90), brightest(truth, 90));
                    worst = std::max(worst, angle);
                    EXPECT_LT(angle, 0.1) << label(c, method, n);
                    for (const double theta : {0.2, 0.6, 1.0}) {
                        const vec3 wi = direction(theta, 1.9);
                        EXPECT_NEAR(mapped(wi), truth(wi), 1e-9 * (1 + truth(wi)));
                    }
                }
            }
        }
    }
    if (std::getenv("BURNISH_PRINT_FACETS")) std::printf("highlight: %.3g degrees\n", worst);
}

// ---- from afar ----------------------------------------------------------------------------------

// Facets of direction h over a unit of the base plate: D of the displaced plate over the n~z by which it is larger.
double over_base(const f64::Lobe& lobe, vec3 n, vec3 h) {
    return f64::lobe_D(lobe, f64::perturb_make(f64::kMethodSlopeShift, n, true, false), h) / n.z;
}

// Beckmann lobes over bumps of Gaussian slopes: the mean over the bumps is the widened lobe over the mean slope, for
// every half vector. The sum over +-6 deviations in 120 steps is good to 1e-9.
TEST(FacetMap, MomentsOfGaussianBumpsAreExactUnderSlopeShift) {
    const f64::Lobe lobe = f64::lobe_make(f64::kMdfBeckmann, 0.1, 0.3);
    const f64::vec2 mean(0.4, -0.3), variance(0.02, 0.05), one(1, 1);
    const vec3 n = f64::normal_of_slopes(mean.x, mean.y);
    const f64::vec2 v = f64::variance_under(f64::kMethodSlopeShift, n, variance, one);
    EXPECT_EQ(v.x, variance.x);
    EXPECT_EQ(v.y, variance.y);
    const f64::Lobe lobe_wide = f64::widen_lobe(lobe, v.x, v.y);
    for (const vec3& h : {n, tilted(0, 0), tilted(20, 100), tilted(40, 300), tilted(50, 320)}) {
        double sum = 0, weights = 0;
        constexpr int kSteps = 120;
        for (int i = 0; i < kSteps; ++i) {
            for (int j = 0; j < kSteps; ++j) {
                const double x = 12 * (i + 0.5) / kSteps - 6, y = 12 * (j + 0.5) / kSteps - 6;
                const double weight = std::exp(-(x * x + y * y) / 2);
                // Not normal_of_slopes, which holds the steepest.
                const vec3 bump = f64::normalize(vec3{mean.x + x * std::sqrt(variance.x),
                                                      mean.y + y * std::sqrt(variance.y), 1});
                sum += weight * over_base(lobe, bump, h);
                weights += weight;
            }
        }
        const double got = over_base(lobe_wide, n, h);
        EXPECT_NEAR(sum / weights / got, 1, 1e-7) << h.z;
    }
}

// stretch: the widened lobe is that of the bumps to first order in the steps of slope.
TEST(FacetMap, MomentsOfSmallBumpsAreNearUnderStretch) {
    const f64::Lobe lobe = f64::lobe_make(f64::kMdfBeckmann, 0.1, 0.3);
    const vec3 n = f64::normal_of_slopes(0.4, -0.3);
    const f64::vec2 variance(0.001, 0.002);
    const f64::vec2 v = f64::variance_under(f64::kMethodStretch, n, variance, f64::vec2(1, 1));
    const f64::Lobe lobe_wide = f64::widen_lobe(lobe, v.x, v.y);
    const auto value = [](const f64::Lobe& l, vec3 at, vec3 h) {
        return f64::lobe_D(l, f64::perturb_make(f64::kMethodStretch, at, true, false), h) / at.z;
    };
    double sum = 0, weights = 0;
    constexpr int kSteps = 60;
    for (int i = 0; i < kSteps; ++i) {
        for (int j = 0; j < kSteps; ++j) {
            const double x = 12 * (i + 0.5) / kSteps - 6, y = 12 * (j + 0.5) / kSteps - 6;
            const double weight = std::exp(-(x * x + y * y) / 2);
            const vec3 bump = f64::normalize(
                vec3{0.4 + x * std::sqrt(variance.x), -0.3 + y * std::sqrt(variance.y), 1});
            sum += weight * value(lobe, bump, n);
            weights += weight;
        }
    }
    const double mean = sum / weights, got = value(lobe_wide, n, n),
                 narrow_lobe = value(lobe, n, n);
    // Bumps take a sixth of the peak away; what the widening leaves of that error is a tenth.
    EXPECT_GT(std::abs(narrow_lobe / mean - 1), 0.08);
    EXPECT_LT(std::abs(got / mean - 1), 0.02);
}

// Normals of slopes about (0.3, 0.2), in single precision.
Texture gaussian_bumps(int side, float sigma_x, float sigma_y) {
    std::mt19937 generator(1);
    std::normal_distribution<float> normal(0, 1);
    Texture map{"map", side, side, 3, TexelType::f32, ColorSpace::linear, {}};
    for (int i = 0; i < side * side; ++i) {
        const float x = 0.3f + sigma_x * normal(generator);
        const float y = 0.2f + sigma_y * normal(generator);
        const float z = 0.5f / std::sqrt(1 + x * x + y * y);
        const std::array<float, 3> texel = {0.5f + x * z, 0.5f + y * z, 0.5f + z};
        const auto* bytes = reinterpret_cast<const std::byte*>(texel.data());
        map.texels.insert(map.texels.end(), bytes, bytes + sizeof texel);
    }
    return map;
}

// Every mip of a map of Gaussian bumps, whose texels are means and variances, shows the same lobe: that of the summed
// covariance. Four or sixteen bumps under a texel are no Gaussian yet: measured 0.091 and 0.036 apart. From 64 on, and
// without a mip, what is left is that of 65,536 bumps, whose lobes have a standard error of 0.7 % in the mean: 0.03.
TEST(FacetMap, EveryMipOfGaussianBumpsShowsTheSameLobe) {
    constexpr float kSigmaX = 0.15f, kSigmaY = 0.25f;
    const std::vector<SlopeLevel> mips = slope_mips(gaussian_bumps(256, kSigmaX, kSigmaY));
    const f64::Lobe lobe = f64::lobe_make(f64::kMdfBeckmann, 0.15, 0.3);
    const f64::Lobe all = f64::widen_lobe(lobe, kSigmaX * kSigmaX, kSigmaY * kSigmaY);
    const vec3 mean = f64::normal_of_slopes(0.3, 0.2);
    ASSERT_EQ(mips.size(), 9u);
    for (const SlopeLevel& level : mips) {
        const double bound = level.width == 128 ? 0.12 : level.width == 64 ? 0.05 : 0.03;
        for (const vec3& h : {mean, tilted(0, 0), tilted(30, 60)}) {
            double sum = 0;
            for (const SlopeTexel& t : level.texels) {
                const vec3 n =
                    f64::normalize(vec3{static_cast<double>(t.x), static_cast<double>(t.y), 1});
                const f64::vec2 v = f64::variance_under(
                    f64::kMethodSlopeShift, n,
                    f64::vec2(static_cast<double>(t.variance_x), static_cast<double>(t.variance_y)),
                    f64::vec2(1, 1));
                sum += over_base(f64::widen_lobe(lobe, v.x, v.y), n, h);
            }
            EXPECT_NEAR(sum / static_cast<double>(level.texels.size()) / over_base(all, mean, h), 1,
                        bound)
                << level.width << " " << h.z;
        }
    }
}

}  // namespace
}  // namespace burnish::test
