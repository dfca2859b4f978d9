// Is the oracle's He-Torrance-Sillion-Greenberg model sane? Its pieces against other derivations
// and the whole against its limits: gentle slopes, and roughness of many wavelengths.
#include "further_brdfs.hpp"
#include "selfcheck.hpp"

namespace burnish::oracle {
namespace {

using Parameters = std::array<long double, 5>;

double as_d(long double v) {
    return static_cast<double>(v);
}

// Term by term from m = 1, each from its own logarithm.
long double brute_series(long double g, long double b) {
    long double sum = 0;
    for (int m = 1; m < 40000; ++m) {
        sum += expl(m * logl(g) - g - lgammal(m + 1.0L) - logl(m) - b / m);
    }
    return sum;
}

TEST(OracleHe, SeriesAgainstBruteForce) {
    for (const long double g : {1e-4L, 0.3L, 1.0L, 5.0L, 60.0L, 900.0L, 4000.0L}) {
        for (const long double b : {0.0L, 0.2L, 30.0L, 1e4L, 1e6L}) {
            expect_close(he_log_series(g, b) / logl(brute_series(g, b)), 1, 1e-14L);
        }
    }
}

// Without the exponential the sum is e^-g Int_0^g (e^t - 1) / t dt = e^-g (Ei(g) - ln g - gamma).
TEST(OracleHe, SeriesInTheSpecularDirection) {
    for (const long double g : {0.5L, 4.0L, 40.0L, 400.0L}) {
        const long double closed =
            expl(-g) * (std::expint(g) - logl(g) - std::numbers::egamma_v<long double>);
        expect_close(expl(he_log_series(g, 0)), closed, 1e-15L);
    }
}

// docs/theory/papers.md: 8, 18, 44, 99 terms at g = 1, 5, 20, 60 for 1e-6.
TEST(OracleHe, TermsThatTheSeriesNeeds) {
    const auto partial = [](long double g, int terms) {
        long double sum = 0;
        for (int m = 1; m <= terms; ++m) {
            sum += expl(m * logl(g) - g - lgammal(m + 1.0L) - logl(m));
        }
        return 1 - sum / expl(he_log_series(g, 0));
    };
    const std::vector<std::pair<long double, int>> counts{{1, 8}, {5, 18}, {20, 44}, {60, 99}};
    for (const auto& [g, terms] : counts) {
        EXPECT_LT(partial(g, terms), 1e-6L) << as_d(g);
        EXPECT_GT(partial(g, terms - 3), 1e-6L) << as_d(g);
    }
}

// x exp(x^2/2) = c means x^2 = W(c^2), W of Lambert; W = w e^w inverted here by Halley's steps.
TEST(OracleHe, EffectiveRoughnessIsLambertsW) {
    for (const long double k_sum : {1e-6L, 0.1L, 2.0L, 57.0L, 1e6L, 2e9L}) {
        const long double c2 = k_sum * k_sum / (8 * kPi);
        long double w = logl(1 + c2);
        for (int step = 0; step < 60; ++step) {
            const long double e = expl(w);
            const long double f = w * e - c2;
            w -= f / (e * (w + 1) - (w + 2) * f / (2 * w + 2));
        }
        expect_close(he_z0_over_sigma(k_sum), sqrtl(w), 1e-15L);
    }
    EXPECT_EQ(he_z0_over_sigma(0), 0);
}

TEST(OracleHe, EffectiveRoughnessShrinksTowardsGrazing) {
    EXPECT_EQ(he_effective_sigma(0.4L, 2, kUp, kUp), 0.4L);
    long double before = 0.4L;
    for (const long double tilt : {60.0L, 80.0L, 89.0L, 89.999L}) {
        const long double now = he_effective_sigma(0.4L, 2, tilted(tilt, 0), tilted(tilt, 180));
        EXPECT_LT(now, before);
        before = now;
    }
    EXPECT_GT(before, 0.05L);
}

// Smith 1967 from its definition, for slopes q of density exp(-q^2 / 2w^2) / (w sqrt(2 pi)), with
// w = sqrt(2) sigma / tau: Lambda = Int_c^inf (q - c) p(q) dq / c, c = cot(theta), and the share of
// slopes that do not face away, Int_-inf^c p.
TEST(OracleHe, ShadowingFromItsDefinition) {
    const long double sigma = 0.5L;
    const long double tau = 2;
    const long double w = sqrtl(2) * sigma / tau;
    for (const long double tilt : {20.0L, 60.0L, 80.0L, 89.0L}) {
        const Vec3 k = tilted(tilt, 12);
        const long double c = k.z / sqrtl(1 - k.z * k.z);
        long double above = 0;
        long double beyond = 0;
        constexpr int kSteps = 20000;
        const long double step = 14 * w / kSteps;
        for (int j = 0; j < kSteps; ++j) {
            const long double q = c + (j + 0.5L) * step;
            const long double p = expl(-q * q / (2 * w * w)) / (w * sqrtl(2 * kPi)) * step;
            above += (q - c) * p;
            beyond += p;
        }
        expect_close(he_shadowing(he_slope_ratio(sigma, tau, k)), (1 - beyond) / (1 + above / c),
                     1e-7L);
    }
    EXPECT_EQ(he_shadowing(he_slope_ratio(sigma, tau, kUp)), 1);
}

// Eq 76 as printed, s and p from cross products, against (v.v / v_z)^2 which the model uses: k_i
// travels to the surface, k_o away from it.
TEST(OracleHe, GeometryTermSimplifies) {
    for (const auto& [i, o] : random_pairs(31, 200)) {
        const Vec3 k_i = -1 * i;
        const Vec3 s_i = normalize(cross(k_i, kUp));
        const Vec3 s_o = normalize(cross(o, kUp));
        const Vec3 p_i = cross(s_i, k_i);
        const Vec3 p_o = cross(s_o, o);
        const auto sum2 = [](long double a, long double b) { return a * a + b * b; };
        const Vec3 v = o - k_i;
        const long double c = length(cross(o, k_i));
        const long double printed = powl(dot(v, v) / v.z, 2) / powl(c, 4) *
                                    sum2(dot(s_o, k_i), dot(p_o, k_i)) *
                                    sum2(dot(s_i, o), dot(p_i, o));
        expect_close(printed, powl(dot(v, v) / v.z, 2), 1e-13L);
    }
}

// Gentle slopes (tau >> sigma, 1) neither shadow nor spread: the directional diffuse lobe holds
// what e^-g takes from the mirror direction, F (1 - e^-g).
TEST(OracleHe, GentleSlopesKeepTheEnergy) {
    constexpr long double kTau = 60;
    for (const long double sigma : {0.02L, 0.08L, 0.2L}) {
        for (const long double tilt : {0.0L, 50.0L}) {
            const Vec3 i = tilted(tilt, 0);
            const long double g = powl(4 * kPi * sigma * i.z, 2);
            // Over v_xy: dw = dx dy / o.z cancels the cosine.
            const long double reach = 8 * sqrtl(1 + g) / (kPi * kTau);
            constexpr int kNodes = 64;
            long double sum = 0;
            for (int a = 0; a < kNodes; ++a) {
                for (int b = 0; b < kNodes; ++b) {
                    const long double x = -i.x + reach * (2 * (a + 0.5L) / kNodes - 1);
                    const long double y = -i.y + reach * (2 * (b + 0.5L) / kNodes - 1);
                    const long double z2 = 1 - x * x - y * y;
                    if (z2 <= 0) continue;
                    sum += brdf_eval("he", {sigma, kTau, 1, 0, 0}, i, {x, y, sqrtl(z2)});
                }
            }
            sum *= powl(2 * reach / kNodes, 2);
            expect_close(sum, 1 - expl(-g), 2e-3L);
        }
    }
}

// Many wavelengths of roughness: geometric optics, the Beckmann microfacet model of
// alpha = 2 sigma / tau with He's own shadowing. The series is (1 + 1/g + ..) exp(-b/g) / g.
TEST(OracleHe, RoughLimitIsTheBeckmannMicrofacets) {
    const Parameters p{5, 40, 0.4L, 0, 0};
    const long double alpha = 2 * p[0] / p[1];
    for (const auto& [i, o] : std::vector<std::pair<Vec3, Vec3>>{{tilted(10, 0), tilted(25, 170)},
                                                                 {tilted(35, 40), tilted(45, 215)},
                                                                 {tilted(0, 0), tilted(20, 0)}}) {
        const long double shadowing = he_shadowing(he_slope_ratio(p[0], p[1], i)) *
                                      he_shadowing(he_slope_ratio(p[0], p[1], o));
        const Vec3 h = normalize(i + o);
        const long double d = mdf_eval("beckmann", alpha, alpha, "none", kUp, h).D;
        const long double expected = schlick(0.4L, dot(i, h)) * d * shadowing / (4 * i.z * o.z);
        expect_close(brdf_eval("he", p, i, o), expected, 5e-3L);
    }
}

TEST(OracleHe, SmoothSurfaceHasNoDiffuseLobe) {
    EXPECT_EQ(brdf_eval("he", {0, 3, 1, 0, 0}, tilted(30, 0), tilted(30, 180)), 0);
    const long double faint = brdf_eval("he", {1e-6L, 3, 1, 0, 0}, tilted(30, 0), tilted(30, 180));
    const long double fainter =
        brdf_eval("he", {1e-7L, 3, 1, 0, 0}, tilted(30, 0), tilted(30, 180));
    expect_close(faint / fainter, 100, 1e-9L);
}

}  // namespace
}  // namespace burnish::oracle
