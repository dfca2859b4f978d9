// phong and lafortune under a perturbed normal: against their formulas in the rotated frame, worked
// out here, and against quadrature.
#include <gtest/gtest.h>

#include <random>

#include "brdf_cases.hpp"
#include "chi_square.hpp"

namespace burnish::test {
namespace {

using f64::CosineLobe;
using f64::Perturbation;

static_assert(f64::kBrdfPhong == static_cast<int>(Brdf::phong));
static_assert(f64::kBrdfLafortune == static_cast<int>(Brdf::lafortune));

const vec3 kTilted = direction(40 * kPi / 180, 0.9);
constexpr int kRotations[] = {f64::kMethodGramSchmidt, f64::kMethodRotateExact,
                              f64::kMethodRotateArc, f64::kMethodFollowGrain};
const vec3 kC{-1.1, -0.7, 0.9};

CosineLobe phong(double n, double ks = -1) {
    return f64::cosine_lobe_make(f64::kBrdfPhong, ks, {0, 0, 0}, n);
}
CosineLobe lafortune(vec3 c, double n, double ks = -1) {
    return f64::cosine_lobe_make(f64::kBrdfLafortune, ks, c, n);
}
Perturbation perturbed(int method, vec3 n) {
    return f64::perturb_make(method, n, true, false);
}

struct Directions {
    std::mt19937 generator{41};
    std::uniform_real_distribution<double> uniform{0, 1};
    vec3 next(double most = 1.5) {
        return direction(most * uniform(generator), 2 * kPi * uniform(generator));
    }
};

// phong_eval(R^T wi, R^T wo), lafortune_eval likewise.
TEST(CosineLobe, RotationsTurnTheWholeModel) {
    Directions random;
    for (const int method : kRotations) {
        for (int i = 0; i < 2000; ++i) {
            const Perturbation p = perturbed(method, random.next(1.2));
            const vec3 wi = random.next(), wo = random.next();
            const vec3 i_local = f64::frame_to_local(p.frame, wi);
            const vec3 o_local = f64::frame_to_local(p.frame, wo);
            const double a = f64::phong_eval(0.7, 12, i_local, o_local);
            EXPECT_NEAR(f64::cosine_lobe_eval(phong(12, 0.7), p, wi, wo), a, 1e-10 * a + 1e-25);
            const double b = f64::lafortune_eval(0.7, kC, 7, i_local, o_local);
            EXPECT_NEAR(f64::cosine_lobe_eval(lafortune(kC, 7, 0.7), p, wi, wo), b,
                        1e-10 * b + 1e-25);
        }
    }
}

// docs/theory/papers.md, literally: (w_x, w_y, n~.w) for normal-map, K12 Eq 11 corrected for
// rotate-approx, the mirror direction about n~ for phong in both.
TEST(CosineLobe, OtherMethodsAreAsWritten) {
    Directions random;
    for (int i = 0; i < 2000; ++i) {
        const vec3 n = random.next(1.2), wi = random.next(), wo = random.next();
        const double ni = f64::dot(n, wi), no = f64::dot(n, wo);
        if (ni <= 0 || no <= 0) continue;
        const auto power = [](double base, double e) { return base > 0 ? std::pow(base, e) : 0; };
        const auto value = [&](const CosineLobe& lobe, int method, vec3 normal) {
            return f64::cosine_lobe_eval(lobe, perturbed(method, normal), wi, wo);
        };
        const double mirror = 2 * ni * no - f64::dot(wi, wo);
        const double p = 0.7 * power(mirror, 12) / ni;
        for (const int method : {f64::kMethodNormalMap, f64::kMethodRotateApprox})
            EXPECT_NEAR(value(phong(12, 0.7), method, n), p, 1e-9 * p + 1e-25);
        const double shipped =
            0.7 * power(kC.x * wi.x * wo.x + kC.y * wi.y * wo.y + kC.z * ni * no, 7);
        EXPECT_NEAR(value(lafortune(kC, 7, 0.7), f64::kMethodNormalMap, n), shipped,
                    1e-9 * shipped + 1e-20);
        const auto approx = [&](vec3 w) {
            return vec3{n.z * w.x - n.x * w.z,
                        -n.x * n.y * w.x + (1 - n.y * n.y) * w.y - n.y * n.z * w.z, f64::dot(n, w)};
        };
        const double k12 = 0.7 * power(f64::dot(kC * approx(wi), approx(wo)), 7);
        EXPECT_NEAR(value(lafortune(kC, 7, 0.7), f64::kMethodRotateApprox, n), k12,
                    1e-9 * k12 + 1e-20);
        const double flat = 0.7 * power(f64::dot(kC * wi, wo), 7);
        EXPECT_NEAR(value(lafortune(kC, 7, 0.7), f64::kMethodNone, n), flat, 1e-9 * flat + 1e-20);
    }
}

TEST(CosineLobe, LafortuneStaysReciprocalWhateverTheMethod) {
    Directions random;
    for (int method = 0; method < f64::kMethodDeformLinear; ++method) {
        for (int i = 0; i < 1000; ++i) {
            const Perturbation p = perturbed(method, random.next(1.2));
            const vec3 wi = random.next(), wo = random.next();
            const double there = f64::cosine_lobe_eval(lafortune(kC, 20), p, wi, wo);
            EXPECT_NEAR(f64::cosine_lobe_eval(lafortune(kC, 20), p, wo, wi), there,
                        1e-10 * there + 1e-25);
        }
    }
}

// Chi-square under every method that draws the models, at the 1 % level of the whole family.
TEST(CosineLobe, SamplesFollowTheirDensities) {
    const CosineLobe lobes[] = {phong(40), phong(2), lafortune(kC, 30),
                                lafortune({1, 0.4, 0.8}, 8)};
    constexpr double kTests = 4.0 * f64::kMethodDeformLinear;
    unsigned seed = 70;
    for (const CosineLobe& lobe : lobes) {
        for (int method = 0; method < f64::kMethodDeformLinear; ++method) {
            const Perturbation p = perturbed(method, kTilted);
            const vec3 wo = direction(1.1, 2.1);
            double integral = 0;
            const double p_value =
                sampler_p_value([&](vec3 wi) { return f64::cosine_lobe_pdf(lobe, p, wi, wo); },
                                [&](double a, double b, double) {
                                    double pdf = 0;
                                    return f64::cosine_lobe_sample(lobe, p, wo, {a, b}, pdf);
                                },
                                Axes(f64::cosine_lobe_direction(lobe, p, wo)), ++seed, integral);
            EXPECT_GT(p_value, 0.01 / kTests) << lobe.brdf << " " << method_names()[method];
            EXPECT_NEAR(integral, 1, 5e-3) << lobe.brdf << " " << method_names()[method];
        }
    }
}

// Int f cos g dwi by midpoints about the lobe's axis; g is 1 when left out.
double quadrature(
    const CosineLobe& lobe, const Perturbation& p, vec3 wo,
    const std::function<double(vec3)>& g = [](vec3) { return 1.0; }) {
    return integrate_cap(
        [&](vec3 wi) {
            return f64::cosine_lobe_eval(lobe, p, wi, wo) * std::max(f64::dot(p.n, wi), 0.0) *
                   g(wi);
        },
        f64::cosine_lobe_direction(lobe, p, wo), kPi / 2, 200, 400);
}

TEST(CosineLobe, UnitKsKeepsAllLightHeadOnAndGainsNone) {
    for (const double n : {0.0, 1.0, 5.0, 60.0, 3000.0}) {
        for (const CosineLobe& lobe : {phong(n), lafortune({-1, -1, 1}, n), lafortune(kC, n)}) {
            for (const double theta : {0.0, 20.0, 45.0, 70.0, 85.0, 89.0}) {
                const vec3 wo = at_deg(theta, 25);
                const double albedo = quadrature(lobe, perturbed(f64::kMethodNone, {0, 0, 1}), wo);
                EXPECT_LT(albedo, 1 + 1e-3) << n << " " << theta;
                if (theta == 0 && lobe.c.x == -lobe.c.z) {
                    EXPECT_NEAR(albedo, 1, 1e-3) << n;
                }
                // The closed form that look-ups of a blurred environment are scaled by, as good
                // as its text says.
                EXPECT_NEAR(
                    f64::cosine_lobe_albedo(lobe, perturbed(f64::kMethodNone, {0, 0, 1}), wo),
                    albedo,
                    n >= 5   ? 0.02
                    : n >= 1 ? 0.06
                             : 0.11)
                    << lobe.brdf << " " << n << " " << theta;
            }
        }
    }
}

// Where the one look-up of a blurred environment goes: within a fifth of
// the width of the lobe. The axis itself is off by up to all of it.
TEST(CosineLobe, MeanDirectionIsThatOfTheLight) {
    for (const double n : {1.0, 5.0, 60.0, 3000.0}) {
        const double width = f64::alpha_from_cosine_exponent(n) * 2;  // of directions, radians
        for (const CosineLobe& lobe : {phong(n), lafortune({-1, -1, 1}, n), lafortune(kC, n)}) {
            for (const double theta : {0.0, 20.0, 45.0, 70.0, 85.0}) {
                const Perturbation p = perturbed(f64::kMethodGramSchmidt, kTilted);
                const vec3 wo = f64::frame_to_outer(p.frame, at_deg(theta, 25));
                // Off the mirror direction nothing is left of a high power.
                if (quadrature(lobe, p, wo) < 1e-12) continue;
                const vec3 mean =
                    f64::normalize(vec3{quadrature(lobe, p, wo, [](vec3 wi) { return wi.x; }),
                                        quadrature(lobe, p, wo, [](vec3 wi) { return wi.y; }),
                                        quadrature(lobe, p, wo, [](vec3 wi) { return wi.z; })});
                const vec3 found = f64::cosine_lobe_mean(lobe, p, wo);
                EXPECT_NEAR(f64::length(found), 1, 1e-12);
                EXPECT_LT(f64::length(found - mean), 0.2 * width)
                    << lobe.brdf << " " << n << " " << theta;
            }
        }
    }
}

TEST(CosineLobe, AlbedoTurnsWithTheNormal) {
    for (const int method : kRotations) {
        const Perturbation p = perturbed(method, kTilted);
        const vec3 wo = direction(0.8, 0.3);
        for (const CosineLobe& lobe : {phong(15), lafortune(kC, 15)})
            EXPECT_NEAR(f64::cosine_lobe_albedo(lobe, p, wo), quadrature(lobe, p, wo), 0.02);
    }
}

TEST(CosineLobe, ExponentAndAlphaSayTheSame) {
    for (const double n : {0.0, 0.5, 20.0, 1e5}) {
        const double alpha = f64::alpha_from_cosine_exponent(n);
        EXPECT_NEAR(f64::cosine_exponent_from_alpha(alpha, alpha), n, 1e-9 * (1 + n));
    }
    // Half way up, the reflection of a narrow Blinn lobe cos^e of half vectors is as wide.
    const double alpha = 0.05, e = 2 / (alpha * alpha) - 2;
    const double half_vector = std::acos(std::pow(0.5, 1 / e));
    const double n = f64::cosine_exponent_from_alpha(alpha, alpha);
    EXPECT_NEAR(std::acos(std::pow(0.5, 1 / n)) / (2 * half_vector), 1, 1e-3);
    EXPECT_EQ(f64::cosine_exponent_from_alpha(1.5, 1.5), 0);
}

// Powers that overflow single precision on the way, and lobes that do not.
TEST(CosineLobe, SinglePrecisionHoldsWhatDoubleDoes) {
    const f32::Perturbation p32 = f32::perturb_make(f32::kMethodNone, {0, 0, 1}, true, false);
    const Perturbation p64 = perturbed(f64::kMethodNone, {0, 0, 1});
    struct Row {
        double ks;
        vec3 c;
        double n;
    };
    for (const Row& r : {Row{1e-6, {-10, -10, 10}, 12}, Row{1, {-0.1, -0.1, 0.1}, 30},
                         Row{-1, {-10, -10, 10}, 5000}}) {
        const double wanted =
            f64::cosine_lobe_eval(lafortune(r.c, r.n, r.ks), p64, {0, 0, 1}, {0, 0, 1});
        const f32::vec3 c{static_cast<float>(r.c.x), static_cast<float>(r.c.y),
                          static_cast<float>(r.c.z)};
        const f32::CosineLobe lobe = f32::cosine_lobe_make(
            f32::kBrdfLafortune, static_cast<float>(r.ks), c, static_cast<float>(r.n));
        EXPECT_NEAR(f32::cosine_lobe_eval(lobe, p32, {0, 0, 1}, {0, 0, 1}) / wanted, 1, 1e-4);
    }
    const f32::CosineLobe beyond =
        f32::cosine_lobe_make(f32::kBrdfLafortune, 1e6f, {-10, -10, 10}, 1e5f);
    EXPECT_TRUE(std::isfinite(f32::cosine_lobe_eval(beyond, p32, {0, 0, 1}, {0, 0, 1})));
}

}  // namespace
}  // namespace burnish::test
