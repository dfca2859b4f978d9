// The view of the albedo against the inspector's: the renderer's draws in a white furnace, in single
// precision on the device, against those of lobe_albedo, in double and of another sequence.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <glm/ext/matrix_transform.hpp>
#include <memory>
#include <string>

#include "burnish/draft.hpp"
#include "gpu/gpu_fixture.hpp"
#include "gpu/tabulated_scenes.hpp"
#include "viewer/inspect/inspector.hpp"
#include "viewer/viewer_scenes.hpp"

namespace burnish::viewer {
namespace {

constexpr int kSide = 32;
// As many draws as a picture of the default settings has at a pixel: 64 samples of 16.
constexpr int kDraws = 1024;

// The albedo of the channel that reflects most, from the color that shading/display/scale.glsl gives
// it; above 1.01 by the green channel, which falls from 0.62 to 0 with the root of the gain.
double albedo_of(const float* linear) {
    const auto encoded = [&](int c) {
        return f64::srgb_from_linear(static_cast<double>(linear[c]));
    };
    if (encoded(0) - encoded(1) < 0.1) return encoded(1);
    const double root = 1 - encoded(1) / 0.62;
    return 1 + root * root;
}

double most_of(glm::dvec3 v) {
    return std::max({v.x, v.y, v.z});
}

struct Compared {
    double rms = 0, worst = 0;  // differences
    double highest = 0;         // albedo
    int count = 0;              // of pixels
    int compared = 0;           // of those, on the scale
    int red = 0;                // pixels that the view shows as gaining energy
    int missed = 0;  // of those that the inspector finds gaining 0.1 at the least: not red
};

class AlbedoView : public test::GpuTest {
  protected:
    // One sample in the middle of each pixel, so that both look at one point.
    static RenderSettings settings() {
        RenderSettings o = test::small_picture(kSide, kSide);
        o.view = SurfaceView::albedo;
        o.image_light_samples = kDraws;
        o.filter_cloth = false;
        return o;
    }

    Compared compare(const Scene& scene, const Camera& camera, const std::string& what) {
        gpu::Renderer renderer(*context, scene, nullptr);
        const Image image = renderer.render(camera, settings());
        const Picker picker(scene);
        Compared c;
        for (int y = 2; y < kSide; y += 4) {
            for (int x = 2; x < kSide; x += 4) {
                const auto hit = pick(scene, picker, camera, {x + 0.5, y + 0.5}, {kSide, kSide});
                if (!hit) continue;
                const glm::dvec3 eye = towards_eye(camera, hit->position);
                const SurfaceAt at = surface_at(scene, *hit, eye);
                const Method method =
                    scene.materials[static_cast<std::size_t>(hit->material)].method;
                const LobeAlbedo wanted =
                    lobe_albedo(PointLobe(at, method), to_tangent_frame(at, eye), 8192);
                const double value = most_of(wanted.whole);
                const float* pixel = image.at(x, y);
                const bool red = pixel[0] > 1.05f * pixel[1];
                // The scale ends at 2.
                if (value < 1.9) {
                    const double difference = std::abs(albedo_of(pixel) - value);
                    c.rms += difference * difference;
                    c.worst = std::max(c.worst, difference);
                    ++c.compared;
                }
                c.highest = std::max(c.highest, value);
                ++c.count;
                c.red += red ? 1 : 0;
                c.missed += wanted.gains_energy && value > 1.1 && !red ? 1 : 0;
            }
        }
        c.rms = std::sqrt(c.rms / std::max(c.compared, 1));
        if (std::getenv("BURNISH_PRINT_ALBEDO") != nullptr)
            std::printf("albedo %-44s rms %.4f worst %.4f highest %.3f red %d of %d\n",
                        what.c_str(), c.rms, c.worst, c.highest, c.red, c.count);
        EXPECT_GT(c.compared, 20) << what;
        EXPECT_EQ(c.missed, 0) << what;
        return c;
    }

    // The whole of a sphere whose normals a map tilts by 24 degrees everywhere.
    static Scene tilted_sphere(Material m) {
        m.normal_texture.texture = 0;
        Scene scene = test::one_object(test::uv_sphere(96, 48), std::move(m));
        scene.textures = {test::normal_texel({0.4, 0.2, 1.0})};
        return scene;
    }

