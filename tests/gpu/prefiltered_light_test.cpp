// --image-light prefiltered against importance sampling; the effect of occlusion; irradiance.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "burnish/environments.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/renderer.hpp"
#include "gpu_fixture.hpp"
#include "support/paths.hpp"
#include "test_scene.hpp"

namespace burnish::test {
namespace {

std::filesystem::path environment_folder() {
    return data_folder() / "environments";
}

// A white metal under a normal map of one texel, 45 degrees along (0.8, 0.6); normal_scale sets the
// tilt.
Scene tilted_sphere() {
    Scene scene = one_object(uv_sphere(96, 48), Material{});
    const float s = std::sqrt(0.5f);
    scene.textures.push_back(constant_texture(0.5f * glm::vec3(0.8f * s, 0.6f * s, s) + 0.5f));
    scene.materials[0].normal_texture.texture = 0;
    return scene;
}

void tilt(Material& m, float degrees) {
    m.normal_scale = std::tan(degrees * kPiF / 180.0f);
}

Image lit(gpu::Renderer& renderer, ImageLight light, int samples, int side = 40) {
    RenderSettings o = small_picture(side, side);
    o.image_light = light;
    o.image_light_samples = samples;
    return renderer.render(camera_on_z(8.0f, 1.02f), o);
}

double rms_difference(const Image& a, const Image& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const double d = double{a.pixels[i]} - double{b.pixels[i]};
        sum += d * d;
    }
    return std::sqrt(sum / static_cast<double>(a.pixels.size()));
}

double mean_of(const Image& image) {
    double sum = 0;
    for (std::size_t i = 0; i < image.pixels.size(); i += 4) sum += image.pixels[i];
    return sum / static_cast<double>(image.pixels.size() / 4);
}

Environment gradient_sky() {
    Environment e = constant_environment(glm::vec3(0), 128);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 128; ++x) {
            const float bright = 1.0f + std::sin(kPiF * (static_cast<float>(y) + 0.5f) / 64.0f) *
                                            std::cos(2 * kPiF * static_cast<float>(x) / 128.0f);
            for (int c = 0; c < 3; ++c) e.radiance.at(x, y)[c] = bright;
        }
    }
    return e;
}

// An evening: a blue dome over a dark ground, a warm glow at the horizon and a sun of 8 degrees in it.
Environment evening_sky() {
    Environment e = constant_environment(glm::vec3(0), 256);
    const glm::vec3 sun = glm::normalize(glm::vec3(0.6f, 0.25f, 0.5f));
    for (int y = 0; y < 128; ++y) {
        for (int x = 0; x < 256; ++x) {
            const float polar = kPiF * (static_cast<float>(y) + 0.5f) / 128.0f;
            const float azimuth = 2 * kPiF * ((static_cast<float>(x) + 0.5f) / 256.0f - 0.5f);
            const glm::vec3 w(std::sin(polar) * std::sin(azimuth), std::cos(polar),
                              -std::sin(polar) * std::cos(azimuth));
            const float to_sun = glm::dot(w, sun);
            glm::vec3 color = w.y > 0 ? glm::vec3(0.2f, 0.3f, 0.5f) : glm::vec3(0.05f);
            color += glm::vec3(1.0f, 0.5f, 0.2f) * std::exp(-40.0f * w.y * w.y) *
                     (0.3f + std::max(to_sun, 0.0f));
            if (to_sun > std::cos(4 * kPiF / 180)) color += glm::vec3(60.0f, 40.0f, 20.0f);
            for (int c = 0; c < 3; ++c) e.radiance.at(x, y)[c] = color[c];
        }
    }
    e.name = "evening";
    return e;
}

// `least`: the error of bent normals against that of prefiltered light, over the cases below.
struct EnvironmentUnderTest {
    Environment light;
    double least;
};

// Two that are made here, and two photographs where the sample data is at hand. The budget of a quarter
// is stated for the photographs. Seen of those made here: 3.5 to 6.1 and 3.0 to 6.4.
std::vector<EnvironmentUnderTest> environments_under_test() {
    std::vector<EnvironmentUnderTest> list = {{evening_sky(), 3.3},
                                              {load_environment("builtin:studio"), 2.85}};
    for (const char* name : {"venice_sunset_1k.hdr", "royal_esplanade_1k.hdr"}) {
        const std::filesystem::path file = environment_folder() / name;
        if (!std::filesystem::exists(file)) continue;
        list.push_back({load_environment(file.string()), 4.0});
        list.back().light.name = name;
    }
    return list;
}

class PrefilteredLight : public GpuTest {};

