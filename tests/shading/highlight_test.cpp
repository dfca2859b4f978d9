// Where the highlight goes: a plate tilted by its normal map alone against the mirror direction and
// against a plate that is really tilted.
#include <gtest/gtest.h>

#include "lobes_under_test.hpp"

namespace burnish::test {
namespace {

using Radiance = std::function<double(vec3 wi)>;

double angle_deg(vec3 a, vec3 b) {
    return std::atan2(f64::length(f64::cross(a, b)), f64::dot(a, b)) * 180 / kPi;
}

// The direction that maximises `radiance`: a grid over the sphere, then ever finer ones around the
// best point.
vec3 brightest(const Radiance& radiance) {
    vec3 best{0, 0, 1};
    double best_value = -1;
    double reach = kPi;
    vec3 center = direction(1e-4, 0.3);
    for (int level = 0; level < 12; ++level) {
        const Axes axes(center);
        const int rings = level == 0 ? 360 : 24;
        const int sectors = level == 0 ? 720 : 48;
        for (int i = 0; i < rings; ++i) {
            for (int j = 0; j < sectors; ++j) {
                const vec3 wi = axes.at(reach * i / rings, 2 * kPi * j / sectors);
                const double value = radiance(wi);
                if (value > best_value) {
                    best_value = value;
                    best = wi;
                }
            }
        }
        center = best;
        reach = level == 0 ? 0.02 : reach * 0.4;
    }
    return best;
}

Radiance mapped_plate(const LobeCase& c, int method, vec3 n, vec3 wo) {
    const f64::Lobe lobe = f64::lobe_make(c.mdf, c.p0, c.p1);
    const f64::Perturbation p = perturbation(c, method, n);
    return [=](vec3 wi) {
        return f64::brdf_eval(f64::kBrdfMicrofacet, lobe, p, wi, wo) * f64::dot(p.n, wi);
    };
}

// A plate whose geometry lies in the plane of normal n: an unperturbed lobe in the frame that its
// own surface has. The height field z = -(n.x x + n.y y)/n.z carries the tangent to
// (1, 0, -n.x/n.z) and the bitangent to (0, 1, -n.y/n.z); grooves keep to their carried direction.
Radiance tilted_plate(const LobeCase& c, vec3 n, vec3 wo) {
    const bool along_x = c.mdf == f64::kMdfAshikhminShirley ? c.p0 >= c.p1 : c.p0 <= c.p1;
    const vec3 carried = along_x ? vec3{1, 0, -n.x / n.z} : vec3{0, 1, -n.y / n.z};
    const vec3 groove = f64::normalize(carried);
    const vec3 across = f64::cross(n, groove);
    const vec3 x_axis = along_x ? groove : -across;
    const vec3 y_axis = f64::cross(n, x_axis);
    const f64::Lobe lobe = f64::lobe_make(c.mdf, c.p0, c.p1);
    const f64::Perturbation flat = f64::perturb_make(f64::kMethodNone, {0, 0, 1}, true, false);
    const auto local = [=](vec3 w) {
        return vec3{f64::dot(x_axis, w), f64::dot(y_axis, w), f64::dot(n, w)};
    };
    return [=](vec3 wi) {
        return f64::brdf_eval(f64::kBrdfMicrofacet, lobe, flat, local(wi), local(wo)) *
               f64::dot(n, wi);
    };
}

TEST(Highlight, SeenAlongThePerturbedNormalItIsTheMirrorDirection) {
    for (const LobeCase& c : {LobeCase{f64::kMdfGgx, 0.1, 0.5}, LobeCase{f64::kMdfBeckmann, 0.4, 0.1},
                              LobeCase{f64::kMdfWard, 0.1, 0.5},
                              LobeCase{f64::kMdfAshikhminShirley, 200, 10}}) {
        for (double tilt : {15.0, 30.0, 45.0}) {
            const vec3 n = direction(tilt * kPi / 180, 0.6);
            for (int method = f64::kMethodGramSchmidt; method < kMethods; ++method) {
                const vec3 peak = brightest(mapped_plate(c, method, n, n));
                EXPECT_LT(angle_deg(peak, n), 1.0) << label(c, method) << " at " << tilt;
            }
        }
    }
}

TEST(Highlight, FollowGrainIsThePlateReallyTilted) {
    for (const LobeCase& c : {LobeCase{f64::kMdfGgx, 0.1, 0.5}, LobeCase{f64::kMdfGgx, 0.6, 0.2},
                              LobeCase{f64::kMdfWard, 0.1, 0.5},
                              LobeCase{f64::kMdfAshikhminShirley, 200, 10}}) {
        for (double tilt : {15.0, 30.0, 45.0}) {
            const vec3 n = direction(tilt * kPi / 180, 2.5);
            for (const vec3& wo : {vec3{0, 0, 1}, direction(0.5, 1.0), direction(0.9, 4.0)}) {
                if (f64::dot(n, wo) < 0.1) { continue; }
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
// (docs/papers.md, "What engines ship"): GGX, height-correlated Smith.
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
