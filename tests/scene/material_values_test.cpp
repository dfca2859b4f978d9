// The lobes that SurfacePoint does not take, and single against double precision.
#include "scene/material/material_values.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "burnish/tabulated_material.hpp"

namespace burnish {
namespace {

Material material_with(const MaterialLobe& lobe) {
    Material material;
    material.lobe = lobe;
    return material;
}

// Fibers in disorder add the variance of their slopes: 2 variance to alpha^2 of a Beckmann lobe.
TEST(MaterialValues, ClothIsWidenedByItsFuzzAndBringsItsColors) {
    Cloth cloth;
    cloth.alpha = {0.25f, 0.5f};
    cloth.fuzz = 0.125f;
    Material m = material_with(cloth);
    m.base_color = {0.5f, 0.25f, 0.125f, 1.0f};
    m.metallic = 0.0f;
    m.mdf = Mdf::beckmann;
    const auto v = material_values<f64::SurfaceMaterial>(m);
    EXPECT_NEAR(v.surface.lobe.p0, std::sqrt(0.0625 + 2 * 0.015625), 1e-9);
    EXPECT_NEAR(v.surface.lobe.p1, std::sqrt(0.25 + 2 * 0.015625), 1e-9);
    EXPECT_EQ(v.base_color.x, 1);
    EXPECT_EQ(v.base_color.z, 1);
    EXPECT_TRUE(v.surface.has_diffuse);
    EXPECT_TRUE(v.grooves_along_x);
}

TEST(MaterialValues, ATableIsReadUnderTheFresnelFactorOfItsIndex) {
    TabulatedMaterial table;
    table.eta = 1.5;
    // Metallic by default.
    Material m = material_with(Tabulated{std::make_shared<const TabulatedMaterial>(table), {}});
    m.conductor = Conductor{};
    const auto v = material_values<f64::SurfaceMaterial>(m);
    EXPECT_EQ(v.surface.brdf, f64::kBrdfTabulated);
    EXPECT_EQ(v.surface.fresnel, f64::kFresnelDielectric);
    EXPECT_EQ(v.surface.eta.x, 1.5);
    EXPECT_NEAR(v.surface.k.x, 25.0, 1e-9);  // ((1.5 + 1)/(1.5 - 1))^2
    EXPECT_TRUE(v.surface.has_diffuse);
    EXPECT_EQ(v.metallic, 0);
}

TEST(MaterialValues, SinglePrecisionRoundsDoublePrecision) {
    Material m = material_with(AlphaLobe{{0.12f, 0.43f}});
    m.base_color = {0.7f, 0.5f, 0.3f, 1.0f};
    m.metallic = 0.4f;
    m.brdf = Brdf::ashikhmin_shirley;
    m.anisotropy_rotation = 1.1f;
    m.method = Method::deform_smooth;
    m.conserve = true;
    const auto a = material_values<f32::SurfaceMaterial>(m);
    const auto b = material_values<f64::SurfaceMaterial>(m);
    const auto near = [](float found, double wanted) {
        // Four roundings of single precision.
        EXPECT_NEAR(static_cast<double>(found), wanted, 4 * 6e-8 * std::abs(wanted));
    };
    near(a.surface.lobe.p0, b.surface.lobe.p0);
    near(a.surface.lobe.p1, b.surface.lobe.p1);
    near(a.surface.lobe.paper_norm, b.surface.lobe.paper_norm);
    near(a.surface.lobe.projected_norm, b.surface.lobe.projected_norm);
    near(a.surface.specular.y, b.surface.specular.y);
    near(a.surface.diffuse.z, b.surface.diffuse.z);
    near(a.stretch.x, b.stretch.x);
    near(a.stretch.y, b.stretch.y);
    EXPECT_EQ(a.grooves_along_x, b.grooves_along_x);
    EXPECT_EQ(a.method, Method::deform_smooth);
    EXPECT_EQ(b.method, Method::deform_smooth);
    EXPECT_TRUE(a.conserve && b.conserve);
}

}  // namespace
}  // namespace burnish
