// Where the highlight goes: a plate tilted by its normal map alone against the mirror direction and
// against a plate that is really tilted.
#include "highlight.hpp"

#include <gtest/gtest.h>

#include "lobes_under_test.hpp"

namespace burnish::test {
namespace {

TEST(Highlight, SeenAlongThePerturbedNormalItIsTheMirrorDirection) {
    for (const LobeCase& c :
         {LobeCase{f64::kMdfGgx, 0.1, 0.5}, LobeCase{f64::kMdfBeckmann, 0.4, 0.1},
          LobeCase{f64::kMdfWard, 0.1, 0.5}, LobeCase{f64::kMdfAshikhminShirley, 200, 10}}) {
        for (double tilt : {15.0, 30.0, 45.0}) {
            const vec3 n = direction(tilt * kPi / 180, 0.6);
            for (int method = f64::kMethodGramSchmidt; method < kMethods; ++method) {
                // Its lobe is no even one about n~: facets crowd towards the tilt (facet_map_test.cpp).
                if (method == f64::kMethodSlopeShift) continue;
                const vec3 peak = brightest(mapped_plate(c, method, n, n));
                EXPECT_LT(angle_deg(peak, n), 1.0) << label(c, method) << " at " << tilt;
            }
        }
    }
}

TEST(Highlight, FollowGrainIsThePlateReallyTilted) {
    for (const LobeCase& c :
         {LobeCase{f64::kMdfGgx, 0.1, 0.5}, LobeCase{f64::kMdfGgx, 0.6, 0.2},
          LobeCase{f64::kMdfWard, 0.1, 0.5}, LobeCase{f64::kMdfAshikhminShirley, 200, 10}}) {
        for (double tilt : {15.0, 30.0, 45.0}) {
            const vec3 n = direction(tilt * kPi / 180, 2.5);
            for (const vec3& wo : {vec3{0, 0, 1}, direction(0.5, 1.0), direction(0.9, 4.0)}) {
                if (f64::dot(n, wo) < 0.1) {
                    continue;
                }
                const Radiance mapped = mapped_plate(c, f64::kMethodFollowGrain, n, wo);
                const Radiance tilted = tilted_plate(c, n, wo);
                EXPECT_LT(angle_deg(brightest(mapped), brightest(tilted)), 0.25)
                    << label(c, f64::kMethodFollowGrain) << " at " << tilt;
                for (double theta : {0.2, 0.6, 1.0}) {  // and not only the peak
                    const vec3 wi = direction(theta, 1.9);
                    EXPECT_NEAR(mapped(wi), tilted(wi), 1e-9 * (1 + std::abs(tilted(wi))));
                }
            }
        }
    }
}

// The light angle of brightest reflection in the plane of the tilt, seen along the geometric normal
// (docs/theory/methods.md, "What engines ship"): GGX, height-correlated Smith.
double brightest_in_plane_deg(double alpha_x, double alpha_y, int method, double tilt_deg,
                              bool along_x) {
    const double phi = along_x ? 0.0 : kPi / 2;
    const vec3 n = direction(tilt_deg * kPi / 180, phi);
    const Radiance radiance =
        mapped_plate({f64::kMdfGgx, alpha_x, alpha_y}, method, n, vec3{0, 0, 1});
    double best = -90, best_value = -1;
    for (int i = -8990; i <= 8990; ++i) {
        const double value = radiance(direction(i * 0.01 * kPi / 180, phi));
        if (value > best_value) {
            best_value = value;
            best = i * 0.01;
        }
    }
    return best;
}

TEST(Highlight, NormalMapMissesAsTheEnginesDo) {
    const int shipped = f64::kMethodNormalMap;
    const int orthonormal = f64::kMethodGramSchmidt;
    EXPECT_NEAR(brightest_in_plane_deg(.1, .5, shipped, 30, true), -0.5, 0.06);
    EXPECT_NEAR(brightest_in_plane_deg(.1, .5, orthonormal, 30, true), 60.0, 0.06);
    EXPECT_NEAR(brightest_in_plane_deg(.1, .5, shipped, 30, false), -13.2, 0.06);
    EXPECT_NEAR(brightest_in_plane_deg(.1, .5, orthonormal, 30, false), 58.4, 0.06);
    EXPECT_NEAR(brightest_in_plane_deg(.3, .8, shipped, 15, false), -22.9, 0.06);
    EXPECT_NEAR(brightest_in_plane_deg(.3, .8, orthonormal, 15, false), 24.5, 0.06);
    EXPECT_NEAR(brightest_in_plane_deg(.1, .1, shipped, 30, true), -0.5, 0.06);
    EXPECT_NEAR(brightest_in_plane_deg(.1, .1, orthonormal, 30, true), 60.0, 0.06);
}

}  // namespace
}  // namespace burnish::test
