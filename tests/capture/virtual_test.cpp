// Simulated samples compared with quadrature and closed forms written here. They are the truth for
// the tests of fits, so that only physics may define them.
#include <gtest/gtest.h>
#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <string>

#include "burnish/virtual_sample.hpp"
#include "table_support.hpp"

namespace burnish {
namespace {

using test::Random;

Vec3d direction(double theta, double phi) {
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}
double dot(const Vec3d& a, const Vec3d& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Vec3d unit(Vec3d v) {
    const double length = std::sqrt(dot(v, v));
    for (double& c : v) c /= length;
    return v;
}
// Midpoints in u = sqrt(2 theta / pi), which are dense near the normal, and in phi.
struct Node {
    Vec3d h;
    double D_dw;
};
std::vector<Node> nodes_of(const VirtualNdf& ndf, int rings = 480, int columns = 720) {
    std::vector<Node> out;
    for (int r = 0; r < rings; ++r) {
        const double u = (r + 0.5) / rings, theta = kPi / 2 * u * u;
        const double dw = std::sin(theta) * kPi * u / rings * 2 * kPi / columns;
        for (int a = 0; a < columns; ++a) {
            const Vec3d h = direction(theta, 2 * kPi * (a + 0.5) / columns);
            out.push_back({h, ndf.D(h) * dw});
        }
    }
    return out;
}

VirtualLobe lobe(double weight, Mdf mdf, double ax, double ay, double turn, double lean_x,
                 double lean_y) {
    return {weight, mdf, ax, ay, turn, lean_x, lean_y};
}

// The distributions of all presets, and strongly leaning lobes.
std::vector<VirtualNdf> all_ndfs() {
    std::vector<VirtualNdf> out;
    for (const VirtualPreset& preset : virtual_presets()) {
        for (VirtualNdf ndf : make_virtual_sample(preset.name, {}).ndfs) {
            ndf.name = std::string(preset.name) + "/" + ndf.name;
            out.push_back(ndf);
        }
    }
    for (const Mdf mdf : {Mdf::ggx, Mdf::beckmann}) {
        const std::string which = mdf == Mdf::ggx ? "ggx" : "beckmann";
        out.push_back({which + " lean", {lobe(1, mdf, 0.15, 0.4, 0.6, 0.5, -0.3)}});
        out.push_back({which + " far", {lobe(1, mdf, 0.2, 0.2, 0, -1.2, 0.4)}});
        out.push_back(
            {which + " pair",
             {lobe(0.7, mdf, 0.1, 0.5, 1, 0.3, 0), lobe(0.3, mdf, 0.3, 0.2, 0, 0, -0.6)}});
    }
    return out;
}

TEST(VirtualNdf, MassIsOne) {
    for (const VirtualNdf& ndf : all_ndfs()) {
        double mass = 0;
        for (const Node& n : nodes_of(ndf)) mass += n.D_dw * n.h[2];
        EXPECT_NEAR(mass, 1, 1e-3) << ndf.name;
        EXPECT_EQ(ndf.D({0.6, 0, -0.8}), 0) << ndf.name;
    }
}

// g(k) = Int max(h.k, 0) D dw, from above to just below the horizon, where leaning lobes have the
// largest effect.
TEST(VirtualNdf, AreasAreTheIntegral) {
    for (const VirtualNdf& ndf : all_ndfs()) {
        const std::vector<Node> nodes = nodes_of(ndf);
        for (const double degrees : {0.0, 30.0, 60.0, 80.0, 88.0, 90.0}) {
            for (const double phi : {0.0, 0.8, 2.2, 3.5, 5.1}) {
                const Vec3d k = direction(degrees * kPi / 180, phi);
                double g = 0;
                for (const Node& n : nodes) g += std::max(dot(n.h, k), 0.0) * n.D_dw;
                // 1e-3: error of the rule with 480 x 720 nodes at the kink of max().
                EXPECT_NEAR(ndf.area(k), g, 1e-3) << ndf.name << " " << degrees << " " << phi;
            }
        }
        EXPECT_NEAR(ndf.area({0, 0, 1}), 1, 1e-9) << ndf.name;
    }
}

// The lobe's axes are rotated counter-clockwise; the lean is in the class's frame.
TEST(VirtualNdf, TurnAndLeanAreAsDescribed) {
    const double ax = 0.15, ay = 0.45, turn = 0.7;
    for (const Mdf mdf : {Mdf::ggx, Mdf::beckmann}) {
        const VirtualNdf ndf{"one", {lobe(1, mdf, ax, ay, turn, 0.2, -0.1)}};
        for (int i = 0; i < 60; ++i) {
            const Vec3d h = direction(0.02 * i, 1.3 * i);
            const double p = h[0] / h[2] - 0.2, q = h[1] / h[2] + 0.1;
            const double x = std::cos(turn) * p + std::sin(turn) * q;
            const double y = -std::sin(turn) * p + std::cos(turn) * q;
            const double e = x * x / (ax * ax) + y * y / (ay * ay);
            const double density = mdf == Mdf::ggx ? 1 / ((1 + e) * (1 + e)) : std::exp(-e);
            const double D = density / (kPi * ax * ay * std::pow(h[2], 4));
            EXPECT_NEAR(ndf.D(h), D, 1e-6 * D + 1e-12) << i;
        }
    }
    const Vec3d v = rotated_about_z({1, 0, 0.5}, kPi / 2);
    EXPECT_NEAR(v[0], 0, 1e-15);
    EXPECT_NEAR(v[1], 1, 1e-15);
    EXPECT_EQ(v[2], 0.5);
}

double fresnel(double eta, double c) {  // unpolarized, from outside
    const double t = std::sqrt(1 - (1 - c * c) / (eta * eta));
    const double s = (c - eta * t) / (c + eta * t), p = (eta * c - t) / (eta * c + t);
    return (s * s + p * p) / 2;
}

VirtualSample plain(int side, const VirtualNdf& ndf, const VirtualTexel& texel, double eta) {
    VirtualSample out;
    out.name = "plain";
    out.width = out.height = side;
    out.width_mm = out.height_mm = 60;
    out.eta = eta;
    out.ndfs = {ndf};
    out.texels.assign(static_cast<std::size_t>(side * side), texel);
    return out;
}

// diffuse / pi + specular F(i.h)/F(1) D(h) / (4 g(i) g(o)), with directions rotated back by the
// grain.
TEST(VirtualBrdf, IsTheModelOfTheManual) {
    const VirtualNdf ndf{"one", {lobe(1, Mdf::ggx, 0.3, 0.12, 0.3, 0.1, 0.2)}};
    for (const double eta : {0.0, 1.5}) {
        const VirtualTexel texel{0, 0.9, {0.1, 0.2, 0.3}, {0.04, 0.05, 0.06}, {0, 0, 1}};
        const VirtualSample sample = plain(1, ndf, texel, eta);
        Random random(4);
        for (int i = 0; i < 50; ++i) {
            const Vec3d wi = direction(random.uniform(0, 1.4), random.uniform(0, 7));
            const Vec3d wo = direction(random.uniform(0, 1.4), random.uniform(0, 7));
            const Vec3d h = unit({wi[0] + wo[0], wi[1] + wo[1], wi[2] + wo[2]});
            const auto back = [&](const Vec3d& v) { return rotated_about_z(v, -0.9); };
            const double shape = ndf.D(back(h)) / (4 * ndf.area(back(wi)) * ndf.area(back(wo))) *
                                 (eta == 0 ? 1 : fresnel(eta, dot(wi, h)) / fresnel(eta, 1));
            const Vec3d rho = virtual_brdf(sample, texel, wi, wo);
            for (std::size_t c = 0; c < 3; ++c) {
                const double expected = texel.diffuse[c] / kPi + texel.specular[c] * shape;
                EXPECT_NEAR(rho[c], expected, 1e-9 * expected) << eta << " " << i;
            }
        }
    }
}

// A tilted normal rotates the whole lobe: a flat texel with equally rotated directions of light and
// view is as bright. The rotation is about x and the grain along x, so that the grain stays.
TEST(VirtualBrdf, TiltedNormalsCarryTheLobe) {
    const VirtualNdf ndf{"one", {lobe(1, Mdf::beckmann, 0.4, 0.15, 0, 0, 0)}};
    const double tilt = 0.15;
    const VirtualTexel flat{0, 0, {0.1, 0.1, 0.1}, {0.05, 0.05, 0.05}, {0, 0, 1}};
    VirtualTexel tilted = flat;
    tilted.normal = {0, -std::sin(tilt), std::cos(tilt)};
    const auto carried = [&](const Vec3d& v) {
        return Vec3d{v[0], std::cos(tilt) * v[1] - std::sin(tilt) * v[2],
                     std::sin(tilt) * v[1] + std::cos(tilt) * v[2]};
    };
    const VirtualSample sample = plain(1, ndf, flat, 1.5);
    Random random(8);
    for (int i = 0; i < 40; ++i) {
        const Vec3d wi = direction(random.uniform(0, 1.3), random.uniform(0, 7));
        const Vec3d wo = direction(random.uniform(0, 1.3), random.uniform(0, 7));
        const double a = virtual_brdf(sample, flat, wi, wo)[1];
        EXPECT_NEAR(virtual_brdf(sample, tilted, carried(wi), carried(wo))[1], a, 1e-9 * a) << i;
    }
    const Vec3d grazing = direction(kPi / 2 - 0.05, kPi / 2);  // above z = 0, behind the texel
    for (const double c : virtual_brdf(sample, tilted, grazing, {0, 0, 1})) EXPECT_EQ(c, 0);
    for (const double c : virtual_brdf(sample, tilted, {0, 0, 1}, grazing)) EXPECT_EQ(c, 0);
}

TEST(VirtualBrdf, IsReciprocal) {
    for (const VirtualPreset& preset : virtual_presets()) {
        VirtualSettings settings;
        settings.width = settings.height = 12;
        settings.tilt_deg = 8;
        const VirtualSample sample = make_virtual_sample(preset.name, settings);
        Random random(14);
        int lit = 0;
        for (int i = 0; i < 200; ++i) {
            const VirtualTexel& texel = sample.at(random.below(12), random.below(12));
            const Vec3d wi = direction(random.uniform(0, 1.5), random.uniform(0, 7));
            const Vec3d wo = direction(random.uniform(0, 1.5), random.uniform(0, 7));
            const Vec3d there = virtual_brdf(sample, texel, wi, wo);
            const Vec3d back = virtual_brdf(sample, texel, wo, wi);
            for (std::size_t c = 0; c < 3; ++c) {
                EXPECT_NEAR(there[c], back[c], 1e-9 * there[c]) << preset.name;
                EXPECT_GE(there[c], 0) << preset.name;
            }
            lit += there[1] > 0;
        }
        EXPECT_GT(lit, 100) << preset.name;
    }
}

// Int rho (n.i) dw over half vectors: dw_i = 4 (o.h) dw_h. The nodes are dense in the lobe.
Vec3d albedo(const VirtualSample& sample, const VirtualTexel& texel, const Vec3d& wo) {
    Vec3d sum{};
    const int rings = 120, columns = 180;
    for (int r = 0; r < rings; ++r) {
        const double u = (r + 0.5) / rings, theta = kPi / 2 * u * u;
        const double dw = std::sin(theta) * kPi * u / rings * 2 * kPi / columns;
        for (int a = 0; a < columns; ++a) {
            const Vec3d h = direction(theta, 2 * kPi * (a + 0.5) / columns);
            const double oh = dot(wo, h);
            if (oh <= 0) continue;
            const Vec3d wi = {2 * oh * h[0] - wo[0], 2 * oh * h[1] - wo[1], 2 * oh * h[2] - wo[2]};
            if (wi[2] <= 1e-6) continue;
            const Vec3d rho = virtual_brdf(sample, texel, wi, wo);
            for (std::size_t c = 0; c < 3; ++c) sum[c] += rho[c] * wi[2] * 4 * oh * dw;
        }
    }
    return sum;
}

// The brightest texel of every distribution: the largest specular and the largest diffuse color of
// all texels of it.
std::vector<VirtualTexel> brightest_texels(const VirtualSample& sample) {
    std::vector<VirtualTexel> brightest(sample.ndfs.size());
    for (const VirtualTexel& texel : sample.texels) {
        VirtualTexel& most = brightest[static_cast<std::size_t>(texel.ndf)];
        most.ndf = texel.ndf;
        for (std::size_t c = 0; c < 3; ++c) {
            most.diffuse[c] = std::max(most.diffuse[c], texel.diffuse[c]);
            most.specular[c] = std::max(most.specular[c], texel.specular[c]);
        }
    }
    return brightest;
}

// A white furnace: no preset reflects more light than it receives, from any side and at angles up
// to 85 degrees.
TEST(VirtualBrdf, AlbedoOfPresetsIsAtMostOne) {
    for (const VirtualPreset& preset : virtual_presets()) {
        VirtualSettings settings;
        settings.width = settings.height = 48;
        const VirtualSample sample = make_virtual_sample(preset.name, settings);
        for (const VirtualTexel& texel : brightest_texels(sample)) {
            for (const double degrees : {0.0, 45.0, 75.0, 85.0}) {
                double most = 0, least = 1;
                for (int azimuth = 0; azimuth < 8; ++azimuth) {
                    const Vec3d wo = direction(degrees * kPi / 180, azimuth * kPi / 4);
                    for (const double a : albedo(sample, texel, wo)) {
                        most = std::max(most, a);
                        least = std::min(least, a);
                    }
                }
                // 0.005: error of the rule, as the lobes of mirrors have few nodes.
                EXPECT_LE(most, 1.005) << preset.name << " class " << texel.ndf << " " << degrees;
                EXPECT_GT(least, 0.005) << preset.name << " class " << texel.ndf << " " << degrees;
            }
        }
    }
}

// Facets of a mirror (specular 1, no Fresnel factor) without a lean lose only light that is
// shadowed or reflected below the horizon. Then g(k) >= k.z, and separable Smith never gains
// energy. Leaning lobes may gain: g(k) < k.z on the side away from their lean.
TEST(VirtualBrdf, FacetsNeitherGainNorLoseMuch) {
    const VirtualTexel mirror{0, 0, {0, 0, 0}, {1, 1, 1}, {0, 0, 1}};
    int upright = 0;
    for (const VirtualNdf& ndf : all_ndfs()) {
        bool leans = false;
        for (const VirtualLobe& l : ndf.lobes) leans |= l.lean_x != 0 || l.lean_y != 0;
        if (leans) continue;
        ++upright;
        const VirtualSample sample = plain(1, ndf, mirror, 0);
        for (const double degrees : {0.0, 40.0, 80.0}) {
            const double a = albedo(sample, mirror, direction(degrees * kPi / 180, 0.4))[0];
            // 2e-3: error of the rule; narrow lobes have few nodes.
            EXPECT_LE(a, 1.0 + 2e-3) << ndf.name << " " << degrees;
            EXPECT_GT(a, 0.5) << ndf.name << " " << degrees;
        }
    }
    EXPECT_GE(upright, 4);
    const VirtualNdf narrow{"narrow", {lobe(1, Mdf::beckmann, 0.08, 0.08, 0, 0, 0)}};
    const VirtualSample sample = plain(1, narrow, mirror, 0);
    EXPECT_NEAR(albedo(sample, mirror, direction(0.3, 0))[1], 1, 5e-3);
}

}  // namespace
}  // namespace burnish
