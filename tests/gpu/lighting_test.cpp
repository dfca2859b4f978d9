// Punctual lights against the maths in double precision, evaluated at single pixels on the CPU.
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <optional>

#include "burnish/conductors.hpp"
#include "burnish/f64.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/renderer.hpp"
#include "core/constants.hpp"
#include "gpu_fixture.hpp"
#include "models/spectra/metal_reflectance.hpp"
#include "scene/material/material_values.hpp"
#include "test_scene.hpp"

namespace burnish::test {
namespace {

using f64::vec3;

vec3 to_f64(glm::vec3 v) {
    return {v.x, v.y, v.z};
}

struct Case {
    Mdf mdf;
    Brdf brdf;
    Method method;
    glm::vec2 alpha;
    glm::vec3 n;  // perturbed normal in the axes of tangent, bitangent, normal
    std::optional<float> ks{};
};

const glm::vec3 kCoefficients(-0.9f, -0.6f, 0.8f);

double specular(const Case& c, const f64::Lobe& lobe, const f64::Perturbation& p, vec3 wi,
                vec3 wo) {
    const int brdf = static_cast<int>(c.brdf);
    if (has_half_vectors(c.brdf)) return f64::brdf_eval(brdf, lobe, p, wi, wo);
    const double n = f64::cosine_exponent_from_alpha(c.alpha.x, c.alpha.y);
    const f64::CosineLobe cosine =
        f64::cosine_lobe_make(brdf, c.ks ? double{*c.ks} : -1.0, to_f64(kCoefficients), n);
    return f64::cosine_lobe_eval(cosine, p, wi, wo);
}

// Radiance at a point of the test plane, whose tangent space is world space, for a metal of F0.
double expected(const Case& c, vec3 wi, vec3 wo, double irradiance, double f0) {
    const int brdf = static_cast<int>(c.brdf);
    const int mdf = f64::brdf_mdf(brdf, static_cast<int>(c.mdf));
    const f64::Lobe lobe = f64::lobe_from_alpha(mdf, c.alpha.x, c.alpha.y);
    const f64::Perturbation p =
        f64::perturb_make(static_cast<int>(c.method), f64::normalize(to_f64(c.n)),
                          f64::lobe_grooves_along_x(mdf, lobe.p0, lobe.p1), false);
    const vec3 h = f64::normalize(wi + wo);
    return specular(c, lobe, p, wi, wo) * f64::fresnel_schlick(f0, f64::dot(wi, h)) *
           std::max(f64::dot(p.n, wi), 0.0) * irradiance;
}

class Lighting : public GpuTest {
  protected:
    // The intersection of a pixel's ray with the plane z = 0.
    static vec3 point_at(const Camera& camera, const RenderSettings& o, int x, int y) {
        const double half = std::tan(0.5 * camera.yfov) * camera.position.z;
        return {half * ((x + 0.5) * 2 / o.width - 1) * o.width / o.height,
                half * (1 - (y + 0.5) * 2 / o.height), 0};
    }

    void check(const Case& c, const Light& light, SurfacePass pass) {
        Material m;
        m.base_color = glm::vec4(0.8f, 0.8f, 0.8f, 1.0f);
        m.mdf = c.mdf;
        m.brdf = c.brdf;
        m.method = c.method;
        m.single_scattering = true;
        m.lobe = AlphaLobe{c.alpha};
        m.ks = c.ks;
        m.lafortune_c = kCoefficients;
        m.normal_texture.texture = 0;
        Scene scene = one_object(unit_plane(), m);
        scene.textures.push_back(constant_texture(0.5f * glm::normalize(c.n) + 0.5f));
        scene.lights.push_back(light);
        const Camera camera = camera_on_z(3.0f);
        RenderSettings o = small_picture(16, 16);
        o.surface_pass = pass;
        gpu::Renderer renderer(*context, scene, nullptr);
        const Image image = renderer.render(camera, o);
        double largest = 0;
        for (const int y : {1, 5, 8, 14}) {
            for (const int x : {2, 7, 9, 13})
                largest = std::max(largest, double{image.at(x, y)[0]});
        }
        for (const int y : {1, 5, 8, 14}) {
            for (const int x : {2, 7, 9, 13}) {
                const vec3 at = point_at(camera, o, x, y);
                const vec3 wo = f64::normalize(to_f64(camera.position) - at);
                vec3 wi = to_f64(-light.direction);
                double irradiance = light.intensity;
                if (light.type != LightType::directional) {
                    const vec3 d = to_f64(light.position) - at;
                    wi = f64::normalize(d);
                    irradiance *= factor(light, wi, f64::dot(d, d));
                }
                const double wanted = expected(c, wi, wo, irradiance, 0.8);
                // 4e-3 is twice the errors of the tangents of the deferred pass, 7e-4 rad, and of
                // llvmpipe's pow and exp, 1e-5 of the exponent. 1e-4 of the brightest value for
                // values near 0.
                EXPECT_NEAR(image.at(x, y)[0], wanted, 4e-3 * wanted + 1e-4 * largest)
                    << name_of(c.mdf) << " " << name_of(c.brdf) << " " << name_of(c.method)
                    << " at " << x << "," << y;
            }
        }
    }