    const Camera camera_ = test::camera_on_z(4.0f, 1.0f);
};

Material metal(Mdf mdf, Brdf brdf, Method method) {
    Material m;
    m.metallic = 1.0f;
    m.mdf = mdf;
    m.brdf = brdf;
    m.method = method;
    m.lobe = AlphaLobe{{0.15f, 0.4f}};
    return m;
}

// Measured on llvmpipe, the inspector's own error of 8,192 draws included: rms 0.0032 for rotations, whose
// draws have weights near 1, worst of 54 pixels 0.011. For the others rms 0.012, worst 0.084: at grazing
// angles few draws of a large weight count. The bounds are about twice that. docs/guide/viewer.md states the
// errors.
struct Bound {
    double rms, worst;
};
Bound bound_of(Method method) {
    const bool rotates = method == Method::none || method == Method::gram_schmidt ||
                         method == Method::rotate_exact || method == Method::rotate_arc ||
                         method == Method::follow_grain;
    return rotates ? Bound{0.006, 0.02} : Bound{0.025, 0.2};
}

TEST_F(AlbedoView, IsTheInspectorsForEveryMethodOfEveryDistribution) {
    for (const Mdf mdf : {Mdf::ggx, Mdf::beckmann, Mdf::ashikhmin_shirley, Mdf::ward}) {
        for (const Method method : test::all_methods()) {
            // Half of the methods for the others, to save time.
            if (mdf != Mdf::ggx && static_cast<int>(method) % 2 != static_cast<int>(mdf) % 2)
                continue;
            const std::string what = std::string(name_of(mdf)) + " " + std::string(name_of(method));
            const Compared c =
                compare(tilted_sphere(metal(mdf, Brdf::microfacet, method)), camera_, what);
            EXPECT_LT(c.rms, bound_of(method).rms) << what;
            EXPECT_LT(c.worst, bound_of(method).worst) << what;
        }
    }
}

TEST_F(AlbedoView, IsTheInspectorsForEveryModelWithItsDiffuseTerm) {
    const Bound bound = bound_of(Method::follow_grain);
    for (std::size_t i = 0; i < brdf_names().size(); ++i) {
        Material m = metal(Mdf::ggx, static_cast<Brdf>(i), Method::follow_grain);
        m.metallic = 0.7f;
        m.base_color = {0.9f, 0.6f, 0.3f, 1.0f};
        const std::string what(brdf_names()[i]);
        const Compared c = compare(tilted_sphere(m), camera_, what);
        EXPECT_LT(c.rms, bound.rms) << what;
        EXPECT_LT(c.worst, bound.worst) << what;
    }
}

TEST_F(AlbedoView, IsTheInspectorsForYarnsAndForMeasuredTexels) {
    Material woven;
    woven.metallic = 0.3f;
    Cloth cloth;
    cloth.draft = std::make_shared<Draft>(builtin_draft("twill-2-2"));
    cloth.yarns = 12.0f;
    cloth.warp_color = glm::vec3(0.6f, 0.5f, 0.3f);
    cloth.weft_color = glm::vec3(0.05f, 0.1f, 0.3f);
    woven.lobe = cloth;
    Scene scene = test::one_object(test::uv_sphere(96, 48), woven);
    const Compared yarns = compare(scene, camera_, "cloth");
    const Bound bound = bound_of(Method::follow_grain);
    EXPECT_LT(yarns.rms, bound.rms);
    EXPECT_LT(yarns.worst, bound.worst);

    TabulatedMaterial t = test::blank_material({24, 80}, 1, 1);
    test::add_exemplar(t, test::ggx_table(t.grid, 0.2, 0.5, 0.7), 0.7f);
    t.eta = 1.5;
    t.diffuse.pixels = {0.25f, 0.125f, 0.5f};
    t.specular.pixels = {0.1f, 0.05f, 0.15f};
    Material measured;
    measured.method = Method::follow_grain;
    measured.lobe = Tabulated{std::make_shared<const TabulatedMaterial>(t), {}};
    const Compared texels = compare(tilted_sphere(measured), camera_, "table");
    // The draws of a table are uniform within its cells: their weights vary.
    EXPECT_LT(texels.rms, 2 * bound.rms);
    EXPECT_LT(texels.worst, 2 * bound.worst);
}

// normal-map evaluates the lobe about the geometric normal and the cosines about n~: it is no rotation,
// and gains. A rotation of a lobe that loses energy by masking alone gains nothing anywhere.
TEST_F(AlbedoView, IsRedWhereAMethodGainsEnergyAndNowhereElse) {
    const Compared gains = compare(
        tilted_sphere(metal(Mdf::ggx, Brdf::microfacet, Method::normal_map)), camera_, "gain");
    EXPECT_GT(gains.highest, 1.3);
    EXPECT_GT(gains.red, 3);
    EXPECT_LT(gains.red, gains.count);
    const Compared keeps =
        compare(tilted_sphere(metal(Mdf::beckmann, Brdf::microfacet, Method::rotate_exact)),
                camera_, "no gain");
    EXPECT_EQ(keeps.red, 0);
    EXPECT_GT(keeps.highest, 0.98);  // nearly all energy: noise would show
    EXPECT_LT(keeps.highest, 1.002);
}

// The albedo belongs to the surface alone: light, occlusion, emission and how image light is computed
// change nothing; the mean of many samples is what one sample of as many draws says.
TEST_F(AlbedoView, IsOfTheSurfaceAlone) {
    Material m = metal(Mdf::ggx, Brdf::microfacet, Method::follow_grain);
    Scene scene = tilted_sphere(m);
    gpu::Renderer alone(*context, scene, nullptr);
    const Image wanted = alone.render(camera_, settings());
    scene.materials[0].occlusion_texture.texture = 1;
    scene.materials[0].emissive = glm::vec3(3.0f);
    scene.textures.push_back(test::constant_texture(glm::vec3(0.0f)));
    scene.lights = {test::directional({0.3f, 0.4f, 1.0f}, glm::vec3(7.0f))};
    const Environment red = test::constant_environment({5.0f, 0.0f, 0.0f});
    gpu::Renderer lit(*context, scene, &red);
    RenderSettings o = settings();
    o.background = BackgroundKind::environment;
    o.shadows = true;
    for (const ImageLight light : {ImageLight::off, ImageLight::importance, ImageLight::bent_normal,
                                   ImageLight::prefiltered}) {
        o.image_light = light;
        EXPECT_TRUE(test::close_pictures(lit.render(camera_, o), wanted, 0.01, 1e-4))
            << image_light_names()[static_cast<std::size_t>(light)];
    }
    o.samples = 64;
    o.image_light_samples = kDraws / 64;
    const Image many = lit.render(camera_, o);
    // The pixels of a sphere differ from their middles by a tenth of this.
    for (const int y : {12, 16, 20})
        for (const int x : {12, 16, 20})
            EXPECT_NEAR(albedo_of(many.at(x, y)), albedo_of(wanted.at(x, y)), 0.01);
}

}  // namespace
}  // namespace burnish::viewer
