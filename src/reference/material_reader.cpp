#include "reference/material_reader.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "burnish/draft.hpp"
#include "burnish/error.hpp"
#include "core/index_of.hpp"
#include "rays/vectors.hpp"

namespace burnish {
namespace {

f32::vec3 rgb(const glm::vec4& v) {
    return {v.x, v.y, v.z};
}

f32::vec3 vector_of(const glm::vec4& texel, int channels) {
    return channels == 2 ? f32::vector_of_texel(f32::vec2(texel.x, texel.w))
                         : f32::vector_of_texel(rgb(texel));
}

f32::vec2 normal_scale(float scale, bool flip_green) {
    return {scale, flip_green ? -scale : scale};
}

// As the renderer has it: cloth and tables are read with the coordinates of one texture.
const TextureUse* first_use(const Material& m) {
    if (tabulated_of(m)) return &m.normal_texture;
    for (const TextureUse* use : texture_uses(m))
        if (*use) return use;
    return nullptr;
}

}  // namespace

std::shared_ptr<const TexturePyramid> PyramidStore::get(const TextureUse& use, PyramidForm form) {
    if (!use) return nullptr;
    if (index_of(use.texture) >= textures_.size())
        throw Error("material", "texture", "a number below " + std::to_string(textures_.size()),
                    std::to_string(use.texture));
    if (textures_[index_of(use.texture)].empty()) return nullptr;
    made_.resize(textures_.size());
    auto& pyramid = made_[index_of(use.texture)][static_cast<std::size_t>(form)];
    if (!pyramid)
        pyramid = std::make_shared<const TexturePyramid>(textures_[index_of(use.texture)], form);
    return pyramid;
}

MaterialReader::MaterialReader(const Material& material, PyramidStore& pyramids)
    : m_(material), values_(material_values<f32::SurfaceMaterial>(m_)) {
    slopes_ = m_.normal_texture && !tabulated_of(m_) && m_.normal_filter == NormalFilter::moments;
    coat_slopes_ = m_.coat.normal_texture && m_.normal_filter == NormalFilter::moments;
    const auto uses = texture_uses(m_);
    for (std::size_t i = 0; i < uses.size(); ++i) {
        const auto which = static_cast<MaterialTexture>(i);
        const bool own = which == MaterialTexture::normal,
                   coat = which == MaterialTexture::coat_normal;
        const bool slopes = own ? slopes_ : coat && coat_slopes_;
        pyramids_[i] = pyramids.get(*uses[i], slopes        ? PyramidForm::slopes
                                              : own || coat ? PyramidForm::normal
                                                            : PyramidForm::plain);
        reads_textures_ = reads_textures_ || pyramids_[i];
    }
    if (values_.compensated) albedos_ = albedo_table(m_.brdf, m_.mdf);
    if (const Tabulated* t = tabulated_of(m_))
        for (int e = 0; e < t->material->exemplars; ++e) tables_.emplace_back(*t->material, e);
    own_use_ = first_use(m_);
    const bool metal_map = has(MaterialTexture::metallic_roughness);
    const bool conductor = values_.surface.fresnel == f32::kFresnelConductor ||
                           values_.surface.fresnel == f32::kFresnelCurve;
    has_diffuse_ = values_.surface.has_diffuse || (!conductor && metal_map);
    one_color_ = !metal_map && !has(MaterialTexture::base_color) &&
                 !has(MaterialTexture::specular) && !has(MaterialTexture::specular_color) &&
                 !cloth_of(m_) && !tabulated_of(m_);
    lobe_from_texture_ = gltf_lobe_of(m_) && (metal_map || has(MaterialTexture::anisotropy));
    perturbed_ = has(MaterialTexture::normal) || cloth_of(m_) || tabulated_of(m_);
    method_ = static_cast<int>(perturbed_ ? values_.method : Method::none);
    turned_ = m_.anisotropy_rotation != 0.0f || has(MaterialTexture::anisotropy) || cloth_of(m_) ||
              tabulated_of(m_);
    turn_ = f32::direction_added(values_.stretch, f32::vec2(std::cos(m_.anisotropy_texture_turn),
                                                            std::sin(m_.anisotropy_texture_turn)));
}

glm::vec4 MaterialReader::texel(MaterialTexture which, const SurfaceHit& hit) const {
    const auto& pyramid = pyramids_[static_cast<std::size_t>(which)];
    if (!pyramid) return glm::vec4(1.0f);
    const TextureUse& use = texture_use(m_, which);
    const std::size_t set = use.texcoord == 1 ? 1 : 0;
    return pyramid->at(use, hit.uv[set], hit.footprint[set]);
}

glm::vec4 MaterialReader::base_color(const SurfaceHit& hit) const {
    return glm::vec4(to_glm(values_.base_color), m_.base_color.a) * hit.color *
           texel(MaterialTexture::base_color, hit);
}

float MaterialReader::alpha(const SurfaceHit& hit) const {
    if (m_.alpha_mode == AlphaMode::opaque) return 1.0f;
    const float a = base_color(hit).a;
    if (m_.alpha_mode == AlphaMode::mask) return a < m_.alpha_cutoff ? 0.0f : 1.0f;
    return std::clamp(a, 0.0f, 1.0f);
}

void MaterialReader::put_lobe(Shading& s, const SurfaceHit& hit) const {
    const glm::vec4 roughness_metallic = texel(MaterialTexture::metallic_roughness, hit);
    s.metallic = values_.metallic * roughness_metallic.z;
    s.direction = values_.stretch;
    float strength = 0.0f;
    const GltfLobe* gltf = gltf_lobe_of(m_);
    if (gltf) strength = gltf->anisotropy_strength;
    if (has(MaterialTexture::anisotropy)) {
        const glm::vec4 t = texel(MaterialTexture::anisotropy, hit);
        s.direction = f32::stretch_direction(f32::vec2(t.x, t.y), turn_);
        strength *= t.z;
    }
    if (!lobe_from_texture_) return;
    s.surface = f32::surface_with_lobe(
        s.surface,
        f32::lobe_of_roughness(s.surface.lobe.mdf,
                               std::clamp(gltf->roughness * roughness_metallic.y, 0.0f, 1.0f),
                               std::clamp(strength, 0.0f, 1.0f)));
}

void MaterialReader::put_specular(Shading& s, const SurfaceHit& hit) const {
    if (!has(MaterialTexture::specular) && !has(MaterialTexture::specular_color)) return;
    const glm::vec3 f0 = m_.specular_color * m_.dielectric_f0 *
                         glm::vec3(texel(MaterialTexture::specular_color, hit));
    s.surface = f32::surface_dielectric(s.surface, to_f32(f0),
                                        m_.specular * texel(MaterialTexture::specular, hit).a);
}

void MaterialReader::put_normal(Shading& s, const SurfaceHit& hit) const {
    if (!has(MaterialTexture::normal)) return;
    const glm::vec4 t = texel(MaterialTexture::normal, hit);
    const f32::vec2 scale = normal_scale(m_.normal_scale, m_.flip_green);
    if (!slopes_) {
        s.n = f32::normal_of_vector(
            vector_of(t, pyramids_[static_cast<std::size_t>(MaterialTexture::normal)]->channels()),
            scale);
        return;
    }
    s.n = f32::normal_of_slopes(t.x * scale.x, t.y * scale.y);
    f32::vec2 variance = f32::variance_about(s.n, f32::vec2(t.z, t.w), scale);
    if (turned_) variance = f32::variance_along(variance, s.direction);
    s.surface = f32::surface_widened(s.surface, method_, variance);
}

f32::SurfaceLayers MaterialReader::layers_at(Shading& s, const SurfaceHit& hit) const {
    f32::SurfaceLayers layers = values_.layers;
    if (layers.coat.present) {
        const float strength = m_.coat.strength * texel(MaterialTexture::coat, hit).x;
        const float roughness = m_.coat.roughness * texel(MaterialTexture::coat_roughness, hit).y;
        f32::Lobe lobe =
            f32::lobe_of_roughness(f32::kMdfGgx, std::clamp(roughness, 0.0f, 1.0f), 0.0f);
        if (has(MaterialTexture::coat_normal)) {
            const glm::vec4 t = texel(MaterialTexture::coat_normal, hit);
            const f32::vec2 scale = normal_scale(m_.coat.normal_scale, m_.coat.flip_green);
            if (coat_slopes_) {
                s.coat_n = f32::normal_of_slopes(t.x * scale.x, t.y * scale.y);
                const f32::vec2 v = f32::variance_about(s.coat_n, f32::vec2(t.z, t.w), scale);
                lobe = f32::widen_lobe(lobe, 0.5f * (v.x + v.y), 0.5f * (v.x + v.y));
            } else {
                const std::size_t map = static_cast<std::size_t>(MaterialTexture::coat_normal);
                s.coat_n = f32::normal_of_vector(vector_of(t, pyramids_[map]->channels()), scale);
            }
        }
        layers.coat = f32::coat_make(std::clamp(strength, 0.0f, 1.0f), lobe, {0.0f, 0.0f, 1.0f},
                                     layers.coat.tinted, layers.coat.depth);
    }
    if (layers.sheen.present &&
        (has(MaterialTexture::sheen_color) || has(MaterialTexture::sheen_roughness))) {
        const f32::vec3 color = rgb(texel(MaterialTexture::sheen_color, hit));
        layers.sheen =
            f32::sheen_make(to_f32(m_.sheen.color) * color,
                            m_.sheen.roughness * texel(MaterialTexture::sheen_roughness, hit).a);
    }
    return layers;
}

glm::vec2 MaterialReader::own_coordinates(const SurfaceHit& hit) const {
    if (own_use_ == nullptr) return hit.uv[0];
    // As the renderer: woven cloth has the transform of its textures only where they have one transform.
    if (cloth_of(m_))
        for (const TextureUse* use : texture_uses(m_))
            if (*use &&
                (use->texcoord != own_use_->texcoord || use->transform != own_use_->transform))
                return hit.uv[0];
    return glm::vec2(own_use_->transform *
                     glm::vec3(hit.uv[own_use_->texcoord == 1 ? 1 : 0], 1.0f));
}

void MaterialReader::put_axes(const Shading& s, PointSurface& out, const SurfaceHit& hit) const {
    const f32::vec3 to_eye = to_f32(hit.to_eye);
    const f32::Frame surface =
        f32::surface_frame(to_f32(hit.normal), to_f32(glm::vec3(hit.tangent)), hit.tangent.w,
                           hit.front ? 1.0f : -1.0f, to_eye);
    const f32::vec2 stretch = turned_ ? s.direction : f32::vec2(1.0f, 0.0f);
    out.axes = turned_ ? f32::frame_rotated(surface, stretch) : surface;
    out.wo = f32::frame_to_local(out.axes, to_eye);
    out.p = perturbed_ ? f32::surface_perturbation(method_, s.n, stretch, out.grooves_along_x,
                                                   values_.conserve, out.wo)
                       : f32::perturb_make(method_, s.n, out.grooves_along_x, values_.conserve);
    if (out.layered && out.layers.coat.present && has(MaterialTexture::coat_normal)) {
        const f32::vec3 n = f32::frame_to_local(out.axes, f32::frame_to_outer(surface, s.coat_n));
        out.layers.coat = f32::coat_turned(out.layers.coat, f32::normal_facing(n, out.wo));
    }
}

PointSurface MaterialReader::at(const SurfaceHit& hit, const glm::vec2& xi) const {
    PointSurface out;
    out.material = values_.surface;
    out.material.has_diffuse = has_diffuse_;
    out.layered = values_.layered;
    Shading s{.surface = out.material};
    s.base_color = rgb(base_color(hit));
    put_lobe(s, hit);
    put_specular(s, hit);
    if (out.layered) out.layers = layers_at(s, hit);
    out.grooves_along_x =
        lobe_from_texture_
            ? f32::lobe_grooves_along_x(s.surface.lobe.mdf, s.surface.lobe.p0, s.surface.lobe.p1)
            : values_.grooves_along_x;
    put_normal(s, hit);
    if (cloth_of(m_)) put_yarn(s, out, hit);
    if (!one_color_ || hit.color != glm::vec4(1.0f))
        s.surface = f32::surface_colored(s.surface, s.base_color, s.metallic);
    if (tabulated_of(m_)) put_texel(s, out, hit, xi);
    put_axes(s, out, hit);
    if (albedos_) {
        const f32::AlbedoPlace place = f32::albedo_place_of(out.material.lobe, out.p, out.wo);
        const f64::AlbedoPlace in_double{f64::vec3(place.at), static_cast<double>(place.mixed)};
        out.material =
            f32::surface_compensated(out.material, static_cast<float>(albedos_->at(in_double)));
    }
    if (out.layered) out.seen = f32::layers_seen(out.layers, out.p.n, out.wo);
    if (m_.emissive != glm::vec3(0.0f)) {
        out.emitted = m_.emissive * glm::vec3(texel(MaterialTexture::emissive, hit));
        if (out.layered && out.layers.coat.present)
            out.emitted *= to_glm(f32::coat_share(out.layers.coat, out.seen.coat.through));
    }
    if (has(MaterialTexture::occlusion))
        out.occlusion =
            1.0f + m_.occlusion_strength * (texel(MaterialTexture::occlusion, hit).x - 1.0f);
    return out;
}

}  // namespace burnish
