// Woven cloth: yarns against the maths at single pixels, and the mean at a distance against
// pictures without the filter at 1,024 samples per pixel.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <numbers>
#include <sstream>

#include "burnish/draft.hpp"
#include "burnish/f64.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/renderer.hpp"
#include "burnish/weave_maps.hpp"
#include "flicker.hpp"
#include "gpu_fixture.hpp"
#include "test_scene.hpp"

namespace burnish::test {
namespace {

using f64::vec3;

Material woven(const char* draft) {
    Material m;
    m.metallic = 0.0f;
    Cloth cloth;
    cloth.draft = std::make_shared<Draft>(builtin_draft(draft));
    cloth.warp_color = glm::vec3(0.6f, 0.5f, 0.3f);
    cloth.weft_color = glm::vec3(0.05f, 0.1f, 0.3f);
    cloth.alpha = {0.2f, 0.45f};
    m.lobe = cloth;
    return m;
}

Cloth& cloth_in(Material& m) {
    return std::get<Cloth>(m.lobe);
}

// --- single yarns ------------------------------------------------------------------------------

class ClothYarn : public GpuTest {};

// Ribbons without gaps, twist or crimp: flat cells whose lobes differ by 90 degrees.
TEST_F(ClothYarn, TheLobeRunsAlongTheYarn) {
    Material m = woven("plain");
    cloth_in(m) = {cloth_of(m)->draft, 2.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, {}, {}};
    m.base_color = glm::vec4(0.0f, 0.0f, 0.0f, 1.0f);
    Scene scene = one_object(unit_plane(), m);
    const Light light = directional({0.5f, 0.1f, 1.0f});
    scene.lights.push_back(light);
    const Camera camera = camera_on_z(3.0f);
    RenderSettings o = small_picture(16, 16);
    gpu::Renderer renderer(*context, scene, nullptr);
    const Image image = renderer.render(camera, o);
    const int ggx = static_cast<int>(Mdf::ggx), microfacet = static_cast<int>(Brdf::microfacet);
    // Two cells a side: warp and weft are on top alternately.
    for (const int x : {3, 12}) {
        for (const int y : {3, 12}) {
            const double half = std::tan(0.5 * camera.yfov) * 3.0;
            const vec3 at(half * ((x + 0.5) / 8 - 1), half * (1 - (y + 0.5) / 8), 0);
            const vec3 wo = f64::normalize(vec3(0, 0, 3) - at);
            const vec3 wi = f64::normalize(vec3(0.5, 0.1, 1.0));
            const int end = at.x < 0 ? 0 : 1, pick = at.y < 0 ? 0 : 1;
            const bool warp = cloth_of(m)->draft->is_warp_up(end, pick);
            // The lobe is narrow along the yarn: along y on the warp.
            const f64::Lobe lobe = f64::lobe_make(ggx, warp ? 0.45 : 0.2, warp ? 0.2 : 0.45);
            const f64::Perturbation p =
                f64::perturb_make(f64::kMethodNone, vec3(0, 0, 1), true, false);
            const double f0 = m.dielectric_f0;
            const double wanted = f64::brdf_eval(microfacet, lobe, p, wi, wo) *
                                  f64::fresnel_schlick(f0, f64::dot(wi, f64::normalize(wi + wo))) *
                                  wi.z * light.intensity;
            EXPECT_NEAR(image.at(x, y)[0], wanted, 5e-3 * wanted) << x << "," << y;
        }
    }
}

// The picture of the weave's normal map under the same light, where a round lobe and equal colors leave
// nothing but the normals. The maps have the first pick at the bottom and y up.
TEST_F(ClothYarn, LooksLikeItsNormalMap) {
    WeaveMapSettings settings;
    settings.draft = builtin_draft("twill-2-1");
    settings.width = settings.height = 384;
    settings.shape = {0.2f, 0.8f, 0.0f, {1.0f, 0.0f}};
    const WeaveMaps maps = bake_weave(settings, std::uint64_t{1} << 30);
    std::vector<float> rows(3 * maps.yarns.size());
    weave_normal_rows(maps, 0, maps.height, rows.data());
    std::vector<glm::vec3> texels;
    for (std::size_t i = 0; i < rows.size(); i += 3)
        texels.emplace_back(rows[i], rows[i + 1], rows[i + 2]);

    Material cloth;
    cloth.metallic = 0.0f;
    cloth.method = Method::rotate_exact;
    Material mapped = cloth;
    const glm::vec3 white(1.0f);
    cloth.lobe = Cloth{std::make_shared<Draft>(settings.draft),
                       3.0f,
                       0.2f,
                       0.8f,
                       0.0f,
                       0.0f,
                       0.0f,
                       white,
                       white,
                       {0.4f, 0.4f}};
    mapped.lobe = AlphaLobe{{0.4f, 0.4f}};
    mapped.normal_texture.texture = 0;
    mapped.normal_filter = NormalFilter::mips;
    const auto picture = [&](const Material& m) {
        Scene scene = one_object(unit_plane(), m);
        scene.textures.push_back(float_texture(maps.width, maps.height, texels));
        scene.lights.push_back(directional({0.3f, 0.8f, 0.6f}));
        gpu::Renderer renderer(*context, scene, nullptr);
        return renderer.render(camera_on_z(3.0f), small_picture(96, 96));
    };
    const Image woven = picture(cloth), baked = picture(mapped);
    double sum = 0, difference = 0;
    for (std::size_t i = 0; i < woven.pixels.size(); ++i) {
        sum += static_cast<double>(baked.pixels[i]);
        difference += std::abs(static_cast<double>(woven.pixels[i] - baked.pixels[i]));
    }
    ASSERT_GT(sum, 0.0);
    // Codes and filtering of the map: 4e-5. With the rows the other way round: 0.23.
    EXPECT_LT(difference, 2e-4 * sum);
}

// --- from afar ---------------------------------------------------------------------------------

struct View {
    const char* draft;
    double metres;    // distance from the cloth
    double tilt_deg;  // between the view and the cloth's normal
};

void PrintTo(const View& v, std::ostream* out) {
    *out << v.draft << " at " << v.metres << " m, " << v.tilt_deg << " degrees";
}

class ClothFromAfar : public GpuTest, public testing::WithParamInterface<View> {
  protected:
    // Two yarns per millimeter on a square of two meters; 24 pixels of 1/3 degree each.
    Image picture(ImageLight image_light, bool filtered, int samples) {
        const View& view = GetParam();
        Material m = woven(view.draft);
        cloth_in(m).yarns = 4000.0f;
        Scene scene = one_object(unit_plane(), m);
        const bool sky = image_light != ImageLight::off;
        if (!sky) {
            scene.lights.push_back(directional({0.3f, 0.4f, 1.0f}, glm::vec3(2.0f)));
            scene.lights.push_back(directional({-0.8f, 0.1f, 0.6f}));
        }
        Environment environment = constant_environment(glm::vec3(0.2f));
        // A window that covers a quarter of the sky.
        for (int y = 2; y < 7; ++y)
            for (int x = 8; x < 16; ++x)
                for (int c = 0; c < 3; ++c) environment.radiance.at(x, y)[c] = 3.0f;
        const double tilt = view.tilt_deg * std::numbers::pi / 180;
        Camera camera;
        camera.target = {0.03f, 0.02f, 0.0f};
        camera.position = camera.target + static_cast<float>(view.metres) *
                                              glm::vec3(std::sin(tilt), 0.0, std::cos(tilt));
        camera.yfov = static_cast<float>(8.0 * std::numbers::pi / 180);
        RenderSettings o = small_picture(24, 24, samples);
        o.image_light = image_light;
        o.image_light_samples = image_light == ImageLight::importance && filtered ? 64 : 1;
        o.filter_cloth = filtered;
        gpu::Renderer renderer(*context, scene, sky ? &environment : nullptr);
        return renderer.render(camera, o);
    }