// The budget of docs/evidence/performance.md: the error is at most a quarter of the bent normal's,
// both against 4,096 samples.
TEST_F(PrefilteredLight, ErrsAQuarterAsMuchAsBentNormals) {
    for (const auto& [environment, least] : environments_under_test()) {
        const char* name = environment.name.c_str();
        Scene scene = tilted_sphere();
        scene.materials[0].single_scattering =
            true;  // the lobe alone: what the bent normal stands for
        gpu::Renderer renderer(*context, scene, &environment);
        for (const glm::vec2 alpha : {glm::vec2(0.1f, 0.4f), glm::vec2(0.2f, 0.6f)}) {
            for (const float degrees : {0.0f, 45.0f}) {
                scene.materials[0].lobe = AlphaLobe{alpha};
                tilt(scene.materials[0], degrees);
                renderer.set_materials(scene.materials);
                const Image truth = lit(renderer, ImageLight::importance, 4096);
                const double bent =
                    rms_difference(lit(renderer, ImageLight::bent_normal, 1), truth);
                const double ours =
                    rms_difference(lit(renderer, ImageLight::prefiltered, 1), truth);
                std::printf("%s %.1f,%.1f at %.0f: %.2f\n", name, double{alpha.x}, double{alpha.y},
                            double{degrees}, bent / ours);
                EXPECT_GE(bent / ours, least)
                    << name << " alpha " << alpha.x << "," << alpha.y << " tilt " << degrees;
            }
        }
    }
}

// The deformations at a tilt of 30 degrees; the look-ups follow their energy and widths.
TEST_F(PrefilteredLight, DeformationsErrLessThanBentNormals) {
    for (const auto& [environment, least] : environments_under_test()) {
        const char* name = environment.name.c_str();
        Scene scene = tilted_sphere();
        gpu::Renderer renderer(*context, scene, &environment);
        for (const Method method : {Method::deform_linear, Method::deform_smooth}) {
            scene.materials[0].lobe = AlphaLobe{{0.1f, 0.4f}};
            scene.materials[0].method = method;
            tilt(scene.materials[0], 30.0f);
            renderer.set_materials(scene.materials);
            const Image truth = lit(renderer, ImageLight::importance, 4096);
            const double bent = rms_difference(lit(renderer, ImageLight::bent_normal, 1), truth);
            const double ours = rms_difference(lit(renderer, ImageLight::prefiltered, 1), truth);
            std::printf("%s %s: %.2f (%.4f)\n", name, name_of(method).data(), bent / ours, ours);
            EXPECT_GE(bent / ours, least) << name << " " << name_of(method);
        }
    }
}

// phong and lafortune are round lobes about a direction and take a single look-up in the blurred
// map. The rms error over the picture grows with the contrast of the environment: up to 0.115 under
// one, 0.202 under the other. Narrower and wider look-ups are worse there.
TEST_F(PrefilteredLight, OnePlaceServesCosineLobes) {
    const std::filesystem::path folder = environment_folder();
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no sample data in " << folder;
    for (const auto& [name, limit] :
         {std::pair{"venice_sunset_1k.hdr", 0.12}, std::pair{"royal_esplanade_1k.hdr", 0.21}}) {
        const Environment environment = load_environment((folder / name).string());
        Scene scene = tilted_sphere();
        gpu::Renderer renderer(*context, scene, &environment);
        for (const Brdf brdf : {Brdf::phong, Brdf::lafortune}) {
            for (const float alpha : {0.1f, 0.2f, 0.4f}) {
                scene.materials[0].brdf = brdf;
                scene.materials[0].lobe = AlphaLobe{glm::vec2(alpha)};
                tilt(scene.materials[0], 30.0f);
                renderer.set_materials(scene.materials);
                const Image truth = lit(renderer, ImageLight::importance, 2048, 32);
                const double ours =
                    rms_difference(lit(renderer, ImageLight::prefiltered, 1, 32), truth);
                const double size = rms_difference(truth, Image(32, 32, 4, 0.0f));
                std::printf("%s %s %.2f: %.4f\n", name, name_of(brdf).data(), alpha, ours / size);
                EXPECT_LT(ours / size, limit) << name << " " << name_of(brdf) << " alpha " << alpha;
            }
        }
    }
}

