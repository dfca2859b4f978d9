#include "reference/path_tracer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "burnish/surface.hpp"
#include "gpu/test_scene.hpp"
#include "reference/surfaces.hpp"

namespace burnish {
namespace {

// A view of the plane z = 0 so narrow that all of it is one place, from 4 m at this slant.
Camera narrow_view(glm::vec3 from) {
    Camera camera;
    camera.position = 4.0f * glm::normalize(from);
    camera.yfov = 1e-3f;
    return camera;
}

RenderSettings one_pixel() {
    RenderSettings settings;
    settings.width = settings.height = 1;
    settings.background = BackgroundKind::color;
    settings.background_color = glm::vec3(0.0f);
    return settings;
}

glm::dvec3 mean_of(const PathTracer& tracer, std::uint32_t samples) {
    glm::dvec3 sum(0.0);
    for (std::uint32_t i = 0; i < samples; ++i) sum += glm::dvec3(tracer.sample(0, 0, i).radiance);
    return sum / static_cast<double>(samples);
}

// Lambert and the lobe under a lamp: f cos I / d^2 by hand.
TEST(PathTracer, LightsAPlaneByAPointAsTheClosedFormSays) {
    const glm::vec3 eye(0.5f, -0.3f, 1.0f);
    for (const Material& material : {test::matte({0.2f, 0.5f, 0.8f}), test::rough_metal()}) {
        Scene scene = test::one_object(test::unit_plane(), material);
        Light light;
        light.type = LightType::point;
        light.position = {0.6f, 0.9f, 1.5f};
        light.intensity = 7.0f;
        scene.lights.push_back(light);
        const PathTracer tracer(scene, {}, narrow_view(eye), one_pixel(), 4);
        const glm::dvec3 to_light(light.position);
        const double distance2 = glm::dot(to_light, to_light);
        const SurfacePoint exact(material);
        const glm::dvec3 expected =
            exact.eval_cos(glm::normalize(to_light), glm::normalize(glm::dvec3(eye))) *
            (7.0 / distance2);
        const glm::dvec3 mean = mean_of(tracer, 64);
        // A pixel is 4 mm wide: the light changes by 0.3 % over it, and its mean by a tenth of that.
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c] / expected[c], 1.0, 1e-3);
        if (material.metallic == 0.0f) {
            const double lambert =
                0.5 / std::numbers::pi * 7.0 / distance2 * to_light.z / std::sqrt(distance2);
            EXPECT_NEAR(mean.y / lambert, 1.0, 1e-3);
        }
    }
}

TEST(PathTracer, FindsTheShadowOfALamp) {
    Scene scene = test::one_object(test::unit_plane(), test::matte(glm::vec3(0.5f)));
    Instance lid;
    lid.transform = glm::mat4(0.1f);
    lid.transform[3] = glm::vec4(0.3f, 0.45f, 0.75f, 1.0f);  // half way to the lamp
    scene.instances.push_back(lid);
    Light light;
    light.type = LightType::point;
    light.position = {0.6f, 0.9f, 1.5f};
    scene.lights.push_back(light);
    const PathTracer shaded(scene, {}, narrow_view({0.5f, -0.3f, 1.0f}), one_pixel(), 0);
    EXPECT_EQ(mean_of(shaded, 16), glm::dvec3(0.0));
    RenderSettings without = one_pixel();
    without.shadows = false;
    const PathTracer open(scene, {}, narrow_view({0.5f, -0.3f, 1.0f}), without, 0);
    EXPECT_GT(mean_of(open, 16).x, 0.01);
}

// In a white furnace a surface that absorbs nothing is invisible. The compensated models are within 1 %
// (tests/models/albedo_table_test.cpp), Lambert exactly.
TEST(PathTracer, IsWhiteInAWhiteFurnace) {
    const Environment white = test::constant_environment(glm::vec3(1.0f));
    for (const Method method : {Method::none, Method::follow_grain, Method::rotate_arc}) {
        Material mirror = test::rough_metal({0.3f, 0.5f});
        mirror.base_color = glm::vec4(1.0f);
        mirror.method = method;
        const Scene scene = test::one_object(test::unit_plane(), mirror);
        const PathTracer metal(scene, white, narrow_view({0.5f, -0.3f, 1.0f}), one_pixel(), 4);
        EXPECT_NEAR(mean_of(metal, 4096).y, 1.0, 0.015);
    }
    const Scene plane = test::one_object(test::unit_plane(), test::matte(glm::vec3(1.0f)));
    const PathTracer lambert(plane, white, narrow_view({0.5f, -0.3f, 1.0f}), one_pixel(), 4);
    EXPECT_NEAR(mean_of(lambert, 4096).y, 1.0, 0.005);
}

