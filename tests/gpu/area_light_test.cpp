// Lights with an area on the device: shading against the same text on the CPU, soft shadows against their closed
// form, and lights that are seen themselves.
#include <array>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <memory>

#include "burnish/f32.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/renderer.hpp"
#include "gpu_fixture.hpp"
#include "scene/light/area_lights.hpp"
#include "scene/material/material_values.hpp"
#include "test_scene.hpp"

namespace burnish::test {
namespace {

constexpr int kSide = 32;

Light area_light(LightType type, glm::vec3 position, glm::vec3 target, glm::vec2 size) {
    Light light;
    light.type = type;
    light.position = position;
    light.direction = type == LightType::tube ? glm::normalize(glm::vec3(1, 0.3f, 0.2f))
                                              : glm::normalize(target - position);
    light.size = size;
    light.intensity = 2.0f;
    light.visible = false;
    return light;
}

// The plane [-1, 1]^2 from straight above.
Camera camera_above() {
    Camera camera;
    camera.position = {0, 0, 5};
    camera.orthographic = true;
    camera.ymag = 1.0f;
    return camera;
}

glm::vec3 place_of(int x, int y) {
    const float step = 2.0f / kSide;
    return {(static_cast<float>(x) + 0.5f) * step - 1, 1 - (static_cast<float>(y) + 0.5f) * step,
            0};
}

f32::vec3 of(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}

float expected(const Material& material, const Light& light, const glm::vec3& place) {
    const auto values = material_values<f32::SurfaceMaterial>(material);
    f32::SurfaceMaterial m =
        f32::surface_colored(values.surface, of(glm::vec3(material.base_color)), material.metallic);
    m.has_diffuse = true;
    const f32::vec3 wo(0, 0, 1);
    const f32::Perturbation p = f32::perturb_make(f32::kMethodNone, wo, true, false);
    const AreaAxes axes = area_axes(light);
    const int shape = static_cast<int>(light.type) - static_cast<int>(LightType::rectangle);
    const f32::AreaLight seen = f32::area_light_seen(shape, of(light.position - place), of(axes.x),
                                                     of(axes.y), light.two_sided);
    const f32::AreaReflection r =
        f32::area_reflection(m, p, f32::area_lobe(m, p, wo), seen, shape, wo);
    return (r.specular.x + r.diffuse.x) * light.intensity;
}

class AreaLightPixels : public GpuTest {
  protected:
    Image render(const Scene& scene, const RenderSettings& settings) {
        gpu::Renderer renderer(*context, scene, nullptr);
        return renderer.render(camera_above(), settings);
    }
};

TEST_F(AreaLightPixels, AreWhatTheTextSays) {
    struct Lobe {
        Brdf brdf;
        Mdf mdf;
    };
    constexpr std::array<Lobe, 5> kLobes = {{{Brdf::microfacet, Mdf::ggx},
                                             {Brdf::microfacet, Mdf::beckmann},
                                             {Brdf::microfacet_separable, Mdf::ward},
                                             {Brdf::ashikhmin_shirley, Mdf::ashikhmin_shirley},
                                             {Brdf::phong, Mdf::ggx}}};
    for (const Lobe& lobe : kLobes) {
        Scene scene = one_object(unit_plane(), Material{});
        Material& m = scene.materials[0];
        m.base_color = glm::vec4(0.7f, 0.5f, 0.3f, 1.0f);
        m.metallic = 0.25f;
        m.brdf = lobe.brdf;
        m.mdf = lobe.mdf;
        m.lobe = AlphaLobe{{0.1f, 0.35f}};
        m.single_scattering = true;
        for (const LightType type : {LightType::rectangle, LightType::disc, LightType::tube}) {
            // Partly below the plane.
            scene.lights = {area_light(type, {0.3f, 0.2f, 0.4f}, {-0.1f, 0, 0}, {1.2f, 0.5f})};
            for (const SurfacePass pass : {SurfacePass::forward, SurfacePass::deferred}) {
                RenderSettings o = small_picture(kSide, kSide);
                o.surface_pass = pass;
                const Image image = render(scene, o);
                double worst = 0;
                for (int y = 0; y < kSide; ++y)
                    for (int x = 0; x < kSide; ++x) {
                        const double cpu = static_cast<double>(
                            expected(scene.materials[0], scene.lights[0], place_of(x, y)));
                        const double gpu = static_cast<double>(image.at(x, y)[0]);
                        worst = std::max(worst, std::abs(gpu - cpu) / (0.01 + cpu));
                    }
                // The arcs of the device are good to 1e-4 relative to a quarter turn.
                EXPECT_LT(worst, 2e-3) << name_of(lobe.brdf) << " " << static_cast<int>(type);
            }
        }
    }
}

TEST_F(AreaLightPixels, ATextureIsWhatItSaysAndIsSeenInTheMirror) {
    Material mirror;
    mirror.lobe = AlphaLobe{{0.02f, 0.02f}};
    Scene scene = one_object(unit_plane(), mirror);
    Light light = area_light(LightType::rectangle, {0, 0, 1}, {0, 0, 0}, {2, 2});
    auto picture = std::make_shared<Image>(8, 8, 3, 0.5f);
    light.texture.image = picture;
    scene.lights = {light};
    const Image gray = render(scene, small_picture(kSide, kSide));
    scene.lights[0].texture.image = nullptr;
    const Image white = render(scene, small_picture(kSide, kSide));
    // Half floats hold 0.5.
    EXPECT_NEAR(gray.at(16, 16)[0], 0.5f * white.at(16, 16)[0], 1e-4f);
    // Its left half, seen from the front, is dark: the plane sees it on the side of +x, as u grows to its right.
    auto halves = std::make_shared<Image>(8, 8, 3, 0.0f);
    for (int y = 0; y < 8; ++y)
        for (int x = 4; x < 8; ++x)
            for (int c = 0; c < 3; ++c) halves->at(x, y)[c] = 1.0f;
    scene.lights[0].texture.image = halves;
    const Image half = render(scene, small_picture(kSide, kSide));
    const glm::vec3 right = area_axes(light).x;
    const int bright = right.x > 0 ? 24 : 7;
    EXPECT_NEAR(half.at(bright, 16)[0], white.at(bright, 16)[0], 0.02f * white.at(bright, 16)[0]);
    EXPECT_LT(half.at(31 - bright, 16)[0], 0.02f * white.at(31 - bright, 16)[0]);
}

// A light of width w at height H over an edge at x = 0 and height h: from x on the plane, the light's part with x_l
// above -x (H - h)/h is seen.
TEST_F(AreaLightPixels, APenumbraFallsAsTheLightIsHidden) {
    Material matt;
    matt.metallic = 0.0f;
    matt.lobe = AlphaLobe{{1.0f, 1.0f}};
    Scene scene = one_object(unit_plane(), matt);
    // The blocker covers x < 0 at z = h, far to all sides. It faces the light.
    constexpr float kEdge = 0.5f, kHeight = 2.0f, kWidth = 1.0f;
    Instance blocker;
    blocker.transform =
        glm::scale(glm::translate(glm::mat4(1.0f), glm::vec3(-3.0f, 0, kEdge)), glm::vec3(3.0f));
    scene.instances.push_back(blocker);
    scene.lights = {area_light(LightType::rectangle, {0, 0, kHeight}, {0, 0, 0}, {kWidth, 0.5f})};
    scene.lights[0].up = {0, 1, 0};
    RenderSettings o = small_picture(kSide, kSide, 256);
    const auto row = [&](bool shadows) {
        o.shadows = shadows;
        gpu::Renderer renderer(*context, scene, nullptr);
        Camera camera = camera_above();
        camera.position.z = 0.4f;  // below the blocker
        camera.near_plane = 0.01f;
        camera.far_plane = 10.0f;
        return renderer.render(camera, o);
    };
    const Image open = row(false), shadowed = row(true);
    for (int x = 0; x < kSide; ++x) {
        const float place = place_of(x, kSide / 2).x;
        const float hidden_below = -place * (kHeight - kEdge) / kEdge;
        const float seen = glm::clamp((0.5f * kWidth - hidden_below) / kWidth, 0.0f, 1.0f);
        const float ratio = shadowed.at(x, kSide / 2)[0] / open.at(x, kSide / 2)[0];
        // 256 points of the light, and a pixel is a fifth of the penumbra wide.
        EXPECT_NEAR(ratio, seen, 0.06f) << place;
    }
}

TEST_F(AreaLightPixels, ALightIsSeenFromTheSideThatEmits) {
    Scene scene = one_object(unit_plane(), Material{});
    for (const LightType type : {LightType::rectangle, LightType::disc, LightType::tube}) {
        Light light = area_light(type, {0, 0, 1}, {0, 0, 2}, {1.0f, 0.5f});
        if (type == LightType::tube) light.direction = {1, 0, 0};
        light.visible = true;
        light.color = {1.0f, 0.5f, 0.25f};
        scene.lights = {light};
        const auto seen = [&] { return rgb(render(scene, small_picture(kSide, kSide)), 16, 16); };
        EXPECT_EQ(seen(), glm::vec3(2.0f, 1.0f, 0.5f)) << static_cast<int>(type);
        scene.lights[0].visible = false;
        EXPECT_LT(seen().r, 1.0f);
        if (type == LightType::tube) continue;
        scene.lights[0].visible = true;
        scene.lights[0].direction = {0, 0, -1};
        const glm::vec3 behind = seen();
        EXPECT_NE(behind, glm::vec3(2.0f, 1.0f, 0.5f));
        scene.lights[0].two_sided = true;
        EXPECT_EQ(seen(), glm::vec3(2.0f, 1.0f, 0.5f));
    }
}

TEST_F(AreaLightPixels, MoreThanEightAreRefused) {
    Scene scene = one_object(unit_plane(), Material{});
    scene.lights.assign(9, area_light(LightType::disc, {0, 0, 1}, {0, 0, 0}, {1, 1}));
    EXPECT_THROW(gpu::Renderer(*context, scene, nullptr), Error);
}

}  // namespace
}  // namespace burnish::test
