// Are the oracle's further reflectance models sane? Closed forms, other derivations, furnaces.
#include "further_brdfs.hpp"
#include "selfcheck.hpp"

namespace burnish::oracle {
namespace {

using Parameters = std::array<long double, 5>;

double as_d(long double v) {
    return static_cast<double>(v);
}

Vec3 mirrored(Vec3 i) {
    return {-i.x, -i.y, i.z};
}

long double hemispherical(const std::string& brdf, const Parameters& p, Vec3 i, int n_theta,
                          int n_phi) {
    const auto f = [&](Vec3 o) { return brdf_eval(brdf, p, i, o) * o.z; };
    return integrate_hemisphere(f, mirrored(i), n_theta, n_phi);
}

// ---------------------------------------------------------------- all of them

const std::vector<std::pair<std::string, Parameters>>& some_models() {
    static const std::vector<std::pair<std::string, Parameters>> models{
        {"ward", {0.7L, 0.15L, 0.4L, 0, 0}},
        {"ward-duer", {0.7L, 0.15L, 0.4L, 0, 0}},
        {"lafortune", {0.5L, -0.9L, -1, 0.8L, 7}},
        {"cook-torrance", {0.8L, 0.3L, 0.6L, 0, 0}},
        {"ashikhmin-premoze-shirley", {200, 10, 0.6L, 0, 0}},
        {"he", {0.4L, 3, 0.6L, 0, 0}},
        {"ashikhmin-shirley-diffuse", {0.7L, 0.2L, 0, 0, 0}}};
    return models;
}

TEST(OracleFurther, ReciprocalPositiveAndZeroBelow) {
    for (const auto& [brdf, p] : some_models()) {
        int alive = 0;
        for (const auto& [i, o] : random_pairs(21, 60)) {
            const long double f = brdf_eval(brdf, p, i, o);
            alive += f > 0 ? 1 : 0;
            EXPECT_LE(fabsl(f - brdf_eval(brdf, p, o, i)), 1e-15L * f) << brdf;
        }
        EXPECT_GT(alive, 30) << brdf;
        EXPECT_EQ(brdf_eval(brdf, p, tilted(95, 0), tilted(30, 0)), 0) << brdf;
        EXPECT_EQ(brdf_eval(brdf, p, tilted(30, 0), tilted(90.01L, 0)), 0) << brdf;
    }
}

TEST(OracleFurther, PhongIsNeitherReciprocalNorBounded) {
    const Parameters p{0.5L, 30, 0, 0, 0};
    const long double there = brdf_eval("phong", p, tilted(70, 10), tilted(60, 185));
    const long double back = brdf_eval("phong", p, tilted(60, 185), tilted(70, 10));
    expect_close(there / back, tilted(60, 0).z / tilted(70, 0).z, 1e-15L);
    EXPECT_GT(brdf_eval("phong", p, tilted(89.999L, 0), tilted(89.999L, 180)), 1e4L);
}

TEST(OracleFurther, FresnelIsSchlicks) {
    const Vec3 i = tilted(70, 20);
    const Vec3 o = tilted(50, 190);
    const long double m = 1 - dot(i, normalize(i + o));
    for (const std::string brdf : {"cook-torrance", "ashikhmin-premoze-shirley", "he"}) {
        for (auto [name, p] : some_models()) {
            if (name != brdf) continue;
            p[2] = 1;
            const long double white = brdf_eval(brdf, p, i, o);
            p[2] = 0.3L;
            expect_close(brdf_eval(brdf, p, i, o) / white, 0.3L + 0.7L * m * m * m * m * m, 1e-16L);
        }
    }
}

// ---------------------------------------------------------------- cosine powers

// From straight above both are cosine powers about n, whose integral is elementary.
TEST(OracleFurther, CosinePowersFromAbove) {
    for (const long double e : {1.0L, 7.5L, 80.0L}) {
        expect_close(hemispherical("phong", {0.6L, e, 0, 0, 0}, kUp, 60, 8),
                     0.6L * 2 * kPi / (e + 2), 1e-12L);
        expect_close(hemispherical("lafortune", {0.6L, -1, 0.5L, 0.9L, e}, kUp, 60, 8),
                     0.6L * powl(0.9L, e) * 2 * kPi / (e + 2), 1e-12L);
    }
    EXPECT_EQ(brdf_eval("phong", {1, 0, 0, 0, 0}, tilted(80, 0), tilted(80, 0)), 0);
    expect_close(brdf_eval("phong", {1, 0, 0, 0, 0}, tilted(60, 0), tilted(60, 180)), 2, 1e-17L);
}

// With C = (-1, -1, 1) the bracket is o.r.
TEST(OracleFurther, LafortuneHoldsPhong) {
    for (const auto& [i, o] : random_pairs(22, 50)) {
        const long double phong = brdf_eval("phong", {0.4L, 9, 0, 0, 0}, i, o);
        const long double same = brdf_eval("lafortune", {0.4L, -1, -1, 1, 9}, i, o) / i.z;
        EXPECT_LE(fabsl(phong - same), 1e-16L * phong);
    }
}

// The diffuse term's constant makes the white albedo from i exactly 1 - (1 - i.z/2)^5.
TEST(OracleFurther, AshikhminShirleyDiffuseAlbedo) {
    for (const long double tilt : {0.0L, 50.0L, 88.0L}) {
        const Vec3 i = tilted(tilt, 0);
        const auto f = [&](Vec3 o) { return ashikhmin_shirley_diffuse(0.7L, 0.2L, i, o) * o.z; };
        expect_close(integrate_hemisphere(f, kUp, 20, 1), 0.7L * 0.8L * (1 - powl(1 - i.z / 2, 5)),
                     1e-15L);
    }
}

// ---------------------------------------------------------------- Ward

// Ward's own way to draw h: tan^2 = -ln u stretched by the alphas, pdf of o
// exp(..) / (4 pi ax ay (h.i) hz^3); the albedo is the mean of f o.z / pdf. `power` as in the
// model.
long double ward_albedo(long double ks, long double ax, long double ay, long double power, Vec3 i) {
    constexpr int kRings = 400;
    constexpr int kSpokes = 240;
    long double sum = 0;
    for (int a = 0; a < kRings; ++a) {
        const long double r = sqrtl(-logl((a + 0.5L) / kRings));
        for (int b = 0; b < kSpokes; ++b) {
            const long double phi = 2 * kPi * (b + 0.5L) / kSpokes;
            const Vec3 h = normalize({ax * r * cosl(phi), ay * r * sinl(phi), 1});
            const Vec3 o = 2 * dot(h, i) * h - i;
            if (o.z <= 0 || dot(h, i) <= 0) continue;
            sum += dot(h, i) * h.z * h.z * h.z * o.z / powl(i.z * o.z, power);
        }
    }
    return ks * sum / (kRings * kSpokes);
}

TEST(OracleFurther, WardAlbedoTwoWays) {
    for (const long double tilt : {0.0L, 40.0L, 70.0L}) {
        const Vec3 i = tilted(tilt, 25);
        const Parameters p{0.9L, 0.15L, 0.4L, 0, 0};
        expect_close(hemispherical("ward", p, i, 80, 120), ward_albedo(0.9L, 0.15L, 0.4L, 0.5L, i),
                     2e-3L);
        expect_close(hemispherical("ward-duer", p, i, 80, 120),
                     ward_albedo(0.9L, 0.15L, 0.4L, 1, i), 2e-3L);
    }
}

// docs/theory/papers.md: Ward 1992 loses energy, .80 to .16 from 0 to 85 degrees (alpha .15, .4), and
// Duer's form gains, .86 to 1.02: both at an azimuth of 20 degrees. Neither is bounded: as i.z goes
// to 0 they grow as i.z^(-1/2) and 1/i.z, Ward's beyond 89 degrees only.
TEST(OracleFurther, WardFurnace) {
    EXPECT_NEAR(as_d(ward_albedo(1, 0.15L, 0.4L, 0.5L, kUp)), 0.80, 0.005);
    EXPECT_NEAR(as_d(ward_albedo(1, 0.15L, 0.4L, 1, kUp)), 0.86, 0.005);
    EXPECT_NEAR(as_d(ward_albedo(1, 0.15L, 0.4L, 0.5L, tilted(85, 20))), 0.16, 0.01);
    EXPECT_NEAR(as_d(ward_albedo(1, 0.15L, 0.4L, 1, tilted(85, 20))), 1.02, 0.01);
    for (const long double power : {0.5L, 1.0L}) {
        const long double near_horizon = ward_albedo(1, 0.15L, 0.4L, power, tilted(89.99L, 90));
        const long double nearer = ward_albedo(1, 0.15L, 0.4L, power, tilted(89.9999L, 90));
        expect_close(nearer / near_horizon, powl(100, power), 0.02L);
        EXPECT_GT(near_horizon, 1);
    }
}

// ---------------------------------------------------------------- Cook & Torrance

TEST(OracleFurther, CookTorranceAgainstTheBeckmannMicrofacets) {
    for (const auto& [i, o] : random_pairs(23, 200)) {
        const Vec3 h = normalize(i + o);
        const long double smith = 1 / (1 / smith_G1_closed("beckmann", 0.3L, 0.3L, i) +
                                       1 / smith_G1_closed("beckmann", 0.3L, 0.3L, o) - 1);
        const long double cavity = std::min(1.0L, 2 * h.z * std::min(i.z, o.z) / dot(i, h));
        const long double f =
            brdf_eval("beckmann", {0.3L, 0.3L, 0.6L, 0, 0}, i, o) / smith * cavity;
        EXPECT_LE(fabsl(brdf_eval("cook-torrance", {1, 0.3L, 0.6L, 0, 0}, i, o) - f), 1e-15L * f);
    }
}

TEST(OracleFurther, CookTorranceFurnace) {
    for (const long double m : {0.2L, 0.6L}) {
        for (const long double tilt : {0.0L, 40.0L, 75.0L}) {
            EXPECT_LT(hemispherical("cook-torrance", {1, m, 1, 0, 0}, tilted(tilt, 0), 80, 120),
                      1.0005L);
        }
    }
    EXPECT_GT(hemispherical("cook-torrance", {1, 0.2L, 1, 0, 0}, kUp, 80, 8), 0.99L);
}

// ---------------------------------------------------------------- Ashikhmin, Premoze & Shirley

const std::vector<std::pair<long double, long double>> kExponents{
    {0, 0}, {1, 1}, {10, 10}, {200, 10}, {0, 10000}, {3.3L, 0.2L}, {10000, 10000}};

TEST(OracleFurther, IncompleteBetaAgainstElementaryIntegrals) {
    for (const long double t : {0.001L, 0.3L, 0.9L, 1.4L, kPi / 2}) {
        const long double s = sinl(t);
        const long double c = t < 1.5L ? cosl(t) : 0;
        EXPECT_NEAR(as_d(sin2_cos_power_integral(0, s, c)), as_d((t - s * c) / 2), 1e-17);
        expect_close(sin2_cos_power_integral(1, s, c), s * s * s / 3, 1e-16L);
        expect_close(sin2_cos_power_integral(3, s, c), s * s * s / 3 - powl(s, 5) / 5, 1e-16L);
    }
}

TEST(OracleFurther, ApsShadowingAtTheNormalIsOne) {
    for (const auto& [e_x, e_y] : kExponents) expect_close(aps_g(e_x, e_y, kUp), 1, 1e-14L);
}

// D = 1/pi: the lune between two horizons at the angle theta has g = (1 + cos theta) / 2.
TEST(OracleFurther, ApsShadowingOfTheUniformLobe) {
    for (const long double tilt : {1.0L, 45.0L, 89.9L, 89.9999999L}) {
        const Vec3 k = tilted(tilt, 33);
        expect_close(aps_g(0, 0, k), (1 + k.z) / 2, 1e-14L);
    }
}

// Two quadratures of different kind and coordinates: this one along azimuths, that one over a lune.
TEST(OracleFurther, ApsShadowingTwoWays) {
    for (const auto& [e_x, e_y] : kExponents) {
        for (const Vec3 k : {tilted(40, 20), tilted(80, 0), tilted(89.9L, 90), tilted(89.9L, 50)}) {
            expect_close(k.z / aps_g(e_x, e_y, k), smith_G1_exact("ashikhmin-shirley", e_x, e_y, k),
                         1e-10L);
        }
    }
}

// A narrow lobe is Beckmann's with alpha^2 = 2/e.
TEST(OracleFurther, ApsShadowingOfANarrowLobeIsSmiths) {
    const long double alpha = sqrtl(2 / 10001.0L);
    for (const long double tilt : {70.0L, 88.0L, 89.9L}) {
        const Vec3 k = tilted(tilt, 0);
        expect_close(k.z / aps_g(10000, 10000, k), smith_G1_closed("beckmann", alpha, alpha, k),
                     2e-4L);
    }
}

TEST(OracleFurther, ApsFurnace) {
    for (const long double tilt : {0.0L, 45.0L, 80.0L}) {
        const Parameters p{10, 3, 1, 0, 0};
        EXPECT_LT(hemispherical("ashikhmin-premoze-shirley", p, tilted(tilt, 30), 12, 16), 1.001L);
    }
}

}  // namespace
}  // namespace burnish::oracle
