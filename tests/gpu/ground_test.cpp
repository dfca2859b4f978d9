// The ground's shadow against closed forms: rays to the plane, form factors of a disk.
#include "gpu/draw/ground.hpp"

#include <algorithm>
#include <cmath>

#include "burnish/render_settings.hpp"
#include "burnish/renderer.hpp"
#include "gpu_fixture.hpp"
#include "test_scene.hpp"

namespace burnish::test {
namespace {

TEST(Flattened, IsWhereTheRayMeetsThePlane) {
    const glm::vec3 p(0.3f, 1.2f, -0.7f);
    const float height = -0.5f;
    // Extends the ray from p to y = height.
    const glm::vec3 sun = glm::normalize(glm::vec3(1, 2, -0.5f));
    const glm::vec3 wanted_sun = p - sun * ((p.y - height) / sun.y);
    const glm::vec3 lamp(2, 3, 1);
    const glm::vec3 wanted_lamp = lamp + (p - lamp) * ((lamp.y - height) / (lamp.y - p.y));
    for (const auto& [light, wanted] :
         {std::pair{glm::vec4(sun, 0), wanted_sun}, std::pair{glm::vec4(lamp, 1), wanted_lamp}}) {
        const glm::vec4 found = gpu::flattened(light, height) * glm::vec4(p, 1);
        ASSERT_GT(found.w, 0);
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i] / found.w, wanted[i], 1e-5f);
    }
    EXPECT_LE((gpu::flattened(glm::vec4(lamp, 1), height) * glm::vec4(0, 3.5f, 0, 1)).w, 0);
}

TEST(SkyLights, GiveWhatTheUpperHalfGives) {
    // L = 1 + y / 2 above the horizon, bright below: Int L y dw = pi + pi/3.
    Environment e = constant_environment(glm::vec3(0), 256);
    for (int y = 0; y < e.radiance.height; ++y) {
        const float up = std::cos(kPiF * (static_cast<float>(y) + 0.5f) / 128.0f);
        for (int x = 0; x < e.radiance.width; ++x)
            for (int c = 0; c < 3; ++c)
                e.radiance.at(x, y)[c] = up > 0 ? (1 + 0.5f * up) * static_cast<float>(c + 1) : 99;
    }
    glm::vec3 sum(0.0f), mean(0.0f);
    for (const SkyLight& light : sky_lights(e, 256)) {
        EXPECT_NEAR(glm::length(light.direction), 1, 1e-5f);
        EXPECT_GT(light.direction.y, 0);
        sum += light.irradiance;
        mean += light.direction / 256.0f;
    }
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(sum[c], static_cast<float>(c + 1) * kPiF * 4 / 3, 0.005f * sum[c]);
    EXPECT_NEAR(mean.x, 0, 0.02f);
    EXPECT_NEAR(mean.z, 0, 0.02f);
    // The irradiance-weighted mean of y: Int L y^2 dw over Int L y dw.
    EXPECT_NEAR(mean.y, (2.0f / 3 + 0.25f) / (4.0f / 3), 0.005f);
}

// Directions as the camera sees them: -z is the middle of the picture. Rotated as in the shaders.
TEST(SkyLights, AreWhereTheEnvironmentIsBright) {
    Environment e = constant_environment(glm::vec3(0), 64);
    *e.radiance.at(16, 10) = 5;  // u = 1/4: towards -x
    for (const SkyLight& light : sky_lights(e, 16)) {
        EXPECT_LT(light.direction.x, -0.7f);
        EXPECT_NEAR(light.direction.z, 0, 0.1f);
    }
    EXPECT_TRUE(sky_lights(constant_environment(glm::vec3(0)), 16).empty());
    e.radiance.at(3, 3)[0] = std::nanf("");
    e.radiance.at(4, 3)[1] = -7;
    EXPECT_EQ(sky_lights(e, 16).size(), 16u);
}

Mesh disc(float radius, float height) {
    Mesh mesh = unit_plane();
    mesh.positions.clear();
    mesh.normals.clear();
    mesh.tangents.clear();
    mesh.texcoord0.clear();
    mesh.indices.clear();
    constexpr std::uint32_t kCorners = 256;
    for (std::uint32_t i = 0; i < kCorners; ++i) {
        const float a = 2 * kPiF * static_cast<float>(i) / kCorners;
        mesh.positions.emplace_back(radius * std::cos(a), height, -radius * std::sin(a));
        mesh.normals.emplace_back(0, 1, 0);
        mesh.tangents.emplace_back(1, 0, 0, 1);
        mesh.texcoord0.emplace_back(0, 0);
        if (i >= 2) mesh.indices.insert(mesh.indices.end(), {0, i - 1, i});
    }
    return mesh;
}

// A disk of radius 1 at height 1, and a small distant object that puts the ground at 0.
class GroundTest : public GpuTest {
  protected:
    Scene floating_disc() {
        Material m;
        m.double_sided = true;
        Scene scene = one_object(disc(1.0f, 1.0f), m);
        scene.meshes.push_back(disc(0.001f, 0.0f));
        for (glm::vec3& p : scene.meshes.back().positions) p.x += 2.5f;
        scene.instances.push_back({});
        scene.instances.back().mesh = 1;
        return scene;
    }

