// The reflection models against closed forms, quadrature and the properties that they have or lack.
#include <gtest/gtest.h>

#include <random>

#include "models/he.hpp"
#include "models/projected_area.hpp"
#include "oracle/oracle.hpp"
#include "shading/brdf_cases.hpp"
#include "shading/chi_square.hpp"

namespace burnish::test {
namespace {

double worst_reciprocity_error(const BrdfCase& c) {
    std::mt19937 generator(23);
    std::uniform_real_distribution<double> uniform(0, 1);
    double worst = 0;
    for (int i = 0; i < 2000; ++i) {
        const vec3 wi = direction(std::acos(uniform(generator)), 2 * kPi * uniform(generator));
        const vec3 wo = direction(std::acos(uniform(generator)), 2 * kPi * uniform(generator));
        const double there = c.f(wi, wo), back = c.f(wo, wi);
        if (there + back > 1e-200) {
            worst = std::max(worst, std::abs(there - back) / std::max(there, back));
        }
    }
    return worst;
}

TEST(BrdfReciprocity, HoldsForEveryModelButPhong) {
    for (const BrdfCase& c : brdf_cases()) {
        if (c.model->name == "phong") {
            EXPECT_GT(worst_reciprocity_error(c), 0.5);
        } else {
            EXPECT_LT(worst_reciprocity_error(c), 1e-11) << label(c);
        }
    }
}

// Each against its formula on one pair of directions worked out apart: h = (3, 4, 12)/13, in whose
// plane of incidence nothing else is special.
TEST(BrdfClosedForms, AtOnePair) {
    const vec3 h{3.0 / 13, 4.0 / 13, 12.0 / 13};
    const vec3 wi = at_deg(35, 80);
    const double ih = wi.x * h.x + wi.y * h.y + wi.z * h.z;
    const vec3 wo{2 * ih * h.x - wi.x, 2 * ih * h.y - wi.y, 2 * ih * h.z - wi.z};
    ASSERT_GT(wo.z, 0.3);
    const auto value = [&](std::string_view name, std::array<double, 5> p) {
        return model_named(name).value_f64(p, wi, wo);
    };
    const auto expect = [](double found, double wanted) {
        EXPECT_NEAR(found, wanted, 1e-12 * wanted);
    };
    const double slopes = (9 / 0.09 + 16 / 0.25) / 144, round = 25.0 / 144 / 0.16;
    const double ward = 0.7 * std::exp(-slopes) / (4 * kPi * 0.3 * 0.5);
    expect(value("ward", {0.7, 0.3, 0.5}), ward / std::sqrt(wi.z * wo.z));
    expect(value("ward-duer", {0.7, 0.3, 0.5}), ward / (wi.z * wo.z));
    const double g = std::min({1.0, 2 * h.z * wo.z / ih, 2 * h.z * wi.z / ih});
    const double D = std::exp(-round) / (kPi * 0.16 * std::pow(12.0 / 13, 4));
    const double F = 0.2 + 0.8 * std::pow(1 - ih, 5);
    expect(value("cook-torrance", {0.7, 0.4, 0.2}), 0.7 * F * D * g / (4 * wi.z * wo.z));
    const double mirror = -wi.x * wo.x - wi.y * wo.y + wi.z * wo.z;
    expect(value("phong", {0.7, 12}), 0.7 * std::pow(mirror, 12) / wi.z);
    const double bracket = -1.1 * wi.x * wo.x - 0.9 * wi.y * wo.y + 0.8 * wi.z * wo.z;
    expect(value("lafortune", {0.7, -1.1, -0.9, 0.8, 7}), 0.7 * std::pow(bracket, 7));
    const auto through = [](double c) { return 1 - std::pow(1 - c / 2, 5); };
    expect(value("ashikhmin-shirley-diffuse", {0.6, 0.3}),
           28 * 0.6 / (23 * kPi) * 0.7 * through(wi.z) * through(wo.z));
}

// Measured by an independent script at azimuth 20: docs/theory/papers.md.
TEST(BrdfFurnace, WardAndItsCorrections) {
    const auto at = [](std::string_view name, double theta) {
        return albedo({&model_named(name), {1, 0.15, 0.4}}, at_deg(theta, 20), 1 << 17);
    };
    EXPECT_NEAR(at("ward", 0), 0.80, 0.01);
    EXPECT_NEAR(at("ward", 85), 0.16, 0.01);
    EXPECT_NEAR(at("ward-duer", 0), 0.86, 0.01);
    EXPECT_NEAR(at("ward-duer", 85), 1.02, 0.01);
    EXPECT_NEAR(at("ward-gmd", 0), 0.91, 0.01);
    EXPECT_NEAR(at("ward-gmd", 85), 0.79, 0.01);
}

// Constant light leaves the diffuse term as Rd (1 - Rs) (1 - (1 - cos/2)^5).
TEST(BrdfFurnace, CoupledDiffuseHasItsClosedAlbedo) {
    const BrdfCase c{&model_named("ashikhmin-shirley-diffuse"), {0.8, 0.1}};
    for (const double theta : {0.0, 40.0, 80.0}) {
        const double wanted = 0.72 * (1 - std::pow(1 - std::cos(theta * kPi / 180) / 2, 5));
        EXPECT_NEAR(albedo(c, at_deg(theta, 0)), wanted, 1e-4);
    }
}

TEST(BrdfSamplers, FollowTheirDensities) {
    const std::vector<BrdfCase> cases = brdf_cases();
    const double tests = 2 * static_cast<double>(cases.size());
    unsigned seed = 40;
    for (const BrdfCase& c : cases) {
        for (const vec3& wo : {at_deg(30, 50), at_deg(70, 200)}) {
            double integral = 0;
            const double p_value =
                sampler_p_value([&](vec3 wi) { return c.density(wi, wo); },
                                [&](double a, double b, double s) {
                                    double density = 0;
                                    const vec3 wi = c.sample(wo, {a, b, s}, density);
                                    return density > 0 ? wi : vec3{0, 0, 0};
                                },
                                Axes(vec3{-wo.x, -wo.y, wo.z}), ++seed, integral);
            EXPECT_GT(p_value, 0.01 / tests) << label(c);
            EXPECT_LT(integral, 1.005) << label(c);
            EXPECT_GT(integral, 0.9) << label(c);  // what is thrown away below the horizon
        }
    }
}

TEST(BrdfSamplers, ReportTheDensityOfTheSample) {
    std::mt19937 generator(29);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (const BrdfCase& c : brdf_cases()) {
        for (int i = 0; i < 500; ++i) {
            const vec3 wo = direction(1.5 * uniform(generator), 6.28 * uniform(generator));
            double density = 0;
            const std::array<double, 3> xi{uniform(generator), uniform(generator),
                                           uniform(generator)};
            const vec3 wi = c.sample(wo, xi, density);
            EXPECT_NEAR(f64::dot(wi, wi), 1, 1e-12) << label(c);
            if (density == 0) {
                continue;
            }
            EXPECT_NEAR(c.density(wi, wo) / density, 1, 1e-6) << label(c);
        }
    }
}

// The exponent 1e6 in single precision: the lobe's core must survive.
TEST(BrdfSinglePrecision, NarrowLobesKeepTheirCore) {
    const auto both = [](std::string_view name, std::array<double, 5> p, vec3 wi, vec3 wo) {
        std::array<float, 5> q{};
        for (std::size_t i = 0; i < 5; ++i) {
            q[i] = static_cast<float>(p[i]);
        }
        const auto single = [](vec3 v) {
            return f32::normalize(f32::vec3(static_cast<float>(v.x), static_cast<float>(v.y),
                                            static_cast<float>(v.z)));
        };
        const BrdfModel& model = model_named(name);
        return static_cast<double>(model.value_f32(q, single(wi), single(wo))) /
               model.value_f64(p, wi, wo);
    };
    for (const double off : {0.0, 0.02, 0.05, 0.1}) {  // degrees from the mirror direction
        const vec3 wi = at_deg(40, 20), wo = at_deg(40 + off, 200);
        EXPECT_NEAR(both("phong", {1, 1e6}, wi, wo), 1, 2e-3) << off;
        EXPECT_NEAR(both("ward", {1, 0.002, 0.002}, wi, wo), 1, 2e-3) << off;
        EXPECT_NEAR(both("cook-torrance", {1, 0.002, 1}, wi, wo), 1, 2e-3) << off;
        EXPECT_NEAR(both("ashikhmin-premoze-shirley", {1e6, 1e6, 1}, wi, wo), 1, 2e-3) << off;
    }
}

// ---- he -----------------------------------------------------------------------------------------

// docs/theory/papers.md: terms that leave less than 1e-6.
TEST(He, SeriesTakesTheTermsItShould) {
    const std::pair<double, int> wanted[] = {{1, 8}, {5, 18}, {20, 44}, {60, 99}};
    for (const auto& [g, terms] : wanted) {
        EXPECT_NEAR(he_series(g, 0, 1e-6).last, terms, 1) << g;
    }
}

double plain_series(double g, double x, int terms) {
    double sum = 0;
    for (int m = 1; m <= terms; ++m) {
        sum += std::exp(m * std::log(g) - g - std::lgamma(m + 1.0) - std::log(m) - x / m);
    }
    return sum;
}

TEST(He, SeriesIsTheSumOfItsTerms) {
    for (const double g : {1e-6, 0.3, 7.0, 150.0, 3900.0}) {
        for (const double x : {0.0, 2.0, 400.0, 1e5}) {
            const double wanted = plain_series(g, x, 20000);
            EXPECT_NEAR(he_series(g, x, kHeRemainder).sum, wanted, 1e-10 * wanted + 1e-300)
                << g << " " << x;
        }
    }
}

// Very rough: a normal distribution of slopes, m = 2 sigma/tau, seen along the normal without
// shadowing. D falls as 1/(4 pi m^2) exp(-tan^2/m^2) cos^-4-like; at the peak it is exact to 1/g.
TEST(He, RoughLimitIsBeckmannsPeak) {
    const HeSurface surface{4, 40};
    const double m = 2 * surface.sigma / surface.tau;
    EXPECT_NEAR(he_value(surface, {0, 0, 1}, {0, 0, 1}) * 4 * kPi * m * m, 1, 2e-3);
}

TEST(He, SmoothSurfacesScatterNothing) {
    EXPECT_EQ(he_value({0, 3}, at_deg(30, 0), at_deg(20, 10)), 0.0);
    EXPECT_LT(he_value({1e-8, 3}, at_deg(30, 0), at_deg(20, 10)), 1e-10);
}

// ---- ashikhmin-premoze-shirley ------------------------------------------------------------------

// Against double-exponential quadrature of its definition (tests/oracle), as k_z / G1.
TEST(ProjectedArea, IsItsIntegral) {
    for (const auto& [e_x, e_y] : {std::pair{0.0, 3.0}, {1.0, 40.0}, {200.0, 10.0}, {900.0, 0.0}}) {
        for (const vec3& k : {at_deg(45, 10), at_deg(75, 80), at_deg(89, 40)}) {
            const auto masking =
                oracle::smith_G1_exact("ashikhmin-shirley", e_x, e_y, {k.x, k.y, k.z});
            const double wanted = k.z / static_cast<double>(masking);
            EXPECT_NEAR(projected_area(e_x, e_y, k), wanted, 3e-7 * wanted) << e_x << " " << e_y;
        }
    }
}

// A uniform hemisphere of facets: (1 + k_z)/2.
TEST(ProjectedArea, OfAUniformHemisphereIsClosed) {
    for (const double theta : {0.0, 30.0, 80.0, 89.99, 90.0}) {
        const vec3 k = at_deg(theta, 33);
        EXPECT_NEAR(projected_area(0, 0, k), (1 + k.z) / 2, 1e-7);
    }
}

TEST(ProjectedArea, TableKeepsItsStatedErrorUpToTheLimits) {
    std::mt19937 generator(31);
    std::uniform_real_distribution<double> uniform(0, 1);
    double worst = 0;
    for (const double e_x : {0.0, 1.0, 40.0, 1e4, 1e6}) {
        for (const double e_y : {0.0, 3.0, 200.0, 1e6}) {
            ProjectedAreaTable table(e_x, e_y);
            for (int i = 0; i < 300; ++i) {
                // Even in the directions stretched with the lobe: most of them graze.
                const double theta = kPi / 2 * std::sqrt(uniform(generator));
                const double psi = 2 * kPi * uniform(generator);
                const vec3 k = f64::normalize(vec3(
                    std::sin(theta) * std::cos(psi) * std::sqrt((e_x + 2) / 2),
                    std::sin(theta) * std::sin(psi) * std::sqrt((e_y + 2) / 2), std::cos(theta)));
                const double wanted = projected_area(e_x, e_y, k);
                worst = std::max(worst, std::abs(table.at(k) - wanted) / wanted);
            }
        }
    }
    EXPECT_LT(worst, 5e-6);
    RecordProperty("worst", std::to_string(worst));
}

// Tables come and go; what they answer does not depend on who asked before.
TEST(ProjectedArea, CacheAnswersTheSameInAnyOrder) {
    const vec3 k = at_deg(83, 20);
    const double first = projected_area_cached(200, 10, k);
    for (int i = 0; i < 40; ++i) {
        projected_area_cached(i, 2 * i, at_deg(70 + i / 3.0, i));
    }
    EXPECT_EQ(projected_area_cached(200, 10, k), first);
}

}  // namespace
}  // namespace burnish::test
