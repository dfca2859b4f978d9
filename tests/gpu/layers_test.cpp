// Coat, sheen and specular factors in drawn pixels, against the CPU's text; under lights and under the environment.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>

#include "burnish/draft.hpp"
#include "burnish/environments.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/renderer.hpp"
#include "burnish/surface.hpp"
#include "gpu_fixture.hpp"
#include "models/albedo_table.hpp"
#include "scene/material/material_values.hpp"
#include "tabulated_scenes.hpp"
#include "test_scene.hpp"

namespace burnish::test {
namespace {

using f32::vec3;

const glm::vec3 kTowardsLight(0.5f, 0.1f, 1.0f);
const glm::vec3 kBaseNormal = glm::normalize(glm::vec3(0.25f, -0.15f, 1.0f));
const glm::vec3 kCoatNormal = glm::normalize(glm::vec3(-0.1f, 0.2f, 1.0f));

Material brushed(Method method) {
    Material m;
    m.base_color = glm::vec4(0.7f, 0.5f, 0.3f, 1.0f);
    m.metallic = 0.5f;
    m.single_scattering = true;
    m.method = method;
    m.lobe = AlphaLobe{{0.2f, 0.45f}};
    m.anisotropy_rotation = 0.4f;
    m.normal_texture.texture = 0;
    m.normal_filter = NormalFilter::mips;
    return m;
}

Material layered(Material m) {
    m.coat.strength = 0.8f;
    m.coat.roughness = 0.35f;
    m.coat.tint = {0.9f, 0.6f, 0.3f};
    m.coat.normal_texture.texture = 1;
    m.sheen.color = {0.3f, 0.2f, 0.4f};
    m.sheen.roughness = 0.5f;
    m.specular = 0.7f;
    m.specular_color = {2.0f, 1.0f, 0.5f};
    return m;
}

Scene plane_of(const Material& m) {
    Scene scene = one_object(unit_plane(), m);
    scene.textures.push_back(constant_texture(0.5f * kBaseNormal + 0.5f));
    scene.textures.push_back(constant_texture(0.5f * kCoatNormal + 0.5f));
    return scene;
}

vec3 of(glm::vec3 v) {
    return {v.x, v.y, v.z};
}

// What the CPU says of a point of the plane; `n_coat` none: the geometric normal.
vec3 expected(const Material& m, vec3 wi, vec3 wo, bool bumped_coat) {
    const auto values = material_values<f32::SurfaceMaterial>(m);
    const vec3 turned_wi = f32::seen_from_rotated(wi, values.stretch);
    const vec3 turned_wo = f32::seen_from_rotated(wo, values.stretch);
    const f32::Perturbation p =
        f32::surface_perturbation(static_cast<int>(values.method), of(kBaseNormal), values.stretch,
                                  values.grooves_along_x, values.conserve, turned_wo);
    f32::SurfaceLayers layers = values.layers;
    if (bumped_coat && layers.coat.present)
        layers.coat = f32::coat_turned(
            layers.coat,
            f32::normal_facing(f32::seen_from_rotated(of(kCoatNormal), values.stretch), turned_wo));
    return f32::layered_eval(values.surface, layers, p, turned_wi, turned_wo);
}

class LayerPixels : public GpuTest {
  protected:
    double worst_error(const Material& m, bool bumped_coat) {
        Scene scene = plane_of(m);
        scene.lights.push_back(directional(kTowardsLight));
        const Camera camera = camera_on_z(3.0f);
        RenderSettings o = small_picture(16, 16);
        o.surface_pass = SurfacePass::forward;
        gpu::Renderer renderer(*context, scene, nullptr);
        const Image image = renderer.render(camera, o);
        const double half = std::tan(0.5 * double{camera.yfov}) * double{camera.position.z};
        const vec3 wi = of(glm::normalize(kTowardsLight));
        double worst = 0;
        for (const int y : {1, 5, 8, 14})
            for (const int x : {2, 6, 9, 13}) {
                const vec3 at(static_cast<float>(half * ((x + 0.5) / 8 - 1)),
                              static_cast<float>(half * (1 - (y + 0.5) / 8)), 0.0f);
                const vec3 wo = f32::normalize(vec3(0, 0, 3) - at);
                const vec3 f = expected(m, wi, wo, bumped_coat);
                const float wanted[] = {f.x, f.y, f.z};
                for (int c = 0; c < 3; ++c)
                    worst = std::max(worst, double{std::abs(image.at(x, y)[c] - wanted[c])} /
                                                (double{std::abs(wanted[c])} + 0.01));
            }
        if (std::getenv("BURNISH_PRINT_PARITY") != nullptr) std::printf("layers %.1e\n", worst);
        return worst;
    }
};

// Relative, plus 0.01 absolute. Measured on llvmpipe: 7.5e-7; processors have powers and exponentials of their own.
constexpr double kLayerBound = 5e-6;

TEST_F(LayerPixels, AreThoseOfTheCpuUnderEveryMethod) {
    for (int method = 0; method < static_cast<int>(method_names().size()); ++method) {
        const Material m = layered(brushed(static_cast<Method>(method)));
        EXPECT_LT(worst_error(m, true), kLayerBound) << name_of(m.method);
    }
}

TEST_F(LayerPixels, ACoatWithoutAMapHasTheGeometricNormal) {
    Material m = layered(brushed(Method::follow_grain));
    m.sheen = {};
    m.coat.normal_texture = {};
    EXPECT_LT(worst_error(m, false), kLayerBound);
    m.coat.tint = glm::vec3(1.0f);
    EXPECT_LT(worst_error(m, false), kLayerBound);
}

TEST_F(LayerPixels, SheenAndSpecularFactorsAlone) {
    Material m = layered(brushed(Method::follow_grain));
    m.coat = {};
    EXPECT_LT(worst_error(m, false), kLayerBound);
    m.sheen = {};
    EXPECT_LT(worst_error(m, false), kLayerBound);
}

// A texel of every map scales its factor.
TEST_F(LayerPixels, TexturesScaleTheirFactors) {
    Material m = layered(brushed(Method::follow_grain));
    m.coat.normal_texture = {};
    Material scaled = m;
    for (TextureUse* use : {&m.coat.texture, &m.coat.roughness_texture, &m.sheen.color_texture,
                            &m.specular_color_texture})
        use->texture = 2;
    scaled.coat.strength *= 0.5f;
    scaled.coat.roughness *= 0.25f;
    scaled.sheen.color *= glm::vec3(0.5f, 0.25f, 0.75f);
    scaled.specular_color *= glm::vec3(0.5f, 0.25f, 0.75f);
    const auto render = [&](const Material& material) {
        Scene scene = plane_of(material);
        scene.textures.push_back(constant_texture(glm::vec3(0.5f, 0.25f, 0.75f)));
        scene.lights.push_back(directional(kTowardsLight));
        gpu::Renderer renderer(*context, scene, nullptr);
        return renderer.render(camera_on_z(3.0f), small_picture(16, 16));
    };
    const Image with_maps = render(m), with_factors = render(scaled);
    for (const int at : {3, 8, 12})
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(with_maps.at(at, at)[c], with_factors.at(at, at)[c],
                        1e-3f * (0.01f + with_factors.at(at, at)[c]));
}

// Light that the surface emits goes through the coat once, along the refracted way.
TEST_F(LayerPixels, ACoatDimsWhatGlowsBelowIt) {
    Material m = layered(brushed(Method::none));
    m.normal_texture = m.coat.normal_texture = {};
    m.emissive = {2.0f, 2.0f, 2.0f};
    gpu::Renderer renderer(*context, plane_of(m), nullptr);
    const Image image = renderer.render(camera_on_z(3.0f), small_picture(8, 8));
    const auto values = material_values<f32::SurfaceMaterial>(m);
    const float half = std::tan(0.5f * camera_on_z(3.0f).yfov) * 3.0f;
    const vec3 at(half * (4.5f / 4 - 1), half * (1 - 4.5f / 4), 0.0f);
    const vec3 wo = f32::normalize(vec3(0, 0, 3) - at);
    const vec3 left =
        f32::coat_share(values.layers.coat, f32::coat_seen(values.layers.coat, wo).through);
    EXPECT_NEAR(image.at(4, 4)[0], 2 * left.x, 1e-4);
    EXPECT_NEAR(image.at(4, 4)[2], 2 * left.z, 1e-4);
    EXPECT_LT(left.z, 0.85f * left.x) << "the tint";
}

// In a white furnace the picture of the albedo is Int f cos, which the CPU integrates by its own samples. Half floats
// of the albedo table, 1,024 samples of a pixel: 0.01.
TEST_F(LayerPixels, TheAlbedoIsThatOfTheCpu) {
    Material m = layered(brushed(Method::none));
    m.normal_texture = m.coat.normal_texture = {};
    m.single_scattering = false;
    for (const bool coat : {false, true}) {
        if (!coat)
            m.coat = {};
        else
            m = layered(m), m.coat.normal_texture = {};
        Scene scene = plane_of(m);
        const Environment white = constant_environment(glm::vec3(1.0f));
        RenderSettings o = small_picture(8, 8, 4);
        o.view = SurfaceView::albedo;
        o.image_light_samples = 256;
        gpu::Renderer renderer(*context, scene, &white);
        const Image image = renderer.render(camera_on_z(3.0f), o);
        const SurfacePoint point(m);
        glm::dvec3 sum(0.0);
        constexpr int kSamples = 1 << 15;
        for (int i = 0; i < kSamples; ++i) {
            const auto s = point.sample(
                {0, 0, 1}, {(i + 0.5) / kSamples, std::fmod(0.5 + 0.7548776662466927 * i, 1.0),
                            std::fmod(0.5 + 0.5698402909980532 * i, 1.0)});
            if (s) sum += s->weight;
        }
        // The pixel beside the middle is seen within 5 degrees of the normal. The picture is a gray whose encoded
        // value is the albedo of the channel that reflects most.
        const double most = std::max({sum.x, sum.y, sum.z}) / kSamples;
        EXPECT_NEAR(f64::srgb_from_linear(double{image.at(4, 4)[0]}), most, 0.012) << coat;
    }
}

double rms_between(const Image& a, const Image& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const double d = double{a.pixels[i]} - double{b.pixels[i]};
        sum += d * d;
    }
    return std::sqrt(sum / static_cast<double>(a.pixels.size()));
}

// A sphere of the material under a studio, by a few look-ups against 1,024 samples. The picture's mean is about 0.5.
double prefiltered_error(gpu::Context& context, const Material& m, ImageLight light) {
    Scene scene = one_object(uv_sphere(96, 48), m);
    scene.textures.push_back(constant_texture(0.5f * kBaseNormal + 0.5f));
    scene.textures.push_back(constant_texture(0.5f * kCoatNormal + 0.5f));
    const Environment studio = load_environment("builtin:studio");
    gpu::Renderer renderer(context, scene, &studio);
    const auto lit = [&](ImageLight by) {
        RenderSettings o = small_picture(40, 40);
        o.image_light = by;
        o.image_light_samples = 1024;
        return renderer.render(camera_on_z(8.0f, 1.02f), o);
    };
    return rms_between(lit(light), lit(ImageLight::importance));
}

// Layers do not make the look-ups much worse than those of the surface alone. Measured: 0.0159 alone, 0.0227 under a coat
// (0.0240 with a look-up 1.4 times as wide, 0.0285 with one of 0.6), 0.0233 under sheen.
TEST_F(LayerPixels, LookUpsAreNearTheSamples) {
    const Material bare = brushed(Method::follow_grain);
    Material coat = bare, sheen = bare;
    coat.coat.strength = 1.0f;
    coat.coat.roughness = 0.3f;
    sheen.sheen.color = glm::vec3(0.6f);
    sheen.sheen.roughness = 0.6f;
    const double alone = prefiltered_error(*context, bare, ImageLight::prefiltered);
    const double coated = prefiltered_error(*context, coat, ImageLight::prefiltered);
    const double sheened = prefiltered_error(*context, sheen, ImageLight::prefiltered);
    if (std::getenv("BURNISH_PRINT_PARITY") != nullptr)
        std::printf("look-ups: alone %.4f coated %.4f sheen %.4f\n", alone, coated, sheened);
    EXPECT_LT(coated, 1.25 * alone + 0.01);
    EXPECT_LT(sheened, 1.25 * alone + 0.02);
    EXPECT_LT(prefiltered_error(*context, coat, ImageLight::bent_normal), 0.5);
}

// Cloth and tabulated materials take layers, too: those that reflect nothing show the layers alone.
TEST_F(LayerPixels, LieOverClothAndTables) {
    Cloth cloth;
    cloth.draft = std::make_shared<const Draft>(builtin_draft("plain"));
    cloth.yarns = 40;
    TabulatedMaterial table = blank_material({24, 80}, 1, 1);
    add_exemplar(table, ggx_table(table.grid, 0.2, 0.5, 0.7), 0.7f);
    table.diffuse.pixels = table.specular.pixels = {0.0f, 0.0f, 0.0f};
    Material woven, measured;
    woven.lobe = cloth;
    woven.metallic = 0.0f;
    woven.base_color = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
    woven.specular = 0.0f;
    measured.lobe = Tabulated{std::make_shared<const TabulatedMaterial>(table), "test"};
    for (const Material& bare : {woven, measured}) {
        for (const ImageLight light :
             {ImageLight::off, ImageLight::importance, ImageLight::prefiltered}) {
            if (tabulated_of(bare) && light == ImageLight::prefiltered) continue;  // refused
            const auto mean_of = [&](const Material& m) {
                Scene scene = one_object(unit_plane(), m);
                // One where the coat mirrors it, one where fibers send it back.
                if (light == ImageLight::off)
                    scene.lights = {directional({0, 0.9f, 0.43f}), directional({0, -0.9f, 0.3f})};
                const Environment white = constant_environment(glm::vec3(0.5f));
                RenderSettings o = small_picture(16, 16, 4);
                o.image_light = light;
                gpu::Renderer renderer(
                    *context, scene,
                    light == ImageLight::off ? static_cast<const Environment*>(nullptr) : &white);
                Camera camera = camera_on_z(3.0f);
                camera.position = {0.0f, -2.7f, 1.3f};
                const Image image = renderer.render(camera, o);
                double sum = 0;
                for (const int x : {6, 8, 10})
                    for (const int y : {6, 8, 10}) sum += double{image.at(x, y)[0]};
                return sum / 9;
            };
            Material coated = bare, sheened = bare;
            coated.coat.strength = 1.0f;
            coated.coat.roughness = 0.4f;
            sheened.sheen.color = glm::vec3(0.8f);
            sheened.sheen.roughness = 0.5f;
            const double alone = mean_of(bare);
            EXPECT_LT(alone, 1e-4) << static_cast<int>(light);
            EXPECT_GT(mean_of(coated), 0.005) << static_cast<int>(light);
            EXPECT_GT(mean_of(sheened), 0.005) << static_cast<int>(light);
        }
    }
}

}  // namespace
}  // namespace burnish::test
