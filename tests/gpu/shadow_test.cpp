// Shadows of punctual lights: at their geometric positions, and nowhere else.
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "burnish/render_settings.hpp"
#include "burnish/renderer.hpp"
#include "gpu_fixture.hpp"
#include "test_scene.hpp"

namespace burnish::test {
namespace {

// A plate of half side 2 in z = 0 under a square of half side 0.25 at z = 0.5, seen from above
// through an orthographic camera of half height 2.
Scene plate_and_blocker() {
    Material matt;
    matt.lobe = AlphaLobe{{0.8f, 0.8f}};
    Scene scene = one_object(unit_plane(), matt);
    scene.instances[0].transform = glm::scale(glm::mat4(1.0f), glm::vec3(2.0f));
    Instance blocker;
    blocker.transform =
        glm::scale(glm::translate(glm::mat4(1.0f), glm::vec3(0, 0, 0.5f)), glm::vec3(0.25f));
    scene.instances.push_back(blocker);
    return scene;
}

constexpr int kSide = 128;

class Shadows : public GpuTest {
  protected:
    Image render(const Scene& scene, bool shadows, int samples = 1,
                 SurfacePass pass = SurfacePass::automatic) {
        gpu::Renderer renderer(*context, scene, nullptr);
        Camera camera;
        camera.position = {0, 0, 5};
        camera.orthographic = true;
        camera.ymag = 2.0f;
        RenderSettings o = small_picture(kSide, kSide, samples);
        o.shadows = shadows;
        o.surface_pass = pass;
        return renderer.render(camera, o);
    }

    // The box of the pixels that a shadow darkens by more than half, in world coordinates.
    static glm::vec4 darkened(const Image& lit, const Image& shadowed) {
        int low_x = kSide, high_x = 0, low_y = kSide, high_y = 0;
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                // No light to be shadowed outside the cone of a spot.
                if (lit.at(x, y)[0] < 1e-4f) continue;
                if (shadowed.at(x, y)[0] > 0.5f * lit.at(x, y)[0]) continue;
                low_x = std::min(low_x, x);
                high_x = std::max(high_x, x + 1);
                low_y = std::min(low_y, y);
                high_y = std::max(high_y, y + 1);
            }
        }
        const auto world = [](int p) { return 4.0f * static_cast<float>(p) / kSide - 2.0f; };
        return {world(low_x), world(high_x), -world(high_y), -world(low_y)};
    }

    void expect_shadow(Scene scene, const Light& light, glm::vec4 box) {
        scene.lights = {light};
        const Image lit = render(scene, false);
        for (const auto pass : {SurfacePass::forward, SurfacePass::deferred}) {
            const glm::vec4 found = darkened(lit, render(scene, true, 1, pass));
            // A pixel is 0.031 wide.
            for (int i = 0; i < 4; ++i) EXPECT_NEAR(found[i], box[i], 0.035) << i;
        }
    }
};

TEST_F(Shadows, OfADirectionalLightFallAside) {
    // Light from (1, 0, 1): the shadow of the square at z = 0.5 lies 0.5 to the left.
    expect_shadow(plate_and_blocker(), directional({1, 0, 1}), {-0.75f, -0.25f, -0.25f, 0.25f});
}

Light lamp(LightType type) {
    Light light;
    light.type = type;
    light.position = {1.5f, 0, 2};
    light.direction = glm::normalize(glm::vec3(-1.0f, 0, -1));
    light.intensity = 10.0f;
    light.inner_cone = 0.8f;
    light.outer_cone = 1.0f;
    return light;
}

// From (1.5, 0, 2) the square at z = 0.5 is projected on z = 0 with a scale of 4/3: x to 1.5 + (x -
// 1.5) 4/3.
TEST_F(Shadows, OfPointLightsAndSpotsGrow) {
    const glm::vec4 box(-0.8333f, -0.1667f, -0.3333f, 0.3333f);
    expect_shadow(plate_and_blocker(), lamp(LightType::point), box);
    expect_shadow(plate_and_blocker(), lamp(LightType::spot), box);
}

TEST_F(Shadows, LeaveLitPixelsAlone) {
    Scene scene = plate_and_blocker();
    scene.lights = {directional({1, 0, 1})};
    const Image lit = render(scene, false), shadowed = render(scene, true, 4);
    int same = 0;
    for (std::size_t i = 0; i < lit.pixels.size(); i += 4) {
        EXPECT_LE(shadowed.pixels[i], lit.pixels[i] * 1.001f + 1e-6f);
        same += std::abs(shadowed.pixels[i] - lit.pixels[i]) < 1e-3f * lit.pixels[i] ? 1 : 0;
    }
    // The shadow has 0.25 of 16 square meters. The pixel filter widens its edge, 64 pixels long, to
    // about four pixels.
    EXPECT_GT(same, static_cast<int>(0.96 * kSide * kSide));
}

// Light at 80 degrees to the view: no acne where the light is more than 6 degrees above the
// surface. Below that, triangles face away from the light before their interpolated normals do.
TEST_F(Shadows, ASphereDoesNotShadowItsLitSide) {
    Material matt;
    matt.lobe = AlphaLobe{{0.6f, 0.6f}};
    Scene scene = one_object(uv_sphere(128, 64), matt);
    const float a = 80.0f * kPiF / 180.0f;
    const glm::vec3 towards(std::sin(a), 0, std::cos(a));
    Light point = lamp(LightType::point);
    point.position = 4.0f * towards;
    for (const Light& light : {directional(towards), point}) {
        scene.lights = {light};
        const Image lit = render(scene, false), shadowed = render(scene, true);
        int seen = 0;
        for (int y = 0; y < kSide; ++y) {
            for (int x = 0; x < kSide; ++x) {
                const float nx = 4 * (static_cast<float>(x) + 0.5f) / kSide - 2;
                const float ny = 2 - 4 * (static_cast<float>(y) + 0.5f) / kSide;
                if (nx * nx + ny * ny > 0.98f) continue;
                const glm::vec3 n(nx, ny, std::sqrt(1 - nx * nx - ny * ny));
                const glm::vec3 wi =
                    light.type == LightType::point ? glm::normalize(light.position - n) : towards;
                if (glm::dot(n, wi) < 0.1f) continue;
                ++seen;
                EXPECT_NEAR(shadowed.at(x, y)[0], lit.at(x, y)[0], 1e-3f * lit.at(x, y)[0] + 1e-6f);
            }
        }
        EXPECT_GT(seen, 1000);
    }
}

// With more lights than maps, the last lights cast no shadow, and nothing fails.
TEST_F(Shadows, ManyLightsOfEveryKindRender) {
    Scene scene = plate_and_blocker();
    for (int i = 0; i < 16; ++i) {
        Light light = lamp(i % 3 == 0   ? LightType::point
                           : i % 3 == 1 ? LightType::spot
                                        : LightType::directional);
        light.position.y = 0.1f * static_cast<float>(i);
        scene.lights.push_back(light);
    }
    for (const float v : render(scene, true, 2).pixels) ASSERT_TRUE(std::isfinite(v));
}

}  // namespace
}  // namespace burnish::test
