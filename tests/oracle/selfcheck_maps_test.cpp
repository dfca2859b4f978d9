// Is the oracle itself sane? Normalisation, rotations and deformations, each a property that
// docs/theory/papers.md claims or a textbook knows in closed form.
#include "selfcheck.hpp"

namespace burnish::oracle {
namespace {

// ---------------------------------------------------------------- normalisation

// docs/theory/papers.md: K11 Eq 1 is normalised per solid angle, D_proj per projected area.
TEST(OracleSelf, AshikhminShirleyIsNormalizedBothWays) {
    const std::vector<std::pair<long double, long double>> exponents{
        {200, 10}, {0, 0}, {0, 10000}, {0.3L, 40}};
    for (const auto& [e_x, e_y] : exponents) {
        const Lobe l{"ashikhmin-shirley", e_x, e_y};
        const auto per_angle = [&](Vec3 h) { return value(l, "none", kUp, h).D; };
        const auto projected = [&](Vec3 h) { return h.z * value(l, "none", kUp, h).D_proj; };
        expect_close(integrate_lobe(l.mdf, e_x, e_y, kUp, per_angle), 1, 1e-13L);
        expect_close(integrate_lobe(l.mdf, e_x, e_y, kUp, projected), 1, 1e-13L);
    }
}

TEST(OracleSelf, OtherLobesAreNormalizedPerProjectedArea) {
    for (const std::string mdf : {"ward", "beckmann", "ggx"}) {
        for (const long double ax : {0.01L, 1.0L}) {
            for (const long double ay : {0.01L, 0.3L}) {
                const Lobe l{mdf, ax, ay};
                const auto f = [&](Vec3 h) { return h.z * value(l, "none", kUp, h).D_proj; };
                expect_close(integrate_lobe(mdf, ax, ay, kUp, f), 1, 1e-11L);
            }
        }
    }
}

// The lobe-shaped quadrature against the plain one, which knows nothing about lobes.
TEST(OracleSelf, TwoQuadraturesAgree) {
    for (const Lobe& l : {kBrushed, kBroad, kWard, kGgx}) {
        const auto f = [&](Vec3 h) { return h.z * value(l, "none", kUp, h).D_proj; };
        EXPECT_NEAR(static_cast<double>(integrate_hemisphere(f, kUp, 60, 128)), 1, 1e-9);
    }
    const auto one = [](Vec3) { return 1.0L; };
    expect_close(integrate_hemisphere(one, tilted(50, 20), 24, 4), 2 * kPi, 1e-16L);
}

// docs/theory/papers.md, the row on K12 Eq 3's missing prefactor.
TEST(OracleSelf, WardPeakOneIntegrals) {
    EXPECT_EQ(value(kWard, "none", kUp, kUp).D, 1);
    EXPECT_NEAR(static_cast<double>(ward_projected_integral(0.1L, 0.5L) / (kPi * 0.05L)), 0.9350,
                5e-5);
    EXPECT_NEAR(static_cast<double>(ward_projected_integral(1, 1) / kPi), 0.568, 5e-4);
    for (const long double a : {0.01L, 0.1L, 0.3L, 0.7L, 1.0L}) {
        // Isotropic: Int D dw = pi a^2 (1 - e^(-2/a^2)), and per projected area in closed form too.
        const Lobe l{"ward", a, a};
        const auto f = [&](Vec3 h) { return value(l, "none", kUp, h).D; };
        const long double rest = -expm1l(-2 / (a * a));
        expect_close(integrate_lobe("ward", a, a, kUp, f), kPi * a * a * rest, 1e-13L);
        const long double closed = kPi * a * a * (1 - a * a / 2 * rest);
        expect_close(ward_projected_integral(a, a), closed, 1e-17L);
    }
    // Small alphas: pi ax ay (1 - (ax^2 + ay^2) / 4), whatever their ratio.
    const long double small = kPi * 0.01L * 0.1L * (1 - (0.0001L + 0.01L) / 4);
    expect_close(ward_projected_integral(0.01L, 0.1L), small, 1e-17L);
    expect_close(ward_projected_integral(0.01L, 1), ward_projected_integral(1, 0.01L), 1e-17L);
}

// K12 Eq 3's 2 / (1 + h.n) against the exact exponent 1 / hz^2, at 30 degrees.
TEST(OracleSelf, WardApproximatesTheExactExponent) {
    const std::map<long double, double> expected{{0.5L, 1.30}, {0.3L, 2.1}, {0.1L, 690}};
    for (const auto& [a, ratio] : expected) {
        const Vec3 h = tilted(30, 70);
        const long double exact = expl(-(h.x * h.x + h.y * h.y) / (a * a * h.z * h.z));
        const long double got = value({"ward", a, a}, "none", kUp, h).D / exact;
        EXPECT_NEAR(static_cast<double>(got) / ratio, 1, 0.02);
    }
}

TEST(OracleSelf, UnperturbedNormalLeavesEveryLobeAlone) {
    for (const auto& [unused, h] : random_pairs(1, 40)) {
        for (const Lobe& l : {kBrushed, kBroad, kWard, kGgx, Lobe{"beckmann", 0.2L, 0.6L}}) {
            for (const std::string& method : method_names()) {
                const MdfValue a = value(l, method, kUp, h);
                const MdfValue b = value(l, "none", kUp, h);
                expect_close(a.D, b.D, 1e-15L);
                expect_close(a.D_conserving, b.D_proj, 1e-15L);
            }
        }
    }
}

// ---------------------------------------------------------------- rotations

// docs/theory/papers.md: corrected approximate matrix = diag(s, s, 1) R^T, s = sqrt(1 - n~y^2).
TEST(OracleSelf, ApproximateRotationIsAScaledExactOne) {
    for (const auto& [n, h] : random_pairs(2, 1000)) {
        const Vec3 exact = transformed("rotate-exact", n, h).v;
        const long double s = sqrtl(1 - n.y * n.y);
        const Vec3 approx = transformed("rotate-approx", n, h).v;
        expect_near(approx, {s * exact.x, s * exact.y, exact.z}, 1e-18L);
        // K12 Eq 11 written out, row 2 with -n~y n~z and row 3 = n~.h.
        expect_near(approx,
                    {n.z * h.x - n.x * h.z,
                     -n.x * n.y * h.x + (1 - n.y * n.y) * h.y - n.y * n.z * h.z, dot(n, h)},
                    1e-18L);
    }
}

TEST(OracleSelf, RotationsAreRotationsThatTakeTheNormalUp) {
    for (const auto& [n, h] : random_pairs(3, 200)) {
        for (const std::string method :
             {"gram-schmidt", "rotate-exact", "rotate-arc", "follow-grain"}) {
            const Vec3 x = transformed(method, n, {1, 0, 0}).v;
            const Vec3 y = transformed(method, n, {0, 1, 0}).v;
            const Vec3 z = transformed(method, n, {0, 0, 1}).v;
            expect_near(cross(x, y), z, 1e-18L);
            EXPECT_LT(fabsl(dot(x, y)), 1e-18L);
            EXPECT_LT(fabsl(length(z) - 1), 1e-18L);
            expect_near(transformed(method, n, n).v, kUp, 1e-18L);
        }
        expect_near(transformed("rotate-approx", n, n).v, kUp, 1e-18L);
    }
}

// Ashikhmin-Shirley: approximate = exact, not normalised and with phi from atan2.
TEST(OracleSelf, AshikhminShirleyDoesNotSeeTheApproximation) {
    for (const auto& [n, h] : random_pairs(4, 500)) {
        for (const Lobe& l : {kBrushed, kBroad, Lobe{"ashikhmin-shirley", 3000, 0}}) {
            const long double exact = value(l, "rotate-exact", n, h).D;
            const long double approx = value(l, "rotate-approx", n, h).D;
            EXPECT_LE(fabsl(approx - exact), 1e-12L * exact);  // 3000 times the rounding of z
        }
    }
}

// Ward: approximate = exact with alpha / s; exact again if the exponent is divided by 1 - n~y^2.
TEST(OracleSelf, WardSeesTheApproximationAsRougher) {
    for (const auto& [n, h] : random_pairs(5, 500)) {
        const long double s = sqrtl(1 - n.y * n.y);
        const long double approx = value(kWard, "rotate-approx", n, h).D;
        const Lobe rough{"ward", kWard.p0 / s, kWard.p1 / s};
        const long double rougher = value(rough, "rotate-exact", n, h).D;
        const long double exact = value(kWard, "rotate-exact", n, h).D;
        EXPECT_LE(fabsl(approx - rougher), 1e-15L * rougher);
        if (approx > 0) {
            EXPECT_LE(fabsl(powl(approx, 1 / (s * s)) - exact), 1e-14L * exact);
        }
    }
}

// Angle error of the approximation after normalising: at most asin((1 - s) / (1 + s)).
TEST(OracleSelf, ApproximationErrorInDegrees) {
    const std::map<long double, double> tilt_in_y{
        {10, 0.44}, {20, 1.78}, {30, 4.12}, {45, 9.88}, {60, 19.5}};
    const std::map<long double, double> tilt_in_between{
        {10, 0.22}, {20, 0.86}, {30, 1.91}, {45, 4.12}, {60, 6.72}};
    const auto most = [](Vec3 n) {
        long double worst = 0;
        for (long double theta = 0.5L; theta < 90; theta += 0.5L) {
            // theta is counted from n~, so that all of its hemisphere is seen.
            for (long double phi = 0; phi < 360; phi += 30) {
                const Vec3 v = tilted(theta, phi);
                const Vec3 x = transformed("rotate-exact", n, {1, 0, 0}).v;
                const Vec3 y = transformed("rotate-exact", n, {0, 1, 0}).v;
                const Vec3 z = transformed("rotate-exact", n, {0, 0, 1}).v;
                const Vec3 h{dot(x, v), dot(y, v), dot(z, v)};
                const Vec3 approx = normalize(transformed("rotate-approx", n, h).v);
                worst = std::max(worst, asinl(length(cross(approx, v))));
            }
        }
        return static_cast<double>(worst * 180 / kPi);
    };
    for (const auto& [tilt, degrees] : tilt_in_y) {
        EXPECT_NEAR(most(tilted(tilt, 90)), degrees, 0.01 * degrees);
        EXPECT_NEAR(most(tilted(tilt, 0)), 0, 1e-15);
    }
    for (const auto& [tilt, degrees] : tilt_in_between) {
        EXPECT_NEAR(most(tilted(tilt, 45)), degrees, 0.02 * degrees);
    }
}

// t = (hz + z) / (1 + nz), h~ = (hx - nx t, hy - ny t, z) is the shortest arc.
TEST(OracleSelf, ShortestArcHasAClosedForm) {
    for (const auto& [n, h] : random_pairs(6, 500)) {
        const long double z = dot(n, h);
        const long double t = (h.z + z) / (1 + n.z);
        expect_near(transformed("rotate-arc", n, h).v, {h.x - n.x * t, h.y - n.y * t, z}, 1e-18L);
    }
    const Vec3 nearly_up = normalize(Vec3{1e-12L, -2e-12L, 1});
    expect_near(transformed("rotate-arc", nearly_up, tilted(40, 10)).v, tilted(40, 10), 1e-11L);
}

// The frames differ by a twist about n~ of atan(n~x n~y / n~z); the shortest arc is halfway when
// |n~x| = |n~y|.
TEST(OracleSelf, TwistBetweenFrames) {
    const auto azimuth = [](const std::string& method, Vec3 n, Vec3 h) {
        const Vec3 v = transformed(method, n, h).v;
        return atan2l(v.y, v.x);
    };
    for (const auto& [n, h] : random_pairs(7, 200)) {
        const long double twist = azimuth("rotate-exact", n, h) - azimuth("gram-schmidt", n, h);
        const long double wrapped = remainderl(twist, 2 * kPi);
        EXPECT_LT(fabsl(fabsl(wrapped) - atanl(fabsl(n.x * n.y) / n.z)), 1e-16L);
    }
    const std::map<long double, double> expected{{30, 8.2}, {60, 36.9}};
    for (const auto& [tilt, degrees] : expected) {
        const Vec3 n = tilted(tilt, 45);
        const Vec3 h = tilted(20, 0);
        const long double a = azimuth("gram-schmidt", n, h);
        const long double b = azimuth("rotate-exact", n, h);
        EXPECT_NEAR(static_cast<double>(fabsl(b - a) * 180 / kPi), degrees, 0.05);
        EXPECT_LT(fabsl(azimuth("rotate-arc", n, h) - (a + b) / 2), 1e-17L);
    }
}

// docs/theory/papers.md: K12's exact rotation for grooves along the tangent, Gram-Schmidt of
// the tangent for grooves along the bitangent; grooves follow the sharper axis, x when equal.
TEST(OracleSelf, FollowGrainIsTheFrameOfItsGrooves) {
    const auto same = [](const Lobe& l, const std::string& method, Vec3 n, Vec3 h) {
        const Vec3 grain = mdf_transform(l.mdf, l.p0, l.p1, "follow-grain", n, h).v;
        expect_near(grain, mdf_transform(l.mdf, l.p0, l.p1, method, n, h).v, 1e-17L);
    };
    for (const auto& [n, h] : random_pairs(8, 200)) {
        same(kBrushed, "rotate-exact", n, h);
        same(kRound, "rotate-exact", n, h);
        same({"ashikhmin-shirley", 10, 200}, "gram-schmidt", n, h);
        for (const std::string mdf : {"ward", "beckmann", "ggx"}) {
            same({mdf, 0.1L, 0.4L}, "rotate-exact", n, h);
            same({mdf, 0.3L, 0.3L}, "rotate-exact", n, h);
            same({mdf, 0.4L, 0.1L}, "gram-schmidt", n, h);
        }
        // The groove itself, (g, -(g.d) / n~z): the lobe's x axis for g = x, its y axis for g = y.
        const Vec3 along_x = normalize({1, 0, -n.x / n.z});
        const Vec3 along_y = normalize({0, 1, -n.y / n.z});
        const Vec3 x = mdf_transform("ggx", 0.1L, 0.4L, "follow-grain", n, along_x).v;
        const Vec3 y = mdf_transform("ggx", 0.4L, 0.1L, "follow-grain", n, along_y).v;
        expect_near(x, {1, 0, 0}, 1e-18L);
        expect_near(y, {0, 1, 0}, 1e-18L);
    }
}

TEST(OracleSelf, ZeroWhereTheMethodsSaySo) {
    const Vec3 n = tilted(60, 0);
    const Vec3 behind_n = tilted(60, 180);   // n~.h < 0, h_z > 0
    const Vec3 below_base = tilted(100, 0);  // n~.h > 0, h_z < 0
    const std::set<std::string> base{"none", "deform-linear", "deform-smooth", "slope-shift"};
    for (const std::string& method : method_names()) {
        const bool on_base = base.count(method) == 1;
        EXPECT_EQ(value(kGgx, method, n, below_base).D > 0, !on_base) << method;
        if (method == "deform-smooth") continue;  // may leave the disk there
        EXPECT_EQ(value(kGgx, method, n, behind_n).D > 0, on_base) << method;
    }
    EXPECT_EQ(value(kGgx, "deform-smooth", n, tilted(85, 180)).D, 0);  // |q| > 1
}

// docs/theory/papers.md: near h = n the normal-mapped lobe takes every value between
// cos(30)^200 and cos(30)^10; at the pole itself cos^2 phi = 1.
TEST(OracleSelf, NormalMapPinch) {
    const Vec3 n = tilted(30, 40);
    const long double peak = value(kBrushed, "none", kUp, kUp).D;
    const auto near_pole = [&](Vec3 h) {
        return static_cast<double>(value(kBrushed, "normal-map", n, h).D / peak);
    };
    EXPECT_NEAR(near_pole({1e-9L, 0, 1}) / 3.2e-13, 1, 0.01);
    EXPECT_NEAR(near_pole({0, 1e-9L, 1}), 0.237, 0.001);
    EXPECT_NEAR(near_pole({0, 0, 1}) / 3.2e-13, 1, 0.01);
}

// ---------------------------------------------------------------- deformation

// docs/theory/papers.md: k = |C'p| / |C'R|, and 1 - k = hz^2 / (1 - d.p + S).
TEST(OracleSelf, DeformRatioHasAClosedForm) {
    const auto closed = [](Vec3 n, Vec3 h) {
        const Vec3 v{h.x - n.x, h.y - n.y, 0};
        const long double b = n.x * v.x + n.y * v.y;
        const long double s = sqrtl(b * b + dot(v, v) * n.z * n.z);
        return h.z * h.z / (1 - n.x * h.x - n.y * h.y + s);
    };
    for (const auto& [n, h] : random_pairs(9, 1000)) {
        expect_close(deform_ratio(n, h), closed(n, h), 1e-16L);
    }
    for (long double z = 1e-3L; z > 1e-10L; z /= 10) {
        const Vec3 h{sqrtl(1 - z * z) * 0.6L, sqrtl(1 - z * z) * 0.8L, z};
        expect_close(deform_ratio(tilted(50, 100), h), closed(tilted(50, 100), h), 1e-17L);
    }
    EXPECT_EQ(deform_ratio(tilted(50, 100), tilted(50, 100)), 1);
}

// Linear: |q| = k, q / k = R on the rim, and R, p, C' on one line in this order.
TEST(OracleSelf, LinearDeformationScalesTheRay) {
    for (const auto& [n, h] : random_pairs(10, 500)) {
        const Vec3 q = transformed("deform-linear", n, h).v;
        const Vec3 flat{q.x, q.y, 0};
        const long double k = length(flat);
        EXPECT_LT(fabsl(k - (1 - deform_ratio(n, h))), 1e-17L);
        EXPECT_LT(fabsl(q.z - sqrtl(1 - k * k)), 1e-16L);
        const Vec3 c{n.x, n.y, 0};
        const Vec3 p{h.x, h.y, 0};
        expect_near(c + k * ((1 / k) * flat - c), p, 1e-17L);
    }
}

// K11 Eq 5 without the root is the exact inverse of Eq 3.
TEST(OracleSelf, LinearDeformationInvertsEq3) {
    const Vec3 n = tilted(30, 40);
    const Vec3 d{n.x, n.y, 0};
    const long double worst = disk_most(60, 90, [&](Vec3 q) {
        const Vec3 v = transformed("deform-linear", n, lift(q + (1 - length(q)) * d)).v;
        return length(Vec3{v.x, v.y, 0} - q);
    });
    EXPECT_LT(worst, 1e-15L);
}

TEST(OracleSelf, DeformationJacobians) {
    constexpr long double kStep = 1e-6L;
    int checked = 0;
    for (const auto& pair : random_pairs(11, 500)) {
        const Vec3 n = pair.first;
        const Vec3 h = pair.second;
        const Vec3 p{h.x, h.y, 0};
        if (h.z < 0.05L || length(p - Vec3{n.x, n.y, 0}) < 0.05L) continue;
        for (const std::string method : {"deform-linear", "deform-smooth"}) {
            const auto map = [&](Vec3 at) { return transformed(method, n, lift(at)); };
            if (!map(p).alive) continue;
            const auto slope = [&](Vec3 axis) {
                return (0.5L / kStep) * (map(p + kStep * axis).v - map(p - kStep * axis).v);
            };
            const Vec3 dx = slope({1, 0, 0});
            const Vec3 dy = slope({0, 1, 0});
            expect_close(dx.x * dy.y - dx.y * dy.x, deform_det(method, n, h), 1e-6L);
            ++checked;
        }
    }
    EXPECT_GT(checked, 500);
}

// 8.7% of the disk leaves it under Eq 5 at 30 degrees, 12% under Eq 4.
TEST(OracleSelf, HowMuchLeavesTheDisk) {
    const Vec3 n = tilted(30, 0);
    const Vec3 d{n.x, n.y, 0};
    const long double out_5 = disk_mean(300, 300, [&](Vec3 p) {
        return transformed("deform-smooth", n, lift(p)).alive ? 0.0L : 1.0L;
    });
    const long double out_4 = disk_mean(
        300, 300, [&](Vec3 q) { return length(q + sqrtl(1 - length(q)) * d) > 1 ? 1.0L : 0.0L; });
    EXPECT_NEAR(static_cast<double>(out_5), 0.087, 0.001);
    EXPECT_NEAR(static_cast<double>(out_4), 0.12, 0.005);
}

// The true inverse of K11 Eq 4: |v + u d| = u (2 - u), t = 1 - u, by bisection.
Vec3 true_inverse(Vec3 d, Vec3 p) {
    long double low = 0;
    long double high = 1;
    for (int k = 0; k < 60; ++k) {
        const long double u = (low + high) / 2;
        (u * (2 - u) < length(p - d + u * d) ? low : high) = u;
    }
    return p - (1 - low) * d;
}

// docs/theory/papers.md, Eq 5 against the true inverse. The largest distance is |d|^2, met where
// the ray along d leaves the disk: there Eq 5 has t = 0 and the inverse t = |d|.
TEST(OracleSelf, SmoothDeformationIsNotTheInverse) {
    struct Row {
        long double tilt;
        double mean, most_within_30, l1_percent;
    };
    for (const Row& row : {Row{10, .004, .005, 1.3}, Row{20, .016, .028, 5.1},
                           Row{30, .033, .083, 11}, Row{45, .058, .5, 23}}) {
        const Vec3 n = tilted(row.tilt, 40);
        const Vec3 d{n.x, n.y, 0};
        const auto error = [&](Vec3 p) {
            const Vec3 v = transformed("deform-smooth", n, lift(p)).v;
            return length(Vec3{v.x, v.y, 0} - true_inverse(d, p));
        };
        expect_close(disk_most(40, 90, error), dot(d, d), 1e-3L);
        long double within_30 = 0;
        long double l1 = 0;  // Int |D5 - D_true| dp, for a lobe with Int D dp = 1
        const long double mean = disk_mean(120, 120, [&](Vec3 p) {
            const Vec3 q = true_inverse(d, p);
            const Vec3 v = transformed("deform-smooth", n, lift(p)).v;
            const long double distance = length(Vec3{v.x, v.y, 0} - q);
            if (length(q) < 0.5L) within_30 = std::max(within_30, distance);
            const long double truth = value(kBrushed, "none", kUp, lift(q)).D_proj;
            const long double got = value(kBrushed, "deform-smooth", n, lift(p)).D_proj;
            l1 += fabsl(got - truth) * kPi / (120 * 120);
            return distance;
        });
        EXPECT_NEAR(static_cast<double>(mean), row.mean, 0.0006) << row.tilt;
        // A supremum over samples; at 45 degrees it is next to the rim, where they are few.
        EXPECT_NEAR(static_cast<double>(within_30) / row.most_within_30, 1, 0.12) << row.tilt;
        EXPECT_NEAR(static_cast<double>(l1) * 100, row.l1_percent, 0.6) << row.tilt;
    }
}

}  // namespace
}  // namespace burnish::oracle