// Rotations preserve the albedo at any tilt: within 1.5 % of the mean. Importance sampling with 128
// samples has 0.2 % of noise over the picture.
TEST_F(PrefilteredLight, FurnaceAgreesWithImportanceSampling) {
    const Environment furnace = constant_environment(glm::vec3(1));
    Scene scene = tilted_sphere();
    gpu::Renderer renderer(*context, scene, &furnace);
    const auto check = [&](Brdf brdf, Mdf mdf, Method method, double tolerance) {
        Material& m = scene.materials[0];
        m.brdf = brdf;
        m.mdf = mdf;
        m.method = method;
        m.lobe = AlphaLobe{{0.15f, 0.5f}};
        tilt(m, 30.0f);
        renderer.set_materials(scene.materials);
        const double truth = mean_of(lit(renderer, ImageLight::importance, 128, 16));
        const double ours = mean_of(lit(renderer, ImageLight::prefiltered, 1, 16));
        EXPECT_NEAR(ours / truth, 1.0, tolerance)
            << name_of(brdf) << " " << name_of(mdf) << " " << name_of(method);
    };
    for (const Mdf mdf : {Mdf::ashikhmin_shirley, Mdf::ward, Mdf::beckmann, Mdf::ggx}) {
        check(Brdf::microfacet, mdf, Method::follow_grain, 0.015);
    }
    for (const Brdf brdf : {Brdf::ashikhmin_shirley, Brdf::ward_gmd}) {
        check(brdf, Mdf::ggx, Method::gram_schmidt, 0.02);  // 1.6 %: no mixed term
    }
    for (const Brdf brdf : {Brdf::phong, Brdf::lafortune}) {
        check(brdf, Mdf::ggx, Method::gram_schmidt, 0.02);
    }
    // Not a rotation: its gains and losses are not modeled (docs/theory/image-light.md).
    check(Brdf::microfacet, Mdf::ggx, Method::deform_linear, 0.2);
}

// The axis of the look-ups is undefined for a lobe that appears round, but the result must be
// continuous there. The sky changes by 1 per radian, and a step rotates the lobe by at most 0.02
// radian.
TEST_F(PrefilteredLight, ChangesWithoutJumps) {
    const Environment sky = gradient_sky();
    Scene scene = tilted_sphere();
    gpu::Renderer renderer(*context, scene, &sky);
    for (const glm::vec2 alpha : {glm::vec2(0.3f, 0.3f), glm::vec2(0.1f, 0.4f)}) {
        Image last;
        for (int step = 0; step <= 60; ++step) {
            scene.materials[0].lobe = AlphaLobe{alpha};
            tilt(scene.materials[0], 0.5f * static_cast<float>(step));
            renderer.set_materials(scene.materials);
            const Image image = lit(renderer, ImageLight::prefiltered, 1, 16);
            for (int y = 4; step > 0 && y < 12; ++y) {
                for (int x = 4; x < 12; ++x) {
                    ASSERT_NEAR(image.at(x, y)[0], last.at(x, y)[0], 0.04) << "step " << step;
                }
            }
            last = image;
        }
    }
}

TEST_F(PrefilteredLight, HostileNormalsStayFiniteAndGainNothing) {
    const Environment furnace = constant_environment(glm::vec3(1));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    Scene scene = one_object(uv_sphere(48, 24), Material{});
    scene.textures.push_back(float_texture(4, 2,
                                           {glm::vec3(0),
                                            glm::vec3(nan),
                                            {1, 0.5f, 0.5f},
                                            {0.5f, 1, 0.5f},
                                            glm::vec3(-7),
                                            {0.5f, 0.5f, -1},
                                            {0, 0, 0.51f},
                                            {1e30f, 0, 1}}));
    scene.materials[0].normal_texture.texture = 0;
    scene.materials[0].normal_texture.nearest = true;
    gpu::Renderer renderer(*context, scene, &furnace);
    for (const glm::vec2 alpha : {glm::vec2(1e-3f, 1.0f), glm::vec2(0.2f, 0.6f)}) {
        for (int method = 0; method < static_cast<int>(method_names().size()); ++method) {
            scene.materials[0].lobe = AlphaLobe{alpha};
            scene.materials[0].method = static_cast<Method>(method);
            renderer.set_materials(scene.materials);
            // The deformations gain energy at steep tilts, as published: at most as much as the
            // reference.
            float most = 1.02f;
            if (is_deformation(static_cast<Method>(method))) {
                const Image truth = lit(renderer, ImageLight::importance, 256, 24);
                most *= std::max(1.0f, *std::max_element(truth.pixels.begin(), truth.pixels.end()));
                std::printf("%s: reference at most %.3f\n",
                            name_of(scene.materials[0].method).data(), most / 1.02f);
            }
            for (const float v : lit(renderer, ImageLight::prefiltered, 1, 24).pixels) {
                ASSERT_TRUE(std::isfinite(v));
                ASSERT_LE(v, most) << name_of(scene.materials[0].method);
            }
        }
    }
}

Material chalk() {
    Material m;
    m.metallic = 0.0f;
    m.dielectric_f0 = 0.0f;
    return m;
}

