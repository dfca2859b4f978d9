// Pixels of the renderer against surface_eval on the CPU: one plane under one light, every method
// with every kind of lobe, diffuse and specular together.
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "burnish/conductors.hpp"
#include "burnish/draft.hpp"
#include "burnish/f32.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/renderer.hpp"
#include "gpu_fixture.hpp"
#include "maps/weave/weave_cells.hpp"
#include "models/albedo_table.hpp"
#include "scene/material/material_values.hpp"
#include "tabulated_scenes.hpp"
#include "test_scene.hpp"

namespace burnish::test {
namespace {

using f32::vec2;
using f32::vec3;

constexpr std::array<unsigned char, 3> kTexel = {160, 105, 230};  // a tilt of 26 degrees
constexpr float kRotation = 0.4f;
const glm::vec3 kTowards(0.5f, 0.1f, 1.0f);

// Relative errors, plus 0.01 absolute. Measured on llvmpipe: at most 8e-7; 2.7e-5 for tables, whose
// places the CPU computes here by atan2 and the shader by its polynomial. The bounds are three to
// four times that.
constexpr double kBound = 3e-6, kTableBound = 1e-4;
// Where the table of albedos is read, which the renderer has as half floats: measured 4e-4.
constexpr double kCompensatedBound = 1e-3;

vec3 of(glm::vec3 v) {
    return {v.x, v.y, v.z};
}

vec2 at_angle(float angle) {
    return {std::cos(angle), std::sin(angle)};
}

// 8-bit codes, so that the CPU has the texture's values exactly.
Texture normal_texel() {
    Texture t;
    t.name = "one normal";
    t.width = t.height = 1;
    t.channels = 3;
    t.type = TexelType::u8;
    for (const unsigned char code : kTexel) t.texels.push_back(static_cast<std::byte>(code));
    return t;
}

vec3 mapped_normal() {
    const vec3 texel{kTexel[0] / 255.0f, kTexel[1] / 255.0f, kTexel[2] / 255.0f};
    return f32::normal_of_vector(f32::vector_of_texel(texel), {1, 1});
}

Material material_of(Brdf brdf, Mdf mdf, Method method) {
    Material m;
    m.base_color = glm::vec4(0.7f, 0.5f, 0.3f, 1.0f);
    m.metallic = 0.25f;
    m.dielectric_f0 = 0.05f;
    m.brdf = brdf;
    m.mdf = mdf;
    m.method = method;
    m.conserve = true;
    m.lobe = AlphaLobe{{0.2f, 0.45f}};
    m.lafortune_c = glm::vec3(-0.9f, -0.6f, 0.8f);
    m.anisotropy_rotation = kRotation;
    m.normal_texture.texture = 0;
    m.normal_filter = NormalFilter::mips;
    return m;
}

// Arguments of the CPU's evaluation at a point of the plane.
struct Point {
    f32::SurfaceMaterial surface;
    f32::Perturbation p;
    f32::LobeValues values;
    vec3 wi, wo;
};

f32::SurfaceMaterial compensated_towards(const Material& m, const f32::SurfaceMaterial& surface,
                                         const Point& point) {
    const f32::AlbedoPlace at = f32::albedo_place_of(surface.lobe, point.p, point.wo);
    f64::AlbedoPlace place;
    place.at = {double{at.at.x}, double{at.at.y}, double{at.at.z}};
    place.mixed = double{at.mixed};
    const double albedo = albedo_table(m.brdf, m.mdf)->at(place);
    return f32::surface_compensated(surface, static_cast<float>(albedo));
}

// `stretch`: direction of the lobe's x axis relative to the tangent; `n`: in the plane's axes.
Point point_of(const Material& m, const f32::SurfaceMaterial& surface, vec3 n, vec2 stretch,
               bool grooves_along_x, vec3 wi, vec3 wo) {
    Point point;
    point.surface = surface;
    point.wi = f32::seen_from_rotated(wi, stretch);
    point.wo = f32::seen_from_rotated(wo, stretch);
    point.p = f32::surface_perturbation(static_cast<int>(drawn_method(m)), n, stretch,
                                        grooves_along_x, m.conserve, point.wo);
    point.values = f32::no_lobe_values();
    if (is_compensated(m)) point.surface = compensated_towards(m, surface, point);
    return point;
}

f32::SurfaceMaterial surface_of(const Material& m, glm::vec3 base_color) {
    f32::SurfaceMaterial surface =
        f32::surface_material(static_cast<int>(m.brdf), lobe_of(m), m.ks.value_or(-1.0f),
                              of(m.lafortune_c), m.dielectric_f0);
    surface.has_diffuse = true;
    return f32::surface_colored(surface, of(base_color), m.metallic);
}

class SurfacePixels : public GpuTest {
  protected:
    // `point_at(u, v, wi, wo)`: the Point at texture coordinates.
    template <typename PointAt>
    void compare(const Material& material, const std::string& what, double bound,
                 const PointAt& point_at) {
        Scene scene = one_object(unit_plane(), material);
        scene.textures.push_back(normal_texel());
        scene.lights.push_back(directional(kTowards));
        const Camera camera = camera_on_z(3.0f);
        RenderSettings o = small_picture(16, 16);
        o.surface_pass = SurfacePass::forward;
        o.filter_cloth = false;
        gpu::Renderer renderer(*context, scene, nullptr);
        const Image image = renderer.render(camera, o);
        const double half = std::tan(0.5 * double{camera.yfov}) * double{camera.position.z};
        const vec3 wi = of(glm::normalize(kTowards));
        double worst = 0;
        for (const int y : {1, 5, 8, 14}) {
            for (const int x : {2, 6, 9, 13}) {
                const vec3 at(static_cast<float>(half * ((x + 0.5) / 8 - 1)),
                              static_cast<float>(half * (1 - (y + 0.5) / 8)), 0.0f);
                const vec3 wo = f32::normalize(vec3(0, 0, 3) - at);
                const Point q = point_at(0.5f + 0.5f * at.x, 0.5f + 0.5f * at.y, wi, wo);
                const vec3 f = f32::surface_eval(q.surface, q.p, q.values, q.wi, q.wo) *
                               std::max(f32::dot(q.p.n, q.wi), 0.0f);
                const float wanted[] = {f.x, f.y, f.z};
                for (int c = 0; c < 3; ++c) {
                    const double error =
                        std::abs(image.at(x, y)[c] - wanted[c]) / (std::abs(wanted[c]) + 0.01);
                    worst = std::max(worst, error);
                }
            }
        }
        if (std::getenv("BURNISH_PRINT_PARITY") != nullptr)
            std::printf("pixel %-40s %.1e\n", what.c_str(), worst);
        EXPECT_LT(worst, bound) << what;
    }
};

std::string named(std::string_view kind, int method) {
    return std::string(kind) + " " + std::string(name_of(static_cast<Method>(method)));
}

TEST_F(SurfacePixels, EveryModelUnderEveryMethod) {
    for (int kind = 0; kind <= f32::kBrdfLafortune + f32::kMdfGgx; ++kind) {
        const bool plain = kind < f32::kMdfGgx;
        const auto mdf = static_cast<Mdf>(plain ? kind : f32::kMdfGgx);
        const auto brdf = static_cast<Brdf>(plain ? 0 : kind - f32::kMdfGgx);
        for (int method = 0; method < static_cast<int>(method_names().size()); ++method) {
            if (!f32::brdf_takes_method(static_cast<int>(brdf), method)) continue;
            Material m = material_of(brdf, mdf, static_cast<Method>(method));
            m.single_scattering = true;
            const f32::SurfaceMaterial surface = surface_of(m, glm::vec3(m.base_color));
            const bool along_x =
                f32::lobe_grooves_along_x(surface.lobe.mdf, surface.lobe.p0, surface.lobe.p1);
            compare(m, named(plain ? name_of(mdf) : name_of(brdf), method), kBound,
                    [&](float, float, vec3 wi, vec3 wo) {
                        return point_of(m, surface, mapped_normal(), at_angle(kRotation), along_x,
                                        wi, wo);
                    });
        }
    }
}

TEST_F(SurfacePixels, LightThatFacetsReflectMoreThanOnce) {
    for (const Mdf mdf : {Mdf::ashikhmin_shirley, Mdf::ward, Mdf::beckmann, Mdf::ggx}) {
        for (int method = 0; method < static_cast<int>(method_names().size()); ++method) {
            Material m = material_of(Brdf::microfacet, mdf, static_cast<Method>(method));
            m.lobe = AlphaLobe{{0.3f, 0.9f}};
            m.metallic = 0.9f;
            const f32::SurfaceMaterial surface = surface_of(m, glm::vec3(m.base_color));
            compare(m, named(name_of(mdf), method), kCompensatedBound,
                    [&](float, float, vec3 wi, vec3 wo) {
                        return point_of(m, surface, mapped_normal(), at_angle(kRotation), true, wi,
                                        wo);
                    });
        }
    }
}

TEST_F(SurfacePixels, AMetalBareAndUnderAFilm) {
    for (const bool film : {false, true}) {
        Material m = material_of(Brdf::microfacet, Mdf::ggx, Method::follow_grain);
        m.single_scattering = true;
        m.conductor = conductor_preset("titanium");
        if (film) m.conductor->oxide = oxide_film("titanium", 145);
        const f32::SurfaceMaterial surface = material_values<f32::SurfaceMaterial>(m).surface;
        const bool along_x =
            f32::lobe_grooves_along_x(surface.lobe.mdf, surface.lobe.p0, surface.lobe.p1);
        compare(m, film ? "film" : "bare", kBound, [&](float, float, vec3 wi, vec3 wo) {
            return point_of(m, surface, mapped_normal(), at_angle(kRotation), along_x, wi, wo);
        });
    }
}

TEST_F(SurfacePixels, TabulatedUnderEveryMethod) {
    constexpr float kAngle = 0.3f, kGroove = 0.7f;
    TabulatedMaterial t = blank_material({24, 80}, 1, 1);
    add_exemplar(t, ggx_table(t.grid, 0.2, 0.5, 0.7), kGroove);
    t.eta = 1.5;
    t.angle[0] = kAngle;
    t.diffuse.pixels = {0.25f, 0.125f, 0.5f};
    t.specular.pixels = {0.5f, 0.25f, 0.75f};
    const std::vector<float> areas = ndf_areas(t.grid, t.table(0));
    for (int method = 0; method < static_cast<int>(method_names().size()); ++method) {
        Material m = material_of(Brdf::microfacet_separable, Mdf::ggx, static_cast<Method>(method));
        m.metallic = 0.0f;
        m.lobe = Tabulated{std::make_shared<const TabulatedMaterial>(t), {}};
        f32::SurfaceMaterial surface =
            f32::surface_material(f32::kBrdfTabulated, lobe_of(m), -1.0f, {}, m.dielectric_f0);
        surface.fresnel = f32::kFresnelDielectric;
        surface.eta.x = 1.5f;
        surface.k.x = f32::fresnel_inverse_at_normal(1.5f);
        surface.has_diffuse = true;
        surface.diffuse = {0.25f, 0.125f, 0.5f};
        surface.specular = {0.5f, 0.25f, 0.75f};
        const float groove = method == f32::kMethodFollowGrain ? kGroove : 0.0f;
        // The look-ups of the library, by angles.
        const auto area = [&](vec3 w) {
            const float l = f32::length(w), c = std::cos(groove), s = std::sin(groove);
            return l * ndf_area_lookup(areas.data(), (w.x * c - w.y * s) / l,
                                       (w.y * c + w.x * s) / l, w.z / l);
        };
        compare(m, named("tabulated", method), kTableBound, [&](float, float, vec3 wi, vec3 wo) {
            Point q = point_of(m, surface, mapped_normal(), at_angle(kAngle + groove + kRotation),
                               true, wi, wo);
            const vec3 h = f32::half_vector(q.wi + q.wo, q.p.n);
            const f32::LobePoint at = f32::lobe_point_unit(f32::perturb_point(q.p, h));
            const float u = std::sqrt(2 / kPiF * std::atan2(std::sqrt(at.s2), at.z));
            q.values.D =
                at.weight * ndf_lookup(t.grid, t.table(0), u, std::atan2(at.y, at.x) + groove);
            q.values.area_i = area(f32::perturb_direction(q.p, q.wi));
            q.values.area_o = area(f32::perturb_direction(q.p, q.wo));
            return q;
        });
    }
}

// A yarn at a point: the direction of its fibers is the stretch, its normal the perturbed normal.
TEST_F(SurfacePixels, YarnsUnderEveryMethod) {
    for (int method = 0; method < static_cast<int>(method_names().size()); ++method) {
        for (const Brdf brdf : {Brdf::microfacet, Brdf::phong}) {
            if (!f32::brdf_takes_method(static_cast<int>(brdf), method)) continue;
            Material m = material_of(brdf, Mdf::ggx, static_cast<Method>(method));
            m.normal_texture = {};
            m.anisotropy_rotation = 0.0f;
            Cloth cloth;
            cloth.draft = std::make_shared<Draft>(builtin_draft("twill-2-2"));
            cloth.yarns = 5.0f;
            cloth.warp_color = glm::vec3(0.6f, 0.5f, 0.3f);
            cloth.weft_color = glm::vec3(0.05f, 0.1f, 0.3f);
            cloth.alpha = *stated_alpha(m);
            m.lobe = cloth;
            const f32::WeaveShape shape{cloth.crimp, cloth.bulge, cloth.gap, at_angle(cloth.twist)};
            const f32::Lobe lobe = lobe_of(m);
            const bool along_x = f32::lobe_grooves_along_x(lobe.mdf, lobe.p0, lobe.p1);
            compare(m, named("yarn " + std::string(name_of(brdf)), method), kBound,
                    [&](float u, float v, vec3 wi, vec3 wo) {
                        const float x = u * cloth.yarns, y = v * cloth.yarns;
                        const f32::WeaveCell cell =
                            weave_cell(*cloth.draft, static_cast<int>(std::floor(x)),
                                       static_cast<int>(std::floor(y)));
                        const f32::WeavePoint yarn = f32::weave_point(
                            cell, shape, x - std::floor(x) - 0.5f, y - std::floor(y) - 0.5f);
                        const glm::vec3 color =
                            yarn.warp > 0.5f ? *cloth.warp_color : *cloth.weft_color;
                        Point q = point_of(m, surface_of(m, color * yarn.cover), yarn.n, yarn.fiber,
                                           along_x, wi, wo);
                        if (yarn.cover < 0.5f) q.surface.specular = q.surface.diffuse = {0, 0, 0};
                        return q;
                    });
        }
    }
}

}  // namespace
}  // namespace burnish::test
