#include "scene/material/material_values.hpp"

#include <cmath>
#include <glm/common.hpp>

#include "burnish/tabulated_material.hpp"

namespace burnish {
namespace {

// One word for both precisions: the type of the arguments chooses. Functions that take a structure
// of shading/ are found by it.
using f32::coat_depth, f64::coat_depth;
using f32::fresnel_inverse_at_normal, f64::fresnel_inverse_at_normal;
using f32::lobe_from_alpha, f64::lobe_from_alpha;
using f32::lobe_grooves_along_x, f64::lobe_grooves_along_x;
using f32::lobe_of_roughness, f64::lobe_of_roughness;
using f32::sheen_make, f64::sheen_make;

template <typename Float>
struct SurfaceOf;
template <>
struct SurfaceOf<float> {
    static constexpr auto* kMake = &f32::surface_material;
};
template <>
struct SurfaceOf<double> {
    static constexpr auto* kMake = &f64::surface_material;
};

template <typename Float>
dialect::Vec3<Float> vector_of(glm::vec3 v) {
    return {Float{v.x}, Float{v.y}, Float{v.z}};
}

template <typename Float>
auto lobe_as(const Material& m) {
    const int mdf = f32::brdf_mdf(static_cast<int>(m.brdf), static_cast<int>(m.mdf));
    const glm::vec2 alpha = alpha_of(m);
    const auto lobe = lobe_from_alpha(mdf, Float{alpha.x}, Float{alpha.y});
    const Cloth* cloth = cloth_of(m);
    if (!cloth) return lobe;
    const Float variance = Float{cloth->fuzz} * Float{cloth->fuzz};
    return widen_lobe(lobe, variance, variance);
}

// The interface: what a texture does not change.
template <typename Float>
auto interface_of(const Material& m) {
    const Tabulated* tabulated = tabulated_of(m);
    const int brdf = tabulated ? f32::kBrdfTabulated : static_cast<int>(m.brdf);
    auto s = SurfaceOf<Float>::kMake(brdf, lobe_as<Float>(m), Float{m.ks.value_or(-1.0f)},
                                     vector_of<Float>(m.lafortune_c), Float{m.dielectric_f0});
    if (tabulated) {
        s.fresnel = f32::kFresnelDielectric;
        s.eta.x = static_cast<Float>(tabulated->material->eta);
        s.k.x = fresnel_inverse_at_normal(s.eta.x);
    } else if (m.conductor && m.conductor->oxide) {
        s.fresnel = f32::kFresnelCurve;
        const FresnelTerms& terms = m.conductor->oxide->curve;
        s.curve.normal = vector_of<Float>(terms[0]);
        s.curve.pole = vector_of<Float>(terms[1]);
        s.curve.pole2 = vector_of<Float>(terms[2]);
        s.curve.c0 = vector_of<Float>(terms[3]);
        s.curve.c1 = vector_of<Float>(terms[4]);
        s.curve.c2 = vector_of<Float>(terms[5]);
    } else if (m.conductor) {
        s.fresnel = f32::kFresnelConductor;
        s.eta = vector_of<Float>(m.conductor->eta);
        s.k = vector_of<Float>(m.conductor->k);
    }
    if (has_specular_factors(m))
        s = surface_dielectric(s, vector_of<Float>(m.specular_color * m.dielectric_f0),
                               Float{m.specular});
    s.has_diffuse = tabulated || (!m.conductor && m.metallic < 1.0f);
    return s;
}

f32::SurfaceLayers no_layers(float) {
    return {f32::coat_none(), f32::sheen_none()};
}
f64::SurfaceLayers no_layers(double) {
    return {f64::coat_none(), f64::sheen_none()};
}

template <typename Float>
auto layers_of(const Material& m) {
    auto layers = no_layers(Float{0});
    if (has_coat(m)) {
        const auto lobe = lobe_of_roughness(f32::kMdfGgx, Float{m.coat.roughness}, Float{0});
        layers.coat =
            coat_make(Float{m.coat.strength}, lobe, vector_of<Float>({0, 0, 1}),
                      m.coat.tint != glm::vec3(1.0f), coat_depth(vector_of<Float>(m.coat.tint)));
    }
    if (has_sheen(m))
        layers.sheen = sheen_make(vector_of<Float>(m.sheen.color), Float{m.sheen.roughness});
    return layers;
}

}  // namespace

template <typename Surface>
MaterialValues<Surface> material_values(const Material& m) {
    using Float = typename MaterialValues<Surface>::Float;
    const bool own_color = cloth_of(m) || tabulated_of(m);
    const Float angle{m.anisotropy_rotation};
    MaterialValues<Surface> v;
    v.base_color = vector_of<Float>(own_color ? glm::vec3(1.0f) : glm::vec3(m.base_color));
    v.metallic = tabulated_of(m) ? Float{0} : Float{m.metallic};
    v.surface = surface_colored(interface_of<Float>(m), v.base_color, v.metallic);
    v.stretch = {std::cos(angle), std::sin(angle)};
    const auto& lobe = v.surface.lobe;
    v.grooves_along_x = tabulated_of(m) || lobe_grooves_along_x(lobe.mdf, lobe.p0, lobe.p1);
    v.method = drawn_method(m);
    v.conserve = m.conserve && v.method == Method::deform_smooth;
    v.compensated = is_compensated(m);
    v.layers = layers_of<Float>(m);
    v.layered = has_coat(m) || has_sheen(m);
    return v;
}

template MaterialValues<f32::SurfaceMaterial> material_values(const Material&);
template MaterialValues<f64::SurfaceMaterial> material_values(const Material&);

bool is_compensated(const Material& m) {
    return !m.single_scattering && f32::brdf_masks(static_cast<int>(m.brdf)) &&
           cloth_of(m) == nullptr && tabulated_of(m) == nullptr;
}

f32::Lobe lobe_of(const Material& material) {
    return lobe_as<float>(material);
}

glm::vec2 alpha_of(const Material& m) {
    if (const auto alpha = stated_alpha(m)) return glm::max(*alpha, glm::vec2(f32::kLowestAlpha));
    const GltfLobe* gltf = gltf_lobe_of(m);
    const GltfLobe lobe = gltf ? *gltf : GltfLobe{};  // unused for tabulated materials
    const f32::vec2 alpha = f32::alpha_of_roughness(lobe.roughness, lobe.anisotropy_strength);
    return {alpha.x, alpha.y};
}

}  // namespace burnish
