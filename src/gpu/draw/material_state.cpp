#include "gpu/draw/material_state.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "burnish/f32.hpp"
#include "gpu/device/texture_units.hpp"
#include "gpu/upload/cloth_maps.hpp"
#include "scene/material/material_values.hpp"
#include "scene/material/texture_uses.hpp"

namespace burnish::gpu {
namespace {

// By MaterialTexture.
constexpr std::array<const char*, kMaterialTextures> kSamplers = {
    "u_base_color_map",     "u_metallic_roughness_map", "u_normal_map",      "u_occlusion_map",
    "u_emissive_map",       "u_anisotropy_map",         "u_specular_map",    "u_specular_color_map",
    "u_coat_map",           "u_coat_roughness_map",     "u_coat_normal_map", "u_sheen_color_map",
    "u_sheen_roughness_map"};

glm::vec3 of(f32::vec3 v) {
    return {v.x, v.y, v.z};
}

// The stretch, in the frame of the tangents, of texels whose direction is +x: `stretch` turned from
// the frame that the anisotropy texture is stored in.
glm::vec2 texture_stretch(const Material& m, f32::vec2 stretch) {
    const float c = std::cos(m.anisotropy_texture_turn), s = std::sin(m.anisotropy_texture_turn);
    return {c * stretch.x - s * stretch.y, s * stretch.x + c * stretch.y};
}

// The rows of (u', v', 1) = transform (u, v, 1) that matter.
glm::vec3 row(const glm::mat3& m, int r) {
    return {m[0][r], m[1][r], m[2][r]};
}

// A tabulated material is read where its normal map is, or would be.
const TextureUse* first_use(const Material& material) {
    if (tabulated_of(material)) return &material.normal_texture;
    for (const TextureUse* use : texture_uses(material)) {
        if (*use) return use;
    }
    return nullptr;
}

bool uses_differ(const Material& material) {
    const TextureUse* first = first_use(material);
    for (const TextureUse* use : texture_uses(material)) {
        if (!*use) continue;
        if (use->texcoord != first->texcoord || use->transform != first->transform) return true;
    }
    return false;
}

void set_textures(Program& program, const Material& material, const TextureStore& textures,
                  float lod_bias) {
    std::array<glm::vec3, kMaterialTextures> s{}, t{};
    std::array<float, kMaterialTextures> set{}, lod{};
    const auto uses = texture_uses(material);
    for (std::size_t i = 0; i < uses.size(); ++i) {
        const bool texels = tabulated_of(material) && uses[i] == &material.normal_texture;
        if (!*uses[i] && !texels) continue;
        s[i] = row(uses[i]->transform, 0);
        t[i] = row(uses[i]->transform, 1);
        set[i] = static_cast<float>(uses[i]->texcoord);
        if (!*uses[i]) continue;
        lod[i] = textures.log2_side(*uses[i]) + lod_bias;
        program.set(kSamplers[i], static_cast<int>(material_unit(i)));
    }
    if (wants_slopes(material))
        program.set("u_slope_covariance", static_cast<int>(kSlopeCovarianceUnit));
    program.set("u_uv_s", std::span<const glm::vec3>(s));
    program.set("u_uv_t", std::span<const glm::vec3>(t));
    program.set("u_uv_set", std::span<const float>(set));
    program.set("u_map_lod", std::span<const float>(lod));
    set_shared_uv(program, material);
}

void set_fresnel_curve(Program& program, const f32::FresnelCurve& curve) {
    const std::array<glm::vec3, kFresnelTerms> terms = {of(curve.normal), of(curve.pole),
                                                        of(curve.pole2),  of(curve.c0),
                                                        of(curve.c1),     of(curve.c2)};
    program.set("u_fresnel_curve", std::span<const glm::vec3>(terms));
}

void put_layers(const Material& m, const TextureStore::Slots& textures, SurfaceVariant& v) {
    v.coat = has_coat(m);
    v.coat_tint = v.coat && m.coat.tint != glm::vec3(1.0f);
    v.coat_map = v.coat && m.coat.texture;
    v.coat_roughness_map = v.coat && m.coat.roughness_texture;
    v.coat_normal_map = v.coat && m.coat.normal_texture;
    v.coat_normal_moments = v.coat_normal_map && wants_coat_slopes(m);
    v.coat_normal_map_xy = v.coat_normal_map && !v.coat_normal_moments &&
                           TextureStore::channels(textures, m.coat.normal_texture) == 2;
    v.sheen = has_sheen(m);
    v.sheen_color_map = v.sheen && m.sheen.color_texture;
    v.sheen_roughness_map = v.sheen && m.sheen.roughness_texture;
    v.specular_factors = has_specular_factors(m);
    v.specular_map = static_cast<bool>(m.specular_texture);
    v.specular_color_map = static_cast<bool>(m.specular_color_texture);
}

void set_layers(Program& program, const Material& m) {
    program.set("u_coat", glm::vec2(m.coat.strength, m.coat.roughness));
    program.set("u_coat_depth", of(f32::coat_depth({m.coat.tint.x, m.coat.tint.y, m.coat.tint.z})));
    program.set("u_coat_normal_scale",
                glm::vec2(m.coat.normal_scale,
                          m.coat.flip_green ? -m.coat.normal_scale : m.coat.normal_scale));
    program.set("u_sheen", glm::vec4(m.sheen.color, m.sheen.roughness));
    program.set("u_dielectric", glm::vec4(m.specular_color * m.dielectric_f0, m.specular));
}

}  // namespace

void set_shared_uv(Program& program, const Material& material) {
    const TextureUse none;
    const TextureUse* one = first_use(material);
    const TextureUse& shared = one == nullptr ? none : *one;
    program.set("u_uv_row_s", row(shared.transform, 0));
    program.set("u_uv_row_t", row(shared.transform, 1));
    program.set("u_uv_from_set", static_cast<float>(shared.texcoord));
}

bool reads_albedos(const RenderSettings& settings, const Material& m) {
    if (tabulated_of(m)) return false;
    const bool blurs = settings.image_light == ImageLight::prefiltered && has_half_vectors(m.brdf);
    return blurs || is_compensated(m);
}

void bind_textures(const Material& material, TextureStore& textures) {
    const auto uses = texture_uses(material);
    for (std::size_t i = 0; i < uses.size(); ++i) {
        if (!*uses[i]) continue;
        const bool own = uses[i] == &material.normal_texture;
        const bool coat = uses[i] == &material.coat.normal_texture;
        const bool slopes = own ? wants_slopes(material) : wants_coat_slopes(material);
        const TextureForm form = !own && !coat ? TextureForm::plain
                                 : slopes      ? TextureForm::slopes
                                               : TextureForm::normal;
        textures.bind(material_unit(i), *uses[i], form);
    }
}

SurfaceVariant variant_of(const Material& m, const TextureStore::Slots& textures,
                          bool with_normal_map) {
    const auto values = material_values<f32::SurfaceMaterial>(m);
    SurfaceVariant v;
    v.mdf = m.mdf;
    v.brdf = m.brdf;
    v.tabulated = tabulated_of(m) != nullptr;
    v.compensated = values.compensated;
    v.fresnel_curve = values.surface.fresnel == f32::kFresnelCurve;
    v.conductor = values.surface.fresnel == f32::kFresnelConductor || v.fresnel_curve;
    // A texture scales the metallic factor down.
    v.metal = !values.surface.has_diffuse && (v.conductor || !m.metallic_roughness_texture);
    v.base_color_map = static_cast<bool>(m.base_color_texture);
    v.metallic_roughness_map = static_cast<bool>(m.metallic_roughness_texture);
    v.normal_map = with_normal_map && m.normal_texture;
    v.normal_moments = v.normal_map && wants_slopes(m);
    v.normal_map_xy = v.normal_map && !v.normal_moments &&
                      TextureStore::channels(textures, m.normal_texture) == 2;
    v.occlusion_map = static_cast<bool>(m.occlusion_texture);
    v.emissive_map = static_cast<bool>(m.emissive_texture);
    v.anisotropy_map = static_cast<bool>(m.anisotropy_texture);
    v.lobe_from_texture = gltf_lobe_of(m) && (v.metallic_roughness_map || v.anisotropy_map);
    v.grooves_along_x = v.lobe_from_texture || values.grooves_along_x;
    v.turned = m.anisotropy_rotation != 0.0f || v.anisotropy_map || cloth_of(m);
    v.cloth = with_normal_map && cloth_of(m);
    v.cloth_colors = v.cloth && has_yarn_colors(*cloth_of(m));
    if (v.tabulated) {
        v.turned = true;  // tabulated_texels.glsl turns the lobe to its grooves
        v.brdf = Brdf::microfacet_separable;
    }
    put_layers(m, textures, v);
    v.uv_per_texture = uses_differ(m);
    v.alpha_mode = m.alpha_mode;
    // Without a perturbed normal all methods are one.
    v.method = v.normal_map || v.cloth || v.tabulated ? values.method : Method::none;
    v.conserve = values.conserve && v.method != Method::none;
    return v;
}

void set_material(Program& program, const Material& m, const TextureStore& textures,
                  float lod_bias) {
    const auto values = material_values<f32::SurfaceMaterial>(m);
    const f32::SurfaceMaterial& surface = values.surface;
    const GltfLobe gltf = gltf_lobe_of(m) ? *gltf_lobe_of(m) : GltfLobe{};
    program.set("u_base_color", glm::vec4(of(values.base_color), m.base_color.a));
    program.set("u_metallic", values.metallic);
    program.set("u_roughness", gltf.roughness);
    program.set("u_anisotropy", gltf.anisotropy_strength);
    program.set("u_anisotropy_direction", texture_stretch(m, values.stretch));
    program.set("u_emissive", m.emissive);
    program.set("u_occlusion_strength", m.occlusion_strength);
    program.set("u_normal_scale",
                glm::vec2(m.normal_scale, m.flip_green ? -m.normal_scale : m.normal_scale));
    const f32::Lobe& lobe = surface.lobe;
    program.set("u_lobe", glm::vec4(lobe.p0, lobe.p1, lobe.paper_norm, lobe.projected_norm));
    program.set("u_eta", of(surface.eta));
    program.set("u_k", of(surface.k));
    set_fresnel_curve(program, surface.curve);
    program.set("u_dielectric_f0", surface.dielectric_f0);
    program.set("u_ks", surface.ks);
    program.set("u_lafortune_c", of(surface.c));
    // Refractive index (0: no Fresnel) and 1/F at normal incidence.
    program.set("u_tabulated_fresnel", glm::vec2(surface.eta.x, surface.k.x));
    program.set("u_alpha_cutoff", m.alpha_cutoff);
    program.set("u_lod_bias", lod_bias);
    // Phong's exponent from the mean alpha, for the Gouraud variant.
    const glm::vec2 alpha = alpha_of(m);
    program.set("u_phong_exponent", std::max(2.0f / (alpha.x * alpha.y) - 2.0f, 1.0f));
    set_layers(program, m);
    set_textures(program, m, textures, lod_bias);
}

}  // namespace burnish::gpu
