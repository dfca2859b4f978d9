// What is done about directions below a horizon: shading/perturb/facing.glsl and the study's
// strategies.
#include <gtest/gtest.h>

#include <algorithm>

#include "horizon_strategies.hpp"

namespace burnish::test {
namespace {

double degrees(double d) {
    return d * kPi / 180;
}

TEST(NormalFacing, LeavesNormalsThatFaceTheView) {
    for (double tilt = 0; tilt < 80; tilt += 7) {
        for (double view = 0; view < 89.9; view += 3) {
            const vec3 n = direction(degrees(tilt), 0.4), wo = direction(degrees(view), 0.9);
            if (f64::dot(n, wo) < std::min(0.1, wo.z)) continue;
            const vec3 m = f64::normal_facing(n, wo);
            EXPECT_EQ(m.x, n.x);
            EXPECT_EQ(m.z, n.z);
        }
    }
    // An unperturbed normal is left alone at any view.
    const vec3 z{0, 0, 1};
    for (double view = 0; view < 89.99; view += 0.37) {
        EXPECT_EQ(f64::normal_facing(z, direction(degrees(view), 1.0)).z, 1.0) << view;
    }
}

TEST(NormalFacing, IsUnitUprightAndFacesTheView) {
    for (double tilt = 1; tilt < 89; tilt += 4) {
        for (double view = 0; view < 89; view += 4) {
            for (const double azimuth : {0.0, 60.0, 120.0, 180.0}) {
                const vec3 wo = direction(degrees(view), 0.0);
                const vec3 m = f64::normal_facing(direction(degrees(tilt), degrees(azimuth)), wo);
                const double t = std::min(0.1, wo.z);
                EXPECT_NEAR(f64::length(m), 1.0, 1e-12);
                EXPECT_GT(m.z, 0.0);
                EXPECT_GE(f64::dot(m, wo), t / 2 - 1e-12) << tilt << ", " << view;
            }
        }
    }
}

// Along a path of tilts that crosses the horizon the turned normal does not jump: it moves as fast
// as n~ does, on a circle about the view that is at most 1/sin(n~, wo) wider than n~'s.
TEST(NormalFacing, DoesNotJump) {
    constexpr double kStep = 0.01;
    for (const double view : {20.0, 60.0, 85.0}) {
        for (const double azimuth : {180.0, 170.0, 120.0}) {
            const vec3 wo = direction(degrees(view), 0.0);
            vec3 before{0, 0, 1};
            for (double tilt = kStep; tilt < 88; tilt += kStep) {
                const vec3 n = direction(degrees(tilt), degrees(azimuth));
                const vec3 m = f64::normal_facing(n, wo);
                const double across = f64::length(f64::cross(n, wo));
                EXPECT_LT(f64::length(m - before), 1.05 * degrees(kStep) / across)
                    << tilt << ", " << view << ", " << azimuth;
                before = m;
            }
        }
    }
}

// The facets and mirrors of a unit of surface: their areas seen from above add up to it and their
// mean normal is its own; from any side, no less is seen than the surface shows.
TEST(TwoFacets, AreasAreThoseOfTheSurface) {
    for (const double tilt : {1.0, 30.0, 60.0, 85.0}) {
        const vec3 n = direction(degrees(tilt), 2.0);
        const TwoFacets f = two_facets_make(n);
        const vec3 mean = n * (1 / n.z) + f.upright * (f.sine / n.z);
        EXPECT_NEAR(mean.x, 0, 1e-12);
        EXPECT_NEAR(mean.y, 0, 1e-12);
        EXPECT_NEAR(mean.z, 1, 1e-12);
        for (double theta = 0; theta < 90; theta += 9) {
            for (double phi = 0; phi < 360; phi += 30) {
                const vec3 w = direction(degrees(theta), degrees(phi));
                const auto areas = two_facets_areas(f, w);
                EXPECT_GE((areas.x + areas.y) / n.z, w.z - 1e-12);
                EXPECT_NEAR(two_facets_masking(f, w) * (areas.x + areas.y), w.z * n.z, 1e-12);
            }
        }
    }
    const TwoFacets flat = two_facets_make({0, 0, 1});
    EXPECT_EQ(two_facets_share(flat, direction(1.0, 0.3)), 1.0);
    EXPECT_EQ(two_facets_masking(flat, direction(1.0, 0.3)), 1.0);
}

double white(vec3) {
    return 1.0;
}

class Furnace : public testing::TestWithParam<Strategy> {};

// Albedo over views and tilts to 80 degrees: never above 1, and for what was adopted never black.
TEST_P(Furnace, GainsNothingAndIsNeverBlack) {
    const f64::Lobe lobe = f64::lobe_make(f64::kMdfGgx, 0.1, 0.4);
    double least = 1;
    for (const double tilt : {0.0, 30.0, 60.0, 80.0}) {
        for (const double view : {0.0, 45.0, 75.0, 86.0}) {
            for (const double azimuth : {0.0, 70.0, 140.0, 180.0}) {
                const double albedo =
                    reflected(GetParam(), lobe, direction(degrees(tilt), degrees(azimuth)),
                              direction(degrees(view), 0.0), 200, 0.1, 0.2, white);
                EXPECT_LT(albedo, 1.001) << tilt << ", " << view << ", " << azimuth;
                least = std::min(least, albedo);
            }
        }
    }
    const bool adopted = GetParam() == Strategy::face_view || GetParam() == Strategy::two_facets;
    if (adopted) {
        EXPECT_GT(least, 0.15);
    }
    // What the others are not chosen for.
    if (GetParam() == Strategy::perturbed_horizon) {
        EXPECT_EQ(least, 0.0);
    }
}

INSTANTIATE_TEST_SUITE_P(Strategies, Furnace,
                         testing::Values(Strategy::perturbed_horizon, Strategy::flip,
                                         Strategy::bend_reflection, Strategy::face_view,
                                         Strategy::two_facets));

}  // namespace
}  // namespace burnish::test
