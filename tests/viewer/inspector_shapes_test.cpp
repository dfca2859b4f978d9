// Shapes and albedos of the lobe inspector: against integrals.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "burnish/brdf_models.hpp"
#include "core/constants.hpp"
#include "models/albedo.hpp"
#include "viewer/inspect/inspector.hpp"
#include "viewer/viewer_scenes.hpp"

namespace burnish::viewer {
namespace {

LobeReport shaped_report(Mdf mdf, glm::vec2 alpha, std::span<const Method> methods) {
    Material m;
    m.mdf = mdf;
    m.lobe = AlphaLobe{alpha};
    m.anisotropy_rotation = 0.3f;
    m.base_color = {0.9f, 0.7f, 0.5f, 1.0f};
    const Scene scene = test::tilted_plane(m, {0.25, -0.15, 1.0});
    return inspect(scene, test::hit_at(scene, 0, 0), glm::normalize(glm::dvec3(0.3, 0.2, 1)),
                   glm::normalize(glm::dvec3(-0.5, 0.1, 1)), methods);
}

// Int D (n~.h) dw = 1 for rotations, which is Int D (n~.h)/h_z over the disk.
TEST(InspectorShapes, TheDiskHoldsTheDistribution) {
    const Method methods[] = {Method::rotate_exact, Method::follow_grain, Method::gram_schmidt};
    for (const Mdf mdf : {Mdf::ashikhmin_shirley, Mdf::ward, Mdf::beckmann}) {
        const LobeReport report = shaped_report(mdf, {0.2f, 0.3f}, methods);
        for (const MethodReport& m : report.methods) {
            const int side = m.disk.D.width;
            double sum = 0, most = 0;
            for (int y = 0; y < side; ++y) {
                for (int x = 0; x < side; ++x) {
                    const double hx = 2 * (x + 0.5) / side - 1, hy = 1 - 2 * (y + 0.5) / side;
                    const double r2 = hx * hx + hy * hy;
                    const float D = *m.disk.D.at(x, y);
                    ASSERT_EQ(std::isnan(D), !(r2 < 1));
                    if (!(r2 < 1)) continue;
                    const glm::dvec3 h(hx, hy, std::sqrt(1 - r2));
                    most = std::max(most, static_cast<double>(D));
                    sum += static_cast<double>(D) * glm::dot(m.normal, h) / h.z * 4 / (side * side);
                }
            }
            // One texel holds the peak itself: 1/65^2 of the square times a few.
            EXPECT_NEAR(sum, 1, 0.02) << name_of(m.method);
            EXPECT_NEAR(m.disk.most, most, 1e-6 * most);
            EXPECT_TRUE(m.disk.origin.empty());
        }
    }
}

TEST(InspectorShapes, ANarrowLobeIsNotLostBetweenTexels) {
    const Method methods[] = {Method::follow_grain, Method::none, Method::normal_map};
    const LobeReport report = shaped_report(Mdf::ggx, {0.002f, 0.004f}, methods);
    for (const MethodReport& m : report.methods) {
        float most = 0;
        for (const float D : m.disk.D.pixels) most = std::max(most, std::isnan(D) ? 0.0f : D);
        // 1/(pi ax ay) = 40,000; of normal-map at the geometric normal, n~z^-4 more.
        EXPECT_GT(most, 30000.0f) << name_of(m.method);
        EXPECT_NEAR(m.disk.most, static_cast<double>(most), 1e-3 * m.disk.most);
        EXPECT_GT(m.mesh.most, 100.0) << name_of(m.method);
        EXPECT_GT(m.cuts.most, 100.0);
    }
}

TEST(InspectorShapes, TheMeshIsTheLobe) {
    const Method methods[] = {Method::follow_grain};
    const LobeReport report = shaped_report(Mdf::ggx, {0.2f, 0.3f}, methods);
    const MethodReport& m = report.methods[0];
    ASSERT_EQ(m.mesh.vertices.size(), 64u * 128u);
    double volume = 0;
    for (std::size_t i = 0; i < m.mesh.triangles.size(); i += 3) {
        const glm::dvec3 a(m.mesh.vertices[m.mesh.triangles[i]]);
        const glm::dvec3 b(m.mesh.vertices[m.mesh.triangles[i + 1]]);
        const glm::dvec3 c(m.mesh.vertices[m.mesh.triangles[i + 2]]);
        volume += glm::dot(a, glm::cross(b, c)) / 6;
    }
    // Int r^3/3 dw over the sphere of directions to the eye, by the midpoint rule.
    double wanted = 0;
    constexpr int kRows = 400, kColumns = 800;
    for (int i = 0; i < kRows; ++i) {
        for (int j = 0; j < kColumns; ++j) {
            const double z = (i + 0.5) / kRows, phi = 2 * kPi * j / kColumns;
            const double s = std::sqrt(1 - z * z);
            const glm::dvec3 f =
                m.lobe.eval_cos(report.to_light, {s * std::cos(phi), s * std::sin(phi), z});
            const double r = 0.2126 * f.x + 0.7152 * f.y + 0.0722 * f.z;
            wanted += r * r * r / 3 * 2 * kPi / (kRows * kColumns);
        }
    }
    // Flat triangles cut off up to 2 % of so pointed a shape.
    EXPECT_NEAR(volume, wanted, 0.03 * wanted);
    double most = 0;
    for (const glm::vec3& v : m.mesh.vertices)
        most = std::max(most, static_cast<double>(glm::length(v)));
    EXPECT_NEAR(m.mesh.most, most, 1e-5 * most);
}

TEST(InspectorShapes, CutsAreRadiiOfTheLobe) {
    const Method methods[] = {Method::follow_grain};
    const LobeReport report = shaped_report(Mdf::ggx, {0.1f, 0.3f}, methods);
    const MethodReport& m = report.methods[0];
    const glm::dvec3 n = m.normal;
    const glm::dvec3 beside = glm::normalize(report.to_light - n * glm::dot(n, report.to_light));
    double most = 0, angle_of_most = 0, last = -10;
    for (const PolarPoint& p : m.cuts.incidence) {
        ASSERT_GE(p.angle_rad, last);
        last = p.angle_rad;
        const glm::dvec3 d = n * std::cos(p.angle_rad) - beside * std::sin(p.angle_rad);
        const glm::dvec3 f = m.lobe.eval_cos(report.to_light, d);
        EXPECT_NEAR(p.radius, 0.2126 * f.x + 0.7152 * f.y + 0.0722 * f.z, 1e-4 * (p.radius + 1e-6));
        if (p.radius > most) {
            most = p.radius;
            angle_of_most = p.angle_rad;
        }
    }
    EXPECT_NEAR(m.cuts.light_angle_rad, -std::acos(glm::dot(n, report.to_light)), 1e-12);
    // The light is mirrored about n~; off-specular shift moves the peak outwards by less than a width.
    EXPECT_NEAR(angle_of_most, -m.cuts.light_angle_rad, 0.1);
    double across = 0;
    for (const PolarPoint& p : m.cuts.across) across = std::max(across, p.radius);
    EXPECT_NEAR(m.cuts.most, std::max(most, across), 1e-12);
}

TEST(InspectorAlbedo, IsThatOfTheModelByQuadrature) {
    for (const double elevation : {80.0, 45.0, 20.0}) {
        Material m;
        m.single_scattering = true;
        m.lobe = AlphaLobe{{0.3f, 0.5f}};
        m.base_color = glm::vec4(1.0f);
        const Scene scene = test::one_object(test::unit_plane(), m);
        const double e = elevation * kPi / 180;
        const glm::dvec3 eye(std::cos(e), 0, std::sin(e));
        const PointLobe lobe(surface_at(scene, test::hit_at(scene, 0, 0), eye), Method::none);
        const LobeAlbedo albedo = lobe_albedo(lobe, eye);
        const double p[] = {double{0.3f}, double{0.5f}, 1.0, 0.0, 0.0};
        const double wanted = directional_albedo(microfacet_model(Mdf::ggx, Smith::correlated), p,
                                                 {eye.x, eye.y, eye.z});
        EXPECT_NEAR(albedo.specular.x, wanted, 0.003) << elevation;
        EXPECT_LT(albedo.error, 0.005);
        EXPECT_NEAR(albedo.whole.x, wanted, 3 * albedo.error + 0.002);
        EXPECT_FALSE(albedo.gains_energy);
    }
}

TEST(InspectorAlbedo, HoldsTheDiffuseTermAndFindsGains) {
    Material m;
    m.metallic = 0.0f;
    m.base_color = {0.5f, 0.25f, 1.0f, 1.0f};
    m.lobe = AlphaLobe{{0.6f, 0.6f}};
    const Scene scene = test::one_object(test::unit_plane(), m);
    const glm::dvec3 eye = glm::normalize(glm::dvec3(0.5, 0, 1));
    const Hit hit = test::hit_at(scene, 0, 0);
    const PointLobe lobe(surface_at(scene, hit, eye), Method::none);
    const LobeAlbedo albedo = lobe_albedo(lobe, eye);
    for (int c = 0; c < 3; ++c) {
        const double diffuse = m.base_color[c] * f64::diffuse_albedo(0, 0.04, eye.z);
        EXPECT_NEAR(albedo.whole[c], albedo.specular[c] + diffuse, 4 * albedo.error + 0.002);
    }
    EXPECT_FALSE(albedo.gains_energy);
    // Phong with ten times the scale that conserves its energy.
    m.brdf = Brdf::phong;
    m.metallic = 1.0f;
    m.ks = 10.0f;
    const Scene bright = test::one_object(test::unit_plane(), m);
    EXPECT_TRUE(
        lobe_albedo(PointLobe(surface_at(bright, hit, eye), Method::none), eye).gains_energy);
}

}  // namespace
}  // namespace burnish::viewer
