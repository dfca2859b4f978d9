// The coverage of rigs, compared with closed forms, quadrature and sums over lattices.
#include "burnish/coverage.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "core/constants.hpp"

namespace burnish {
namespace {

Vec3d direction(double theta_deg, double phi_deg) {
    const double t = theta_deg * kDegree, p = phi_deg * kDegree;
    return {std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t)};
}

double dot(const Vec3d& a, const Vec3d& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Rig rig_of(const Vec3d& view, const std::vector<Vec3d>& lights) {
    Rig rig;
    rig.camera = {false, view};
    for (const Vec3d& light : lights) {
        RigLight entry;
        entry.place = {false, light};
        rig.lights.push_back(entry);
    }
    return rig;
}

// The light whose half vector with `view` is `half`: the reflection of `view` about `half`.
Vec3d light_for(const Vec3d& half, const Vec3d& view) {
    const double twice = 2 * dot(half, view);
    return {twice * half[0] - view[0], twice * half[1] - view[1], twice * half[2] - view[2]};
}

std::vector<Vec3d> spread_over_a_cap(int count, double widest_deg) {
    std::vector<Vec3d> lights;
    const double least = std::cos(widest_deg * kDegree);
    for (int k = 0; k < count; ++k) {
        const double z = 1 - (1 - least) * (k + 0.5) / count;
        lights.push_back(direction(std::acos(z) / kDegree, 137.50776405 * k));
    }
    return lights;
}

bool says(const RigCoverage& coverage, const std::string& part) {
    for (const std::string& line : coverage.diagnosis)
        if (line.find(part) != line.npos) return true;
    return false;
}

// d w_h = d w_i / (4 i.h): the solid angle of the half vectors of all lights up to `widest`.
double share_by_quadrature(const Vec3d& view, double widest_deg) {
    constexpr int kThetas = 400, kPhis = 400;
    double sum = 0;
    for (int a = 0; a < kThetas; ++a)
        for (int b = 0; b < kPhis; ++b) {
            const double theta = widest_deg * (a + 0.5) / kThetas;
            const Vec3d i = direction(theta, 360.0 * b / kPhis);
            const double ih = std::sqrt((1 + dot(i, view)) / 2);  // cosine of half the angle
            sum += std::sin(theta * kDegree) / (4 * ih);
        }
    return sum * (widest_deg * kDegree / kThetas) * (2 * kPi / kPhis) / (2 * kPi);
}

TEST(Coverage, DenseLightsCoverWhatTheJacobianSays) {
    for (const double view_deg : {0.0, 30.0, 45.0}) {
        const Vec3d view = direction(view_deg, 20);
        const PointCoverage c =
            point_coverage(rig_of(view, spread_over_a_cap(3000, 75)), {0, 0, 0});
        // The caps extend beyond the edge by a quarter of the spacing of 1.2 deg: 0.005 rad along
        // an edge of about 4.5 rad is 0.004 of the hemisphere. The irregular spiral adds as much.
        EXPECT_NEAR(c.covered, share_by_quadrature(view, 75), 0.012) << view_deg;
        const double limit = (75 + view_deg) / 2;
        EXPECT_NEAR(c.theta_h_limit, limit, 0.5);
        EXPECT_NEAR(c.theta_h_max, limit, 1.5);  // no light lies exactly in the plane
        EXPECT_NEAR(c.covered_turned, 1 - std::cos(limit * kDegree), 0.025);
    }
}

TEST(Coverage, HalfVectorsNeverTiltMoreThanHalfOfBothAngles) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> theta(0, 89), phi(0, 360);
    for (int k = 0; k < 200; ++k) {
        const double light = theta(random), view = theta(random), at = phi(random);
        const Rig rig = rig_of(direction(view, at), {direction(light, phi(random))});
        const PointCoverage c = point_coverage(rig, {0, 0, 0});
        EXPECT_LE(c.theta_h_max, c.theta_h_limit + 1e-9);
        EXPECT_NEAR(c.theta_h_limit, (light + view) / 2, 1e-9);
        // In one plane and on one side, theta_h reaches the limit.
        const Rig plane = rig_of(direction(view, at), {direction(light, at)});
        EXPECT_NEAR(point_coverage(plane, {0, 0, 0}).theta_h_max, (light + view) / 2, 1e-9);
    }
}

TEST(Coverage, FewLightsCoverCapsAndTurnedBands) {
    const Vec3d view = direction(20, 0);
    const Vec3d a = direction(15, 0), b = direction(30, 180);  // half vectors 45 degrees apart
    const PointCoverage c =
        point_coverage(rig_of(view, {light_for(a, view), light_for(b, view)}), {0, 0, 0});
    EXPECT_NEAR(c.spacing, 45, 1e-9);
    EXPECT_EQ(c.reach, 10);
    // 20,000 points of equal weight: a cap of 304 points has an error of a few points at its rim.
    EXPECT_NEAR(c.covered, 2 * (1 - std::cos(10 * kDegree)), 5e-4);
    const auto band = [](double low, double high) {
        return std::cos(low * kDegree) - std::cos(high * kDegree);
    };
    EXPECT_NEAR(c.covered_turned, band(5, 25) + band(25, 40), 1e-9);  // they overlap from 20 to 25
    EXPECT_NEAR(c.theta_view, 20, 1e-9);
}

TEST(Coverage, CoincidentHalfVectorsCountOnce) {
    const Vec3d view = direction(20, 0), a = direction(40, 10), b = direction(40, 60);
    const PointCoverage twice = point_coverage(rig_of(view, {a, a, b, b}), {0, 0, 0});
    const PointCoverage once = point_coverage(rig_of(view, {a, b}), {0, 0, 0});
    EXPECT_NEAR(twice.spacing, once.spacing, 1e-9);
    EXPECT_EQ(twice.half_vectors.size(), 4u);
    EXPECT_EQ(point_coverage(rig_of(view, {a, a}), {0, 0, 0}).spacing, 0.0);
}

TEST(Coverage, SpacingOfALattice) {
    const Vec3d view = direction(45, 90);
    std::vector<Vec3d> lights;
    for (int x = -5; x <= 5; ++x)
        for (int y = -5; y <= 5; ++y) {
            const double hx = 2 * kDegree * x, hy = 3 * kDegree * y;
            lights.push_back(light_for({hx, hy, std::sqrt(1 - hx * hx - hy * hy)}, view));
        }
    // hx is the sine of the tilt: at 10 degrees a step is longer by 1 / cos, 1.5 %.
    EXPECT_NEAR(point_coverage(rig_of(view, lights), {0, 0, 0}).spacing, 2.0, 0.03);
}

// --- the narrowest lobe -------------------------------------------------------------------------

double ggx(double alpha, double cosine) {
    const double t2 = 1 / (cosine * cosine) - 1;
    return alpha * alpha / (kPi * std::pow(cosine, 4) * std::pow(alpha * alpha + t2, 2));
}
double beckmann(double alpha, double cosine) {
    const double t2 = 1 / (cosine * cosine) - 1;
    return std::exp(-t2 / (alpha * alpha)) / (kPi * alpha * alpha * std::pow(cosine, 4));
}
using Lobe = double (*)(double alpha, double cosine);

// Error of int D cos dw = 1, computed on a square lattice of half vectors in (hx, hy), whose cells
// are cos dw: the largest over a few positions of the lattice relative to the lobe.
double worst_error_of_the_integral(Lobe lobe, double alpha, double spacing) {
    double worst = 0;
    for (const auto& [u, v] : {std::pair{0.0, 0.0}, {0.5, 0.5}, {0.5, 0.0}, {0.2, 0.1}}) {
        double sum = 0;
        const int most = static_cast<int>(1 / spacing) + 1;
        for (int x = -most; x <= most; ++x)
            for (int y = -most; y <= most; ++y) {
                const double hx = (x + u) * spacing, hy = (y + v) * spacing;
                const double z2 = 1 - hx * hx - hy * hy;
                if (z2 > 0) sum += lobe(alpha, std::sqrt(z2)) * spacing * spacing;
            }
        worst = std::max(worst, std::abs(sum - 1));
    }
    return worst;
}

TEST(NarrowestLobe, HoldsTwoSpacingsAtHalfItsMaximum) {
    for (const double spacing : {0.5, 2.8, 10.0}) {
        const double cosine = std::cos(spacing * kDegree);
        const double g = narrowest_ggx_alpha(spacing), b = narrowest_beckmann_alpha(spacing);
        EXPECT_NEAR(ggx(g, cosine) / ggx(g, 1), 0.5, 1e-12);
        EXPECT_NEAR(beckmann(b, cosine) / beckmann(b, 1), 0.5, 1e-12);
    }
}

// Expected errors from the Poisson sum, with x = 2 pi alpha / d: the first four harmonics are 4 x
// K1(x) for a GGX lobe (0.1 % at the limit, 9 % at half of it, 80 % at a quarter) and 4 exp(-x^2 /
// 4) for a Beckmann lobe (3e-6, 11 %, 160 %).
TEST(NarrowestLobe, NarrowerOnesAreBadlySampled) {
    constexpr double kSpacing = 1.0;
    struct Case {
        Lobe lobe;
        double alpha;
    };
    for (const Case& c : {Case{ggx, narrowest_ggx_alpha(kSpacing)},
                          Case{beckmann, narrowest_beckmann_alpha(kSpacing)}}) {
        const double d = kSpacing * kDegree;
        EXPECT_LT(worst_error_of_the_integral(c.lobe, c.alpha, d), 0.003);
        EXPECT_GT(worst_error_of_the_integral(c.lobe, c.alpha / 2, d), 0.05);
        EXPECT_GT(worst_error_of_the_integral(c.lobe, c.alpha / 4, d), 0.5);
    }
}

// --- the whole rig ------------------------------------------------------------------------------

TEST(RigCoverage, LightsInWords) {
    const Vec3d view = direction(40, 0);
    const RigCoverage c = rig_coverage(
        rig_of(view, {direction(10, 350), direction(30, 20), direction(60, 80), direction(0, 0)}));
    EXPECT_NEAR(c.lowest_light, 30, 1e-9);
    EXPECT_NEAR(c.highest_light, 90, 1e-9);
    EXPECT_NEAR(c.azimuth_spread, 90, 1e-9);  // from 350 through 0 to 80
    EXPECT_TRUE(c.corners.empty());
    EXPECT_TRUE(says(c, "within 90 deg of azimuth"));
    EXPECT_GT(c.narrowest_ggx, c.narrowest_beckmann);  // GGX has the narrower core
}

TEST(RigCoverage, CornersSeeNearThingsFromElsewhere) {
    Rig rig = rig_of({}, {{0, 0, 100}, {50, 0, 100}});
    for (RigLight& light : rig.lights) light.place.near = true;
    rig.camera = {true, {0, -100, 100}};
    rig.width_mm = 60;
    rig.height_mm = 40;
    const RigCoverage c = rig_coverage(rig);
    ASSERT_EQ(c.corners.size(), 4u);
    EXPECT_EQ(c.corners[0].point_mm, (Vec3d{-30, 20, 0}));
    EXPECT_EQ(c.corners[3].point_mm, (Vec3d{30, -20, 0}));
    EXPECT_NEAR(c.center.theta_view, 45, 1e-9);
    EXPECT_NEAR(c.corners[0].theta_view, std::atan2(std::hypot(30, 120), 100) / kDegree, 1e-9);
    // Corners that mirror each other in x have equal views.
    EXPECT_NEAR(c.corners[0].theta_view, c.corners[1].theta_view, 1e-9);
    rig.width_mm = 0;  // as from an .lp file
    EXPECT_TRUE(rig_coverage(rig).corners.empty());
}

TEST(RigCoverage, OwnCamerasOfLights) {
    Rig rig = rig_of({0, 0, 1}, {{0, 0, 1}, {0, 0, 1}});
    rig.lights[1].camera = RigPlace{false, direction(60, 0)};
    const PointCoverage c = point_coverage(rig, {0, 0, 0});
    EXPECT_NEAR(c.spacing, 30, 1e-9);
    EXPECT_NEAR(c.theta_view, 30, 1e-9);
}

TEST(RigCoverage, SaysWhatCannotWork) {
    const std::vector<Vec3d> dome = spread_over_a_cap(200, 75);
    EXPECT_TRUE(says(rig_coverage(rig_of({0, 0, 1}, dome)), "completion is impossible"));
    EXPECT_FALSE(says(rig_coverage(rig_of(direction(45, 0), dome)), "impossible"));
    // With a bar of lights and an upright camera, rotations do help.
    std::vector<Vec3d> bar;
    for (int k = 1; k < 14; ++k) bar.push_back(direction(5 * k, 0));
    EXPECT_FALSE(says(rig_coverage(rig_of({0, 0, 1}, bar)), "impossible"));
    EXPECT_TRUE(says(rig_coverage(rig_of(direction(45, 0), {{0, 0, 1}})), "one light"));
    EXPECT_TRUE(
        says(rig_coverage(rig_of(direction(45, 0), spread_over_a_cap(9, 88))), "few lights"));
    EXPECT_TRUE(
        says(rig_coverage(rig_of(direction(45, 0), spread_over_a_cap(300, 88))), "casts shadows"));
    EXPECT_TRUE(says(rig_coverage(rig_of(direction(45, 0), dome)), "a distribution is a guess"));
}

}  // namespace
}  // namespace burnish
