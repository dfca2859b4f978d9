// Light from an environment: energy, convergence to a quadrature on the CPU, rotation, background.
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "burnish/f64.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/renderer.hpp"
#include "core/constants.hpp"
#include "gpu_fixture.hpp"
#include "test_scene.hpp"

namespace burnish::test {
namespace {

using f64::vec3;

vec3 to_f64(glm::vec3 v) {
    return {v.x, v.y, v.z};
}

Material white_metal(Method method, glm::vec2 alpha) {
    Material m;
    m.single_scattering = true;  // the lobe alone, whose integral is known
    m.method = method;
    m.lobe = AlphaLobe{alpha};
    return m;
}

// Radiance in closed form: bright around one direction, smooth enough for small maps.
double sky(vec3 w) {
    const vec3 toward = f64::normalize(vec3{0.6, 0.5, 0.7});
    return 0.2 + 0.1 * w.x + 6.0 * std::exp(12.0 * (f64::dot(w, toward) - 1));
}

Environment sky_environment(int width) {
    Environment e = constant_environment(glm::vec3(0), width);
    for (int y = 0; y < e.radiance.height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double theta = kPi * (y + 0.5) / e.radiance.height;
            const double phi = 2 * kPi * ((x + 0.5) / width - 0.5);  // from -z towards +x
            const vec3 w{std::sin(theta) * std::sin(phi), std::cos(theta),
                         -std::sin(theta) * std::cos(phi)};
            for (int c = 0; c < 3; ++c) e.radiance.at(x, y)[c] = static_cast<float>(sky(w));
        }
    }
    return e;
}

class ImageLighting : public GpuTest {
  protected:
    Image render(const Scene& scene, const Environment& environment, const RenderSettings& o,
                 const Camera& camera = camera_on_z()) {
        gpu::Renderer renderer(*context, scene, &environment);
        return renderer.render(camera, o);
    }
};

// White metal (F = 1) in constant light, so that the radiance is the albedo. Rotations preserve the
// energy of a lobe: nothing above 1 but noise. The deformations and normal-map are not rotations
// and gain energy (docs/theory/papers.md): only bounds are checked.
TEST_F(ImageLighting, FurnaceGainsNoEnergy) {
    Scene scene = one_object(uv_sphere(48, 24), white_metal(Method::none, {0.15f, 0.5f}));
    scene.textures.push_back(bump_texture(64, 6, 0.4f));
    scene.materials[0].normal_texture.texture = 0;
    const Environment furnace = constant_environment(glm::vec3(1));
    RenderSettings o = small_picture(32, 32, 8);
    o.background_color = glm::vec3(0);
    o.image_light_samples = 32;
    gpu::Renderer renderer(*context, scene, &furnace);
    for (int method = 0; method < static_cast<int>(method_names().size()); ++method) {
        scene.materials[0].method = static_cast<Method>(method);
        renderer.set_materials(scene.materials);
        const Image image = renderer.render(camera_on_z(), o);
        const Method m = static_cast<Method>(method);
        const bool rotation = m != Method::normal_map && m != Method::rotate_approx &&
                              m != Method::deform_linear && m != Method::deform_smooth;
        double highest = 0, mean = 0;
        int covered = 0;
        for (int y = 0; y < 32; ++y) {
            for (int x = 0; x < 32; ++x) {
                const double v = image.at(x, y)[0];
                ASSERT_TRUE(std::isfinite(v));
                highest = std::max(highest, v);
                mean += v;
                covered += v > 0 ? 1 : 0;
            }
        }
        mean /= covered;
        // 256 samples per pixel with weights up to about 3: 3 sigma is 0.12 at the limb.
        if (m == Method::normal_map) {
            EXPECT_GT(highest, 1.3);
            continue;
        }
        EXPECT_LT(highest, rotation ? 1.12 : 1.8) << name_of(m);
        EXPECT_LT(mean, rotation ? 1.0 : 1.2) << name_of(m);
        EXPECT_GT(mean, 0.5) << name_of(m);
        if (std::getenv("BURNISH_PRINT_FURNACE") != nullptr) {
            std::printf("%-14s mean %.4f highest %.4f\n", name_of(m).data(), mean, highest);
        }
    }
}

using Radiance = std::function<double(vec3)>;

// Int value(wi) (n.wi) dwi, by the midpoint rule over the hemisphere about n.
double quadrature(const Radiance& value, const vec3& n) {
    constexpr int kTheta = 600, kPhi = 1200;
    const f64::Frame frame = f64::frame_shortest_arc(n);
    double sum = 0;
    for (int i = 0; i < kTheta; ++i) {
        const double theta = 0.5 * kPi * (i + 0.5) / kTheta;
        for (int j = 0; j < kPhi; ++j) {
            const double phi = 2 * kPi * (j + 0.5) / kPhi;
            const vec3 local{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                             std::cos(theta)};
            sum += value(f64::frame_to_outer(frame, local)) * local.z * std::sin(theta);
        }
    }
    return sum * 0.5 * kPi / kTheta * 2 * kPi / kPhi;
}

const glm::vec3 kTilt = glm::normalize(glm::vec3(0.3f, 0.2f, 1.0f));

// The mean over a plate of the material with a map of one tilt, seen from one direction.
class TiltedPlate : public ImageLighting {
  protected:
    double seen_from(glm::vec3 eye, const Material& material, const Environment& environment) {
        Scene scene = one_object(unit_plane(), material);
        scene.textures.push_back(constant_texture(0.5f * kTilt + 0.5f));
        scene.materials[0].normal_texture.texture = 0;
        RenderSettings o = small_picture(8, 8, 64);
        o.image_light_samples = 64;
        Camera camera = camera_on_z(4.0f, 0.02f);  // nearly one direction for all pixels
        camera.position = eye;
        camera.yfov = 0.01f;
        const Image image = render(scene, environment, o, camera);
        double mean = 0;
        for (int y = 0; y < 8; ++y) {
            for (int x = 0; x < 8; ++x) mean += image.at(x, y)[0] / 64.0;
        }
        return mean;
    }
};

TEST_F(TiltedPlate, ConvergesToTheIntegral) {
    const Environment environment = sky_environment(128);
    const glm::vec3 eye(-1.5f, 0.4f, 3.0f);
    const vec3 wo = f64::normalize(to_f64(eye));
    for (const Method method :
         {Method::normal_map, Method::follow_grain, Method::rotate_approx, Method::deform_linear}) {
        const double mean = seen_from(eye, white_metal(method, {0.15f, 0.4f}), environment);
        const f64::Lobe lobe = f64::lobe_from_alpha(f64::kMdfGgx, double{0.15f}, double{0.4f});
        const f64::Perturbation p =
            f64::perturb_make(static_cast<int>(method), to_f64(kTilt),
                              f64::lobe_grooves_along_x(lobe.mdf, lobe.p0, lobe.p1), false);
        const double wanted = quadrature(
            [&](vec3 wi) {
                return f64::brdf_eval(f64::kBrdfMicrofacet, lobe, p, wi, wo) * sky(wi);
            },
            p.n);
        EXPECT_NEAR(mean / wanted, 1.0, 0.015) << name_of(method);
    }
}

TEST_F(TiltedPlate, CosineLobesConvergeToTheIntegral) {
    const Environment environment = sky_environment(128);
    const glm::vec3 eye(-1.5f, 0.4f, 3.0f);
    const vec3 wo = f64::normalize(to_f64(eye));
    for (const Brdf brdf : {Brdf::phong, Brdf::lafortune}) {
        for (const Method method :
             {Method::normal_map, Method::follow_grain, Method::rotate_approx}) {
            Material m = white_metal(method, {0.2f, 0.3f});
            m.brdf = brdf;
            m.lafortune_c = {-1.0f, -0.7f, 0.9f};
            const f64::Perturbation p =
                f64::perturb_make(static_cast<int>(method), to_f64(kTilt), true, false);
            const f64::CosineLobe lobe =
                f64::cosine_lobe_make(static_cast<int>(brdf), -1, to_f64(m.lafortune_c),
                                      f64::cosine_exponent_from_alpha(double{0.2f}, double{0.3f}));
            const double wanted = quadrature(
                [&](vec3 wi) { return f64::cosine_lobe_eval(lobe, p, wi, wo) * sky(wi); }, p.n);
            EXPECT_NEAR(seen_from(eye, m, environment) / wanted, 1.0, 0.015)
                << name_of(brdf) << " " << name_of(method);
        }
    }
}

// The 2000 model of Ashikhmin and Shirley with its diffuse term in constant light: the sum of both
// terms by quadrature, and at most 1. The specular term alone gains no energy either.
TEST_F(TiltedPlate, CoupledDiffuseTermInAFurnace) {
    const Environment furnace = constant_environment(glm::vec3(1));
    Material m;
    m.metallic = 0.0f;
    m.brdf = Brdf::ashikhmin_shirley;
    m.lobe = AlphaLobe{{0.3f, 0.5f}};
    for (const float f0 : {0.0f, 0.04f, 0.5f}) {
        m.dielectric_f0 = f0;
        for (const glm::vec3 eye :
             {glm::vec3(0, 0, 3), glm::vec3(-1.5f, 0.4f, 3), glm::vec3(3, 0, 1)}) {
            const vec3 wo = f64::normalize(to_f64(eye));
            const f64::Lobe lobe =
                f64::lobe_from_alpha(f64::kMdfAshikhminShirley, double{0.3f}, double{0.5f});
            const f64::Perturbation p =
                f64::perturb_make(f64::kMethodFollowGrain, to_f64(kTilt), true, false);
            const double wanted = quadrature(
                [&](vec3 wi) {
                    const double cos_h = f64::length(wi + wo) / 2;
                    return f64::brdf_eval(f64::kBrdfAshikhminShirley, lobe, p, wi, wo) *
                               f64::fresnel_schlick(double{f0}, cos_h) +
                           f64::ashikhmin_shirley_diffuse(1, double{f0}, f64::dot(p.n, wi),
                                                          f64::dot(p.n, wo));
                },
                p.n);
            const double found = seen_from(eye, m, furnace);
            EXPECT_NEAR(found / wanted, 1.0, 0.01) << f0 << " from " << eye.x;
            EXPECT_LT(found, 1.0) << f0 << " from " << eye.x;
        }
    }
}

TEST_F(ImageLighting, TheNumberOfSamplesChangesNoiseOnly) {
    const Environment environment = sky_environment(128);
    const Scene scene = one_object(uv_sphere(48, 24), white_metal(Method::none, {0.2f, 0.4f}));
    double means[3] = {};
    const int samples[3] = {1, 4, 32};
    for (int k = 0; k < 3; ++k) {
        const Image image = render(scene, environment, small_picture(24, 24, samples[k]));
        for (const float v : image.pixels) means[k] += v;
    }
    EXPECT_NEAR(means[0] / means[2], 1.0, 0.03);
    EXPECT_NEAR(means[1] / means[2], 1.0, 0.02);
}

// The lobe of normal-map is sampled as a mixture, and a third number chooses the part. Where it depends on the place of
// a point within its lattice, the noise stays as the samples grow.
TEST_F(ImageLighting, NoiseOfAMixtureFallsWithTheSamples) {
    const Environment environment = sky_environment(128);
    Scene scene = one_object(uv_sphere(48, 24), white_metal(Method::normal_map, {0.1f, 0.5f}));
    scene.textures = {bump_texture(32, 4, 0.3f)};
    scene.materials[0].normal_texture.texture = 0;
    const auto difference = [&](int samples) {
        RenderSettings o = small_picture(64, 64, samples);
        o.seed = 1;
        const Image a = render(scene, environment, o);
        o.seed = 2;
        const Image b = render(scene, environment, o);
        double sum = 0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i) {
            const double d = static_cast<double>(a.pixels[i]) - static_cast<double>(b.pixels[i]);
            sum += d * d;
        }
        return std::sqrt(sum);
    };
    // Measured: 0.28; 1/sqrt(8) of random numbers. With the index it was 0.9.
    EXPECT_LT(difference(64) / difference(8), 0.4);
}