    static std::array<double, 3> mean_of(const Image& image) {
        std::array<double, 3> sum{};
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                for (std::size_t c = 0; c < 3; ++c)
                    sum[c] += static_cast<double>(image.at(x, y)[c]) / (image.width * image.height);
        return sum;
    }

    void expect_same_mean(ImageLight image_light, double tolerance) {
        const auto seen = mean_of(picture(image_light, true, 1));
        // The reference samples the light exactly too.
        const auto truth = mean_of(picture(
            image_light == ImageLight::off ? image_light : ImageLight::importance, false, 1024));
        if (std::getenv("BURNISH_PRINT_CLOTH") != nullptr) {
            std::ostringstream view;
            PrintTo(GetParam(), &view);
            std::printf("%-32s over the truth %.3f %.3f %.3f\n", view.str().c_str(),
                        seen[0] / truth[0], seen[1] / truth[1], seen[2] / truth[2]);
        }
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(seen[c] / truth[c], 1.0, tolerance) << "channel " << c;
    }
};

TEST_P(ClothFromAfar, MeanColorUnderLamps) {
    expect_same_mean(ImageLight::off, 0.03);
}

TEST_P(ClothFromAfar, MeanColorUnderASky) {
    expect_same_mean(ImageLight::importance, 0.03);
}

TEST_P(ClothFromAfar, MeanColorUnderAPrefilteredSky) {
    // One look-up along the family's wide lobe is too dim at grazing angles
    // (docs/evidence/cloth.md).
    expect_same_mean(ImageLight::prefiltered, GetParam().tilt_deg > 0 ? 0.18 : 0.03);
}

INSTANTIATE_TEST_SUITE_P(Views, ClothFromAfar,
                         testing::Values(View{"plain", 0.1, 0}, View{"plain", 1, 0},
                                         View{"plain", 10, 0}, View{"plain", 1, 50},
                                         View{"twill-2-2", 0.1, 0}, View{"twill-2-2", 1, 0},
                                         View{"twill-2-2", 10, 30}, View{"satin-5", 0.1, 0},
                                         View{"satin-5", 1, 40}, View{"satin-5", 10, 0}));

// --- turning -----------------------------------------------------------------------------------

// Ratio of the flicker of the picture to that of the reference.
struct Turn {
    double pixels;  // per yarn, in the middle of the picture
    int truth_samples;
    double least, most;  // with one sample per pixel
    double most_of_four;
    double least_of_points;
};

void PrintTo(const Turn& t, std::ostream* out) {
    *out << t.pixels << " pixels a yarn";
}

class ClothTurning : public GpuTest, public testing::WithParamInterface<Turn> {
  protected:
    static constexpr int kSide = 96;

