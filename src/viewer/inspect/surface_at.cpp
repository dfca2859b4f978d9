#include "viewer/inspect/surface_at.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <string>
#include <vector>

#include "burnish/draft.hpp"
#include "burnish/error.hpp"
#include "burnish/f32.hpp"
#include "core/constants.hpp"
#include "core/index_of.hpp"
#include "maps/weave/weave_cells.hpp"
#include "scene/material/material_values.hpp"
#include "scene/material/texture_sampler.hpp"
#include "scene/material/texture_uses.hpp"

namespace burnish::viewer {
namespace {

using Values = MaterialValues<f64::SurfaceMaterial>;

const Material& material_at(const Scene& scene, const Hit& hit) {
    const bool known = hit.material >= 0 && index_of(hit.material) < scene.materials.size();
    if (!known)
        throw Error("hit", "material", "a material of the scene", std::to_string(hit.material));
    return scene.materials[index_of(hit.material)];
}

// The textures of the scene at the coordinates of a hit.
class TexturesAt {
  public:
    TexturesAt(const Scene& scene, const Hit& hit) : textures_(scene.textures), hit_(hit) {}

    glm::vec2 uv(const TextureUse& use) const { return use.texcoord == 1 ? hit_.uv1 : hit_.uv0; }
    glm::vec4 color(const TextureUse& use) const {
        return TextureSampler(use, textures_).at(uv(use));
    }
    int channels(const TextureUse& use) const { return textures_[index_of(use.texture)].channels; }
    std::span<const Texture> all() const { return textures_; }