TEST_F(ImageLighting, DiffuseInConstantLightHasAClosedForm) {
    Material m;
    m.metallic = 0.0f;
    m.base_color = glm::vec4(0.5f, 0.5f, 0.5f, 1.0f);
    m.dielectric_f0 = 0.0f;
    const Scene scene = one_object(unit_plane(), m);
    RenderSettings o = small_picture(9, 9);
    // No noise; its specular term is the same without F0 .
    o.image_light = ImageLight::bent_normal;
    const Image image = render(scene, constant_environment(glm::vec3(3)), o, camera_on_z(4, 0.05f));
    // ... except for the edge term of the split sum, below 0.05 at normal incidence.
    EXPECT_NEAR(image.at(4, 4)[0], 3 * (0.5 * 20.0 / 21.0), 3 * 0.05);
}

TEST_F(ImageLighting, BackgroundLooksAlongTheRay) {
    const Environment environment = sky_environment(256);
    const Scene scene = one_object(unit_plane(), Material{});
    Camera camera = camera_on_z(4.0f, 2.0f);
    camera.position = {10, 10, 10};
    camera.target = {20, 14, 16};  // away from the plane
    RenderSettings o = small_picture(33, 17);
    o.background = BackgroundKind::environment;
    const Image image = render(scene, environment, o, camera);
    const vec3 forward = f64::normalize(vec3{10, 4, 6});
    EXPECT_NEAR(image.at(16, 8)[0], sky(forward), 0.02 * sky(forward));
    // The right edge looks to the right: forward x up.
    const vec3 right = f64::normalize(f64::cross(forward, vec3{0, 1, 0}));
    const double reach = std::tan(0.5 * camera.yfov) * 32.0 / 17.0;
    const vec3 edge = f64::normalize(forward + right * reach);
    EXPECT_NEAR(image.at(32, 8)[0], sky(edge), 0.02 * sky(edge));
}