// Inside of a sphere that emits 1 and reflects half: 1 + 1/2 + 1/4 ... as often as reflections are allowed.
TEST(PathTracer, AddsUpReflectionsBetweenSurfaces) {
    Material glow = test::matte(glm::vec3(0.5f));
    glow.emissive = glm::vec3(1.0f);
    glow.double_sided = true;
    const Scene sphere = test::one_object(test::uv_sphere(96, 48), glow);
    Camera inside;
    inside.position = {0.1f, 0.05f, 0.2f};
    inside.target = {0.4f, 0.3f, -1.0f};
    double expected = 0.0;
    for (int reflections = 0; reflections < 8; ++reflections) {
        expected += std::pow(0.5, reflections);
        const PathTracer tracer(sphere, {}, inside, one_pixel(), reflections);
        // Below the fourth reflection all paths are alike; from there on they end by chance. Draws below the plane of
        // a triangle that the interpolated normal allows lose 0.1 %.
        EXPECT_NEAR(mean_of(tracer, 4096).x, expected, 0.01) << reflections;
    }
}

TEST(PathTracer, SeesWhatLiesBehindBackFacesAndHoles) {
    Scene scene = test::one_object(test::unit_plane(), test::matte(glm::vec3(0.5f)));
    RenderSettings settings = one_pixel();
    settings.background_color = {0.1f, 0.2f, 0.3f};
    const PathTracer behind(scene, {}, narrow_view({0.0f, 0.1f, -1.0f}), settings, 0);
    EXPECT_NEAR(mean_of(behind, 4).z, 0.3, 1e-6);
    scene.materials[0].alpha_mode = AlphaMode::mask;
    scene.materials[0].base_color.a = 0.2f;
    const PathTracer hole(scene, {}, narrow_view({0.0f, 0.1f, 1.0f}), settings, 0);
    EXPECT_NEAR(mean_of(hole, 4).z, 0.3, 1e-6);
    scene.materials[0].alpha_mode = AlphaMode::blend;
    settings.background = BackgroundKind::transparent;
    const PathTracer blended(scene, {}, narrow_view({0.0f, 0.1f, 1.0f}), settings, 0);
    double coverage = 0.0;
    for (std::uint32_t i = 0; i < 1000; ++i)
        coverage += static_cast<double>(blended.sample(0, 0, i).coverage) / 1000.0;
    EXPECT_NEAR(coverage, 0.2, 0.01);  // stratified
}

TEST(PathTracer, TellsNormalGrainAlbedoAndDepthOfTheFirstSurface) {
    Material m = test::rough_metal({0.1f, 0.5f});
    m.anisotropy_rotation = 0.0f;
    const Scene scene = test::one_object(test::unit_plane(), m);
    const PathTracer tracer(scene, {}, narrow_view({0.0f, 0.0f, 1.0f}), one_pixel(), 0, true);
    const PathSample sample = tracer.sample(0, 0, 3);
    EXPECT_TRUE(sample.meets_surface);
    EXPECT_NEAR(sample.normal.z, 1.0f, 1e-5f);
    EXPECT_NEAR(std::abs(sample.grain.x), 1.0f, 1e-5f);
    EXPECT_NEAR(sample.depth, 4.0f, 1e-3f);
    double albedo = 0.0;
    for (std::uint32_t i = 0; i < 1024; ++i)
        albedo += static_cast<double>(tracer.sample(0, 0, i).albedo.x) / 1024.0;
    EXPECT_NEAR(albedo, 0.9, 0.02);  // the color, as the model is compensated
}

}  // namespace
}  // namespace burnish