  private:
    std::span<const Texture> textures_;
    const Hit& hit_;
};

glm::vec2 transformed_uv(const TextureUse& use, glm::vec2 uv) {
    return glm::vec2(use.transform * glm::vec3(uv, 1.0f));
}

f32::vec3 vector_of(glm::vec4 texel, int channels) {
    return channels == 2 ? f32::vector_of_texel(f32::vec2(texel.x, texel.w))
                         : f32::vector_of_texel(f32::vec3(texel.x, texel.y, texel.z));
}

// The slopes of texels are interpolated, as the renderer's maps of slopes are.
glm::vec2 slopes_between_texels(const TexturesAt& textures, const TextureUse& use) {
    const Texture& texture = textures.all()[index_of(use.texture)];
    TextureUse texel_use = use;
    texel_use.transform = glm::mat3(1.0f);
    texel_use.nearest = true;
    const TextureSampler texels(texel_use, textures.all());
    const glm::vec2 size(static_cast<float>(texture.width), static_cast<float>(texture.height));
    const auto slope = [&](glm::vec2 middle) {
        const f32::vec3 v = vector_of(texels.at(middle / size), texture.channels);
        const f32::vec2 s = f32::slopes_of_normal(f32::normal_of_vector(v, {1.0f, 1.0f}));
        return glm::vec2(s.x, s.y);
    };
    const glm::vec2 at = transformed_uv(use, textures.uv(use)) * size;
    if (use.nearest) return slope(glm::floor(at) + 0.5f);
    const glm::vec2 low = glm::floor(at - 0.5f) + 0.5f;
    const glm::vec2 share = at - low;
    const glm::vec2 x(1.0f, 0.0f), y(0.0f, 1.0f);
    return glm::mix(glm::mix(slope(low), slope(low + x), share.x),
                    glm::mix(slope(low + y), slope(low + x + y), share.x), share.y);
}

f64::vec3 mapped_normal(const Material& m, const TexturesAt& textures) {
    const TextureUse& use = m.normal_texture;
    if (!use || textures.all()[index_of(use.texture)].empty()) return {0, 0, 1};
    const f32::vec2 scale(m.normal_scale, m.flip_green ? -m.normal_scale : m.normal_scale);
    if (m.normal_filter == NormalFilter::moments && tabulated_of(m) == nullptr) {
        const glm::vec2 s = slopes_between_texels(textures, use);
        return f64::normalize(f64::vec3(f32::normal_of_slopes(s.x * scale.x, s.y * scale.y)));
    }
    const f32::vec3 v = vector_of(textures.color(use), textures.channels(use));
    return f64::normalize(f64::vec3(f32::normal_of_vector(v, scale)));
}

f64::vec2 at_angle(double angle_rad) {
    return {std::cos(angle_rad), std::sin(angle_rad)};
}

// The stretch and the lobe, where textures of a glTF lobe scale it.
void put_lobe(SurfaceAt& at, const Material& m, const Values& values, const TexturesAt& textures,
              double roughness) {
    const GltfLobe* gltf = gltf_lobe_of(m);
    double strength = gltf ? static_cast<double>(gltf->anisotropy_strength) : 0.0;
    at.stretch = values.stretch;
    if (m.anisotropy_texture) {
        const glm::vec4 texel = textures.color(m.anisotropy_texture);
        at.stretch = f64::stretch_direction(
            {static_cast<double>(texel.x), static_cast<double>(texel.y)},
            at_angle(static_cast<double>(m.anisotropy_rotation + m.anisotropy_texture_turn)));
        strength *= static_cast<double>(texel.z);
    }
    if (!gltf || !(m.anisotropy_texture || m.metallic_roughness_texture)) return;
    at.surface = f64::surface_with_lobe(
        at.surface, f64::lobe_of_roughness(
                        at.surface.lobe.mdf,
                        std::clamp(static_cast<double>(gltf->roughness) * roughness, 0.0, 1.0),
                        std::clamp(strength, 0.0, 1.0)));
    at.grooves_along_x =
        f64::lobe_grooves_along_x(at.surface.lobe.mdf, at.surface.lobe.p0, at.surface.lobe.p1);
}

// ---- cloth --------------------------------------------------------------------------------------

// The renderer gives a material one transform, that of its first texture, unless its textures differ.
glm::vec2 cloth_uv(const Material& m, const Hit& hit) {
    const TextureUse* first = nullptr;
    for (const TextureUse* use : texture_uses(m)) {
        if (!cloth_reads(m, *use)) continue;
        if (first == nullptr) first = use;
        if (use->texcoord != first->texcoord || use->transform != first->transform) return hit.uv0;
    }
    if (first == nullptr) return hit.uv0;
    return transformed_uv(*first, first->texcoord == 1 ? hit.uv1 : hit.uv0);
}

int in_repeat(float whole, int count) {
    const int i = static_cast<int>(std::fmod(whole, static_cast<float>(count)));
    return i < 0 ? i + count : i;
}

glm::dvec3 color_of_yarn(const Material& m, const YarnAt& yarn) {
    const Cloth& cloth = *cloth_of(m);
    const auto& stated = yarn.warp ? cloth.warp_color : cloth.weft_color;
    const auto& drawn = yarn.warp ? cloth.draft->warp_colors : cloth.draft->weft_colors;
    if (stated) return glm::dvec3(*stated);
    if (drawn.empty()) return glm::dvec3(m.base_color);
    return glm::dvec3(drawn[index_of(yarn.warp ? yarn.end : yarn.pick) % drawn.size()]);
}

// The color of the yarn; normal and stretch are put into `at`.
glm::dvec3 put_yarn(SurfaceAt& at, const Material& m, const Hit& hit) {
    const Cloth& cloth = *cloth_of(m);
    const glm::vec2 uv = cloth_uv(m, hit);
    const glm::vec2 place = glm::vec2(uv.x, 1.0f - uv.y) * cloth.yarns;
    const glm::vec2 whole = glm::floor(place);
    YarnAt yarn;
    yarn.end = in_repeat(whole.x, cloth.draft->ends);
    yarn.pick = in_repeat(whole.y, cloth.draft->picks);
    const float twist = cloth.twist + m.anisotropy_rotation;
    const f32::WeaveShape shape{cloth.crimp, cloth.bulge, cloth.gap,
                                f32::vec2(std::cos(twist), std::sin(twist))};
    const f32::WeavePoint point =
        f32::weave_point(weave_cell(*cloth.draft, yarn.end, yarn.pick), shape,
                         place.x - whole.x - 0.5f, place.y - whole.y - 0.5f);
    yarn.warp = point.warp > 0.5f;
    yarn.covered = point.cover > 0.5f;
    at.n = f64::normalize(f64::vec3(point.n));
    at.stretch = {static_cast<double>(point.fiber.x), static_cast<double>(point.fiber.y)};
    at.yarn = yarn;
    return color_of_yarn(m, yarn);
}

// ---- measured materials -------------------------------------------------------------------------

int in_texture(float at, int size) {
    const float turned = at - static_cast<float>(size) * std::floor(at / static_cast<float>(size));
    return std::clamp(static_cast<int>(turned), 0, size - 1);
}

void put_shares(ExemplarAt& at) {
    const NdfGrid& grid = at.material->grid;
    const std::span<const NdfOrigin> origin = at.origin();
    for (int ring = 0; ring < grid.rings; ++ring) {
        const double share = grid.solid_angle(ring) / kTwoPi;
        for (int azimuth = 0; azimuth < grid.azimuths; ++azimuth) {
            switch (origin[index_of(ring * grid.azimuths + azimuth)]) {
                case NdfOrigin::measured:
                    at.measured += share;
                    break;
                case NdfOrigin::completed:
                    at.completed += share;
                    break;
                case NdfOrigin::extrapolated:
                    at.extrapolated += share;
                    break;
            }
        }
    }
}

void put_texel(SurfaceAt& at, const Material& m, const TexturesAt& textures) {
    const TabulatedMaterial& t = *tabulated_of(m)->material;
    const TextureUse& use = m.normal_texture;
    const glm::vec2 uv = transformed_uv(use, textures.uv(use));
    ExemplarAt found;
    found.material = tabulated_of(m)->material;
    found.texel = {in_texture(uv.x * static_cast<float>(t.width), t.width),
                   in_texture(uv.y * static_cast<float>(t.height), t.height)};
    const std::size_t texel = index_of(found.texel.y) * index_of(t.width) + index_of(found.texel.x);
    if (t.exemplar[texel] != TabulatedMaterial::kNoExemplar) {
        found.exemplar = t.exemplar[texel];
        found.angle_rad = static_cast<double>(t.angle[texel]);
        found.groove_rad = static_cast<double>(t.groove[index_of(found.exemplar)]);
        put_shares(found);
    }
    const auto rgb = [&](const Image& image) {
        const float* p = image.pixels.data() + 3 * texel;
        return f64::vec3(static_cast<double>(p[0]), static_cast<double>(p[1]),
                         static_cast<double>(p[2]));
    };
    const f64::vec3 disk = rgb(t.normal);
    at.n = f64::normal_over(f64::vector_of_disk(disk.x, disk.y), at.n);
    const f64::vec3 diffuse = rgb(t.diffuse);
    at.base_color = {diffuse.x, diffuse.y, diffuse.z};
    at.surface = f64::surface_colored(at.surface, diffuse, 0.0);
    at.surface.specular = rgb(t.specular);
    at.exemplar = found;
}

bool draws_normal_map_isotropic(Material m) {
    m.method = Method::normal_map;
    return drawn_method(m) == Method::gram_schmidt;
}

SurfaceAt surface_of(const Material& m, const TexturesAt& textures, const Hit& hit) {
    const Values values = material_values<f64::SurfaceMaterial>(m);
    SurfaceAt at;
    at.surface = values.surface;
    if (m.specular_texture || m.specular_color_texture) {
        const glm::vec3 f0 = m.specular_color * m.dielectric_f0 *
                             glm::vec3(textures.color(m.specular_color_texture));
        const float weight = m.specular * textures.color(m.specular_texture).a;
        at.surface =
            f64::surface_dielectric(at.surface, f64::vec3(f0), static_cast<double>(weight));
    }
    at.under_coat = has_coat(m);
    at.under_sheen = has_sheen(m);
    at.method = m.method;
    if (m.process) at.right = method_of(*m.process);
    at.conserve = m.conserve;
    if (values.compensated) at.albedos = albedo_table(m.brdf, m.mdf);
    at.grooves_along_x = values.grooves_along_x;
    at.half_vectors = !f64::brdf_is_cosine_lobe(at.surface.brdf);
    at.isotropic = draws_normal_map_isotropic(m);
    at.perturbed = m.normal_texture || cloth_of(m) != nullptr || tabulated_of(m) != nullptr;
    at.n = mapped_normal(m, textures);
    const glm::vec4 orm = textures.color(m.metallic_roughness_texture);
    put_lobe(at, m, values, textures, static_cast<double>(orm.y));
    // A texture scales the metallic factor down (material_state.cpp).
    if (m.metallic_roughness_texture && !m.conductor && tabulated_of(m) == nullptr)
        at.surface.has_diffuse = true;
    at.metallic = values.metallic * static_cast<double>(orm.z);
    at.base_color = glm::dvec3(values.base_color.x, values.base_color.y, values.base_color.z) *
                    glm::dvec3(textures.color(m.base_color_texture)) * glm::dvec3(hit.color);
    if (cloth_of(m)) at.base_color *= put_yarn(at, m, hit);
    const glm::dvec3 base = at.base_color;
    at.surface = f64::surface_colored(at.surface, {base.x, base.y, base.z}, at.metallic);
    if (tabulated_of(m)) put_texel(at, m, textures);
    return at;
}

}  // namespace

std::span<const float> ExemplarAt::table() const {
    if (exemplar < 0) return {};
    return {material->table(exemplar), index_of(material->grid.cells())};
}

std::span<const NdfOrigin> ExemplarAt::origin() const {
    if (exemplar < 0) return {};
    const std::size_t cells = index_of(material->grid.cells());
    return std::span(material->origin).subspan(index_of(exemplar) * cells, cells);
}

bool SurfaceAt::reflects() const {
    return (!yarn || yarn->covered) && (!exemplar || exemplar->exemplar >= 0);
}

SurfaceAt surface_at(const Scene& scene, const Hit& hit, glm::dvec3 to_eye) {
    SurfaceAt at = surface_of(drawn_material(material_at(scene, hit)), TexturesAt(scene, hit), hit);
    at.axes = f64::surface_frame(f64::vec3(hit.normal), f64::vec3(glm::vec3(hit.tangent)),
                                 static_cast<double>(hit.tangent.w), hit.front ? 1.0 : -1.0,
                                 f64::vec3(to_eye));
    return at;
}

glm::dvec3 to_tangent_frame(const SurfaceAt& at, glm::dvec3 world) {
    const f64::vec3 v = f64::frame_to_local(at.axes, f64::vec3(world));
    return {v.x, v.y, v.z};
}

glm::dvec3 to_world(const SurfaceAt& at, glm::dvec3 direction) {
    const f64::vec3 v = f64::frame_to_outer(at.axes, f64::vec3(direction));
    return {v.x, v.y, v.z};
}

}  // namespace burnish::viewer