TEST_F(ImageLighting, RotationTurnsTheEnvironmentCounterClockwise) {
    const Environment environment = sky_environment(256);
    const Scene scene = one_object(unit_plane(), Material{});
    Camera camera;
    camera.position = {0, 0, -5};  // behind the plane, looking away along -z
    camera.target = {0, 0, -6};
    RenderSettings o = small_picture(9, 9);
    o.background = BackgroundKind::environment;
    o.environment_rotation = 0.5f;
    const Image image = render(scene, environment, o, camera);
    // After a rotation about +y by 0.5, the direction R(-0.5) (0,0,-1) of the map is straight
    // ahead.
    const vec3 source{std::sin(0.5), 0, -std::cos(0.5)};
    EXPECT_NEAR(image.at(4, 4)[0], sky(source), 0.02 * sky(source));
}

TEST_F(ImageLighting, ASunBeyondHalfFloatsIsKept) {
    Environment environment = constant_environment(glm::vec3(0.0f), 64);
    for (int y = 8; y < 24; ++y) {
        for (int x = 24; x < 40; ++x) {
            for (int c = 0; c < 3; ++c) environment.radiance.at(x, y)[c] = 4e6f;
        }
    }
    Material m;
    m.metallic = 0.0f;
    m.base_color = glm::vec4(1e-3f, 1e-3f, 1e-3f, 1.0f);
    m.dielectric_f0 = 0.0f;
    m.method = Method::none;
    const Scene scene = one_object(unit_plane(), m);
    Camera camera = camera_on_z(4, 0.05f);
    camera.position = {0, 0, -4};  // the sun is around -z
    Scene flipped = scene;
    flipped.materials[0].double_sided = true;
    RenderSettings o = small_picture(5, 5);
    o.image_light = ImageLight::bent_normal;
    o.image_light_samples = 1;
    const Image image = render(flipped, environment, o, camera);
    EXPECT_GT(image.at(2, 2)[0], 200.0f);  // E/pi is about 10^5.5 times 1e-3
    EXPECT_LE(image.at(2, 2)[0], 65504.0f);
}

}  // namespace
}  // namespace burnish::test