    // A sphere of twill under one lamp, drawn `factor` times larger.
    double flicker(bool filtered, int factor, int samples) {
        Mesh sphere = uv_sphere(256, 128);
        // Equal yarns per meter in both directions.
        for (glm::vec2& uv : sphere.texcoord0) uv.x *= 2.0f;
        Material m = woven("twill-2-2");
        // A pixel spans 2.2/96 of the radius; half the circumference is pi.
        cloth_in(m).yarns =
            static_cast<float>(std::round(std::numbers::pi / (2.2 / kSide * GetParam().pixels)));
        Scene scene = one_object(std::move(sphere), m);
        scene.lights.push_back(directional({0.3f, 0.4f, 1.0f}));
        return flicker_on_turntable(scene, [&](const Scene& s) {
            RenderSettings o = small_picture(kSide * factor, kSide * factor, samples);
            o.filter_cloth = filtered;
            gpu::Renderer renderer(*context, s, nullptr);
            return reduced(renderer.render(camera_on_z(4.0f, 1.1f), o), factor);
        });
    }
};

// Where yarns are resolved, a single sample is a point of them, so that edges alias. Four samples
// are as smooth as the reference.
TEST_P(ClothTurning, FlickersAsTheTruthDoes) {
    const Turn& turn = GetParam();
    // At least 4 pixels of the reference per yarn.
    const double truth = flicker(false, 16, turn.truth_samples);
    const double one = flicker(true, 1, 1), four = flicker(true, 1, 4),
                 points = flicker(false, 1, 1);
    if (std::getenv("BURNISH_PRINT_CLOTH") != nullptr)
        std::printf(
            "%g pixels a yarn: flicker %.3f, 4 samples %.3f, points alone %.3f, truth %.3f\n",
            turn.pixels, one, four, points, truth);
    EXPECT_GT(one, turn.least * truth);
    EXPECT_LT(one, turn.most * truth);
    EXPECT_LT(four, turn.most_of_four * truth);
    EXPECT_GT(points, turn.least_of_points * truth);
}

INSTANTIATE_TEST_SUITE_P(Distances, ClothTurning,
                         testing::Values(Turn{6, 1, 0.9, 2.0, 1.05, 1.5},
                                         Turn{1, 1, 0.5, 1.0, 1.0, 2},
                                         Turn{0.25, 4, 0.3, 1.0, 2.5, 15}));

}  // namespace
}  // namespace burnish::test