    // Attenuation by KHR_lights_punctual.
    static double factor(const Light& light, vec3 wi, double d2) {
        double f = 1 / d2;
        if (light.range > 0) {
            const double r = d2 / (double{light.range} * light.range);
            f *= std::clamp(1 - r * r, 0.0, 1.0);
        }
        if (light.type == LightType::spot) {
            const double cosine = -f64::dot(wi, to_f64(light.direction));
            const double inner = std::cos(double{light.inner_cone});
            const double outer = std::cos(double{light.outer_cone});
            const double t = std::clamp((cosine - outer) / (inner - outer), 0.0, 1.0);
            f *= t * t;
        }
        return f;
    }
};

const glm::vec3 kTilt(0.25f, -0.2f, 1.0f);

TEST_F(Lighting, EveryMethodGivesTheValueOfTheMaths) {
    for (int method = 0; method < static_cast<int>(method_names().size()); ++method) {
        const Case c{Mdf::ggx, Brdf::microfacet, static_cast<Method>(method), {0.4f, 0.15f}, kTilt};
        const Light light = directional({0.5f, -0.3f, 1.0f});
        check(c, light, SurfacePass::forward);
        check(c, light, SurfacePass::deferred);
    }
}

TEST_F(Lighting, EveryLobeGivesTheValueOfTheMaths) {
    for (int brdf = 0; brdf <= static_cast<int>(Brdf::cook_torrance); ++brdf) {
        for (int mdf = 0; mdf < static_cast<int>(mdf_names().size()); ++mdf) {
            const Case c{static_cast<Mdf>(mdf),
                         static_cast<Brdf>(brdf),
                         Method::follow_grain,
                         {0.2f, 0.5f},
                         kTilt};
            check(c, directional({0.5f, -0.3f, 1.0f}), SurfacePass::forward);
        }
    }
}

TEST_F(Lighting, CosineLobesGiveTheValueOfTheMaths) {
    for (const Brdf brdf : {Brdf::phong, Brdf::lafortune}) {
        for (int method = 0; method < static_cast<int>(Method::deform_linear); ++method) {
            Case c{Mdf::ward, brdf, static_cast<Method>(method), {0.3f, 0.2f}, kTilt};
            check(c, directional({0.5f, -0.3f, 1.0f}), SurfacePass::forward);
            c.ks = 2.5f;
            check(c, directional({0.5f, -0.3f, 1.0f}), SurfacePass::deferred);
        }
    }
}

TEST_F(Lighting, PointAndSpotLightsFallOffAsTheExtensionSays) {
    const Case c{Mdf::beckmann, Brdf::microfacet, Method::rotate_arc, {0.3f, 0.6f}, kTilt};
    Light light;
    light.type = LightType::point;
    light.position = {0.6f, 0.4f, 1.2f};
    light.range = 2.0f;
    light.intensity = 5.0f;
    check(c, light, SurfacePass::forward);
    check(c, light, SurfacePass::deferred);
    light.type = LightType::spot;
    light.direction = glm::normalize(glm::vec3(-0.3f, -0.4f, -1.0f));
    light.inner_cone = 0.2f;
    light.outer_cone = 0.6f;
    check(c, light, SurfacePass::forward);
    check(c, light, SurfacePass::deferred);
}

TEST_F(Lighting, DiffuseIsWhatTheHeaderStates) {
    Material m;
    m.metallic = 0.0f;
    m.base_color = glm::vec4(0.5f, 0.25f, 1.0f, 1.0f);
    m.lobe = AlphaLobe{glm::vec2(0.001f)};  // a highlight far from the tested pixel
    Scene scene = one_object(unit_plane(), m);
    const glm::vec3 towards = glm::normalize(glm::vec3(1.0f, 0.0f, 1.0f));
    scene.lights.push_back(directional(towards));
    gpu::Renderer renderer(*context, scene, nullptr);
    const Camera camera = camera_on_z(3.0f);
    const Image image = renderer.render(camera, small_picture(16, 16));
    const vec3 at = point_at(camera, small_picture(16, 16), 8, 8);
    const double cos_o = f64::normalize(to_f64(camera.position) - at).z;
    const double each = towards.z / kPi * (1 - f64::fresnel_schlick(0.04, double{towards.z})) *
                        (1 - f64::fresnel_schlick(0.04, cos_o));
    EXPECT_NEAR(image.at(8, 8)[0], 0.5 * each, 1e-4);
    EXPECT_NEAR(image.at(8, 8)[1], 0.25 * each, 1e-4);
    EXPECT_NEAR(image.at(8, 8)[2], 1.0 * each, 1e-4);
}

// With the diffuse term of the 2000 model under a tilted normal, only the cosines to n~ count.
TEST_F(Lighting, AshikhminShirleyBringsItsDiffuseTerm) {
    Material m;
    m.metallic = 0.25f;
    m.base_color = glm::vec4(0.5f, 0.25f, 1.0f, 1.0f);
    m.dielectric_f0 = 0.2f;
    m.brdf = Brdf::ashikhmin_shirley;
    m.lobe = AlphaLobe{glm::vec2(0.001f)};  // a highlight far from the tested pixel
    m.normal_texture.texture = 0;
    for (const Method method : {Method::follow_grain, Method::normal_map, Method::deform_smooth}) {
        m.method = method;
        Scene scene = one_object(unit_plane(), m);
        scene.textures.push_back(constant_texture(0.5f * glm::normalize(kTilt) + 0.5f));
        const glm::vec3 towards = glm::normalize(glm::vec3(1.0f, 0.4f, 1.0f));
        scene.lights.push_back(directional(towards));
        gpu::Renderer renderer(*context, scene, nullptr);
        const Camera camera = camera_on_z(3.0f);
        const Image image = renderer.render(camera, small_picture(16, 16));
        const vec3 n = f64::normalize(to_f64(kTilt));
        const vec3 at = point_at(camera, small_picture(16, 16), 8, 8);
        const double cos_o = f64::dot(n, f64::normalize(to_f64(camera.position) - at));
        const double cos_i = f64::dot(n, to_f64(towards));
        const auto through = [](double c) { return 1 - std::pow(1 - c / 2, 5); };
        const double each =
            28 / (23 * kPi) * (1 - 0.2) * through(cos_i) * through(cos_o) * cos_i * 0.75;
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(image.at(8, 8)[c], double{m.base_color[c]} * each, 2e-4) << name_of(method);
    }
}

TEST_F(Lighting, ConductorsReflectTheirNormalReflectance) {
    Material m;
    m.single_scattering = true;
    m.lobe = AlphaLobe{glm::vec2(0.3f)};
    m.conductor = Conductor{{0.2f, 0.5f, 1.4f}, {3.9f, 2.4f, 1.6f}};
    Scene scene = one_object(unit_plane(), m);
    scene.lights.push_back(directional({0, 0, 1}));
    gpu::Renderer renderer(*context, scene, nullptr);
    const Image image = renderer.render(camera_on_z(3.0f, 0.1f), small_picture(9, 9));
    for (int c = 0; c < 3; ++c) {
        const double n = m.conductor->eta[c], k = m.conductor->k[c];
        const double f = ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
        const double wanted = f / (4 * kPi * 0.09);  // D(n) = 1/(pi alpha^2), G = 1
        EXPECT_NEAR(image.at(4, 4)[c], wanted, 1e-3 * wanted);
    }
}

// Under 50 nm of oxide titanium is blue: of light from above and, as the curve says, of light that
// meets the surface at 60 degrees.
TEST_F(Lighting, FilmsReflectTheirColorsAtAllAngles) {
    Material m;
    m.single_scattering = true;
    m.lobe = AlphaLobe{glm::vec2(0.3f)};
    m.conductor = conductor_preset("titanium");
    m.conductor->oxide = oxide_film("titanium", 50);
    for (const double degrees : {0.0, 60.0}) {
        // The camera looks along the normal: light and view enclose twice the angle to the half vector.
        const double angle = glm::radians(degrees), half = 0.5 * angle;
        Scene scene = one_object(unit_plane(), m);
        scene.lights.push_back(directional({std::sin(angle), 0, std::cos(angle)}));
        gpu::Renderer renderer(*context, scene, nullptr);
        const Image image = renderer.render(camera_on_z(3.0f, 0.01f), small_picture(9, 9));
        const auto values = material_values<f64::SurfaceMaterial>(m);
        const f64::Perturbation p = f64::perturb_make(f64::kMethodNone, {0, 0, 1}, true, false);
        const f64::vec3 wi{std::sin(angle), 0, std::cos(angle)};
        const double shape =
            f64::specular_eval(values.surface, p, f64::no_lobe_values(), wi, {0, 0, 1}) * wi.z;
        const glm::dvec3 f = MetalReflectance("titanium", 50).held_color(std::cos(half));
        for (int c = 0; c < 3; ++c)  // 0.01: of the curve
            EXPECT_NEAR(image.at(4, 4)[c], shape * f[c], 0.01 * shape) << degrees << " " << c;
    }
}

TEST_F(Lighting, RefusesMoreLightsThanItHasRoomFor) {
    Scene scene = one_object(unit_plane(), Material{});
    scene.lights.assign(17, directional({0, 0, 1}));
    EXPECT_THROW(gpu::Renderer(*context, scene, nullptr), Error);
    scene.lights.resize(16);
    gpu::Renderer renderer(*context, scene, nullptr);
    const Image sixteen = renderer.render(camera_on_z(), small_picture(8, 8));
    scene.lights.resize(1);
    gpu::Renderer single(*context, scene, nullptr);
    const Image one = single.render(camera_on_z(), small_picture(8, 8));
    EXPECT_NEAR(sixteen.at(4, 4)[0], 16 * one.at(4, 4)[0], 1e-3f * sixteen.at(4, 4)[0]);
}

}  // namespace
}  // namespace burnish::test