    // Coverage by the shadow at (x, 0, z), seen from below the disk without a background.
    float missing(const Scene& scene, const Environment* environment, glm::vec3 point,
                  float eye_height = 0.5f) {
        gpu::Renderer renderer(*context, scene, environment);
        Camera camera;
        camera.position = point + glm::vec3(0.4f, eye_height, 0.3f);
        camera.target = point;
        camera.yfov = 0.02f;
        RenderSettings options = small_picture(9, 9);
        options.background = BackgroundKind::transparent;
        options.ground = true;
        const Image image = renderer.render(camera, options);
        for (int c = 0; c < 3; ++c) EXPECT_EQ(image.at(4, 4)[c], 0.0f);
        return image.at(4, 4)[3];
    }
};

// Under a uniform sky the disk blocks the fraction R^2 / (R^2 + H^2) of the irradiance of the point
// below its center, and (1 - (r^2 + H^2 - R^2) / sqrt((r^2 + H^2 + R^2)^2 - 4 r^2 R^2)) / 2 at the
// distance r from that point.
TEST_F(GroundTest, AnEvenSkyIsHiddenByTheFormFactorOfTheDisc) {
    const Scene scene = floating_disc();
    const Environment sky = constant_environment(glm::vec3(3.0f));
    for (const float r : {0.0f, 0.5f, 1.0f, 1.5f}) {
        const double q = r * r + 1.0 + 1.0;
        const double wanted = 0.5 * (1 - (r * r + 1.0 - 1.0) / std::sqrt(q * q - 4 * r * r));
        EXPECT_NEAR(missing(scene, &sky, {0, 0, -r}), wanted, 0.012) << r;
    }
}

TEST_F(GroundTest, ALampsShadowIsWhereItsRaysEnd) {
    Scene scene = floating_disc();
    scene.lights.push_back(directional({1, 1, 0}, glm::vec3(2.0f)));
    // A light at 45 degrees and height 1: the shadow is the disk about (-1, 0, 0).
    EXPECT_NEAR(missing(scene, nullptr, {-1, 0, 0}), 1, 2e-3);
    EXPECT_NEAR(missing(scene, nullptr, {-0.1f, 0, 0}), 1, 2e-3);
    EXPECT_NEAR(missing(scene, nullptr, {0.1f, 0, 0}), 0, 2e-3);
    EXPECT_NEAR(missing(scene, nullptr, {-1, 0, 1.1f}), 0, 2e-3);
    // From (0, 2, 0) the disk at half that height casts a shadow of radius 2.
    scene.lights[0] = Light{};
    scene.lights[0].type = LightType::point;
    scene.lights[0].position = {0, 2, 0};
    EXPECT_NEAR(missing(scene, nullptr, {0, 0, -1.9f}), 1, 4e-3);  // one step of an 8-bit display
    EXPECT_NEAR(missing(scene, nullptr, {0, 0, -2.1f}), 0, 2e-3);
}

// Each light is a part of the irradiance: 3 cos 45 and 4 cos 0, of which the second is blocked.
TEST_F(GroundTest, LightsHideTheirShareOfAllLight) {
    Scene scene = floating_disc();
    scene.lights.push_back(directional({1, 1, 0}, glm::vec3(3.0f)));
    scene.lights.push_back(directional({0, 1, 0}, glm::vec3(4.0f)));
    EXPECT_NEAR(missing(scene, nullptr, {0.5f, 0, 0}), 4 / (4 + 3 * std::sqrt(0.5)), 3e-3);
}

TEST_F(GroundTest, IsNotSeenFromBelow) {
    const Environment sky = constant_environment(glm::vec3(1.0f));
    EXPECT_EQ(missing(floating_disc(), &sky, {0, 0, 0}, -0.5f), 0.0f);
}

// Multiplies the background by the remaining light; outside the shadow it is unchanged to the bit.
TEST_F(GroundTest, MultipliesTheBackground) {
    const Scene scene = floating_disc();
    const Environment sky = constant_environment(glm::vec3(1.0f));
    gpu::Renderer renderer(*context, scene, &sky);
    Camera camera;
    camera.position = {0.2f, 0.5f, 3.0f};
    camera.target = {0, 0, 0};
    RenderSettings options = small_picture(65, 49);
    options.background_color = {0.8f, 0.4f, 0.2f};
    const Image without = renderer.render(camera, options);
    options.ground = true;
    const Image with = renderer.render(camera, options);
    const glm::vec3 a = rgb(with, 32, 24), b = rgb(without, 32, 24);
    EXPECT_NEAR(a.x / b.x, 0.5, 0.015);
    EXPECT_NEAR(a.y / b.y, a.x / b.x, 1e-4);
    EXPECT_EQ(rgb(with, 0, 0), rgb(without, 0, 0));
    EXPECT_EQ(rgb(with, 60, 2), rgb(without, 60, 2));
}

}  // namespace
}  // namespace burnish::test