// Only a disk of the sky shines. The irradiance is its solid angle times the cosine, by quadrature
// over its texels, and nowhere negative.
TEST_F(PrefilteredLight, IrradianceOfASun) {
    Environment sun = constant_environment(glm::vec3(0), 256);
    glm::dvec3 power(0);
    const double step = 3.14159265358979 / 128;
    for (int y = 40; y < 46; ++y) {
        for (int x = 200; x < 206; ++x) {
            for (int c = 0; c < 3; ++c) sun.radiance.at(x, y)[c] = 1000.0f;
            const double theta = (y + 0.5) * step, phi = (x + 0.5) * step - 3.14159265358979;
            power += 1000.0 * std::sin(theta) * step * step *
                     glm::dvec3(std::sin(theta) * std::sin(phi), std::cos(theta),
                                -std::sin(theta) * std::cos(phi));
        }
    }
    Scene scene = one_object(uv_sphere(96, 48), chalk());
    gpu::Renderer renderer(*context, scene, &sun);
    RenderSettings o = small_picture(48, 48);
    o.image_light = ImageLight::prefiltered;
    // Nearly parallel rays: the position gives the normal.
    Camera camera = camera_on_z(40.0f, 1.0f);
    const Image white = renderer.render(camera, o);
    scene.materials[0].base_color = glm::vec4(0, 0, 0, 1);
    renderer.set_materials(scene.materials);
    const Image black = renderer.render(camera, o);
    const double peak = glm::length(power) / 3.14159265358979;
    for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 48; ++x) {
            const double nx = (x + 0.5) / 24 - 1, ny = 1 - (y + 0.5) / 24;
            if (nx * nx + ny * ny > 0.8) continue;
            const glm::dvec3 n(nx, ny, std::sqrt(1 - nx * nx - ny * ny));
            const double through = 20.0 / 21.0 * (1 - std::pow(1 - n.z, 5.0));
            const double wanted = std::max(glm::dot(n, power), 0.0) / 3.14159265358979 * through;
            // 3 % of the peak: at the terminator half of the sun's 8 degrees is still visible (1
            // %), and look-ups are bilinear across the crease.
            const double found = double{white.at(x, y)[0]} - black.at(x, y)[0];
            EXPECT_NEAR(found, wanted, 0.03 * peak);
            EXPECT_GE(found, -1e-4 * peak);
        }
    }
}

class Occlusion : public GpuTest {
  protected:
    static Scene plate(Material m, float occlusion) {
        Scene scene = one_object(unit_plane(), m);
        scene.textures.push_back(constant_texture(glm::vec3(occlusion)));
        scene.materials[0].occlusion_texture.texture = 0;
        return scene;
    }
    double middle(const Scene& scene, const Environment* environment) {
        gpu::Renderer renderer(*context, scene, environment);
        RenderSettings o = small_picture(9, 9);
        o.image_light = ImageLight::prefiltered;
        return renderer.render(camera_on_z(4, 0.05f), o).at(4, 4)[0];
    }
};

TEST_F(Occlusion, HalvesDiffuseImageLight) {
    const Environment furnace = constant_environment(glm::vec3(1));
    Material chalky = chalk();
    const double open = middle(plate(chalky, 1.0f), &furnace);
    EXPECT_NEAR(middle(plate(chalky, 0.5f), &furnace) / open, 0.5, 0.005);
    EXPECT_LT(middle(plate(chalky, 0.0f), &furnace), 1e-3);
}

// The rule of shade.glsl evaluated here: normal incidence, alpha 0.5, occlusion 0.3.
TEST_F(Occlusion, DimsReflectionsByItsRule) {
    const Environment furnace = constant_environment(glm::vec3(1));
    Material metal;
    metal.lobe = AlphaLobe{{0.5f, 0.5f}};
    const double open = middle(plate(metal, 1.0f), &furnace);
    const double rule = std::pow(1.0 + 0.3, std::exp2(-16 * 0.5 - 1)) - 1 + 0.3;
    EXPECT_NEAR(middle(plate(metal, 0.3f), &furnace) / open, rule, 0.01);
    EXPECT_LT(middle(plate(metal, 0.0f), &furnace), 0.01);
}

TEST_F(Occlusion, LeavesPunctualLightAlone) {
    Material m;
    m.lobe = AlphaLobe{{0.5f, 0.5f}};
    Scene open = plate(m, 1.0f), dim = plate(m, 0.2f);
    open.lights = dim.lights = {directional({0.2f, 0.1f, 1.0f})};
    EXPECT_NEAR(middle(dim, nullptr), middle(open, nullptr), 1e-6);
}

}  // namespace
}  // namespace burnish::test
