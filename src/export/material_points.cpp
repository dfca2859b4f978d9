#include "export/material_points.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <memory>
#include <numbers>
#include <vector>

#include "burnish/conductors.hpp"
#include "burnish/draft.hpp"
#include "burnish/f32.hpp"
#include "burnish/material_textures.hpp"
#include "burnish/tabulated_material.hpp"
#include "maps/weave/weave_cells.hpp"
#include "scene/material/material_values.hpp"
#include "scene/material/texture_sampler.hpp"
#include "scene/material/texture_uses.hpp"

namespace burnish {
namespace {

// Points along a side of a weave's cell: a yarn's tilt then changes by less than 1/8 of its range.
constexpr float kPointsAYarn = 16.0f;

glm::vec2 of(f32::vec2 v) {
    return {v.x, v.y};
}

// Everything but the lobe and the normal: the same for all kinds of material.
class CommonPoints {
  public:
    // `color`: the factor of the base color texture.
    CommonPoints(const Material& m, std::span<const Texture> textures, glm::vec4 color)
        : material_(m),
          color_(color),
          base_(m.base_color_texture, textures),
          orm_(m.metallic_roughness_texture, textures),
          occlusion_(m.occlusion_texture, textures),
          emissive_(m.emissive_texture, textures) {}

    // `roughness`: the factor of the texture.
    MaterialPoint at(glm::vec2 uv, float& roughness) const {
        MaterialPoint p;
        p.base_color = color_ * base_.at(uv);
        const glm::vec4 orm = orm_.at(uv);
        roughness = orm.y;
        p.metallic = material_.metallic * orm.z;
        p.occlusion = 1.0f + material_.occlusion_strength * (occlusion_.at(uv).x - 1.0f);
        p.emissive = material_.emissive * glm::vec3(emissive_.at(uv));
        if (!material_.conductor) return p;
        p.base_color = glm::vec4(normal_reflectance(*material_.conductor), p.base_color.a);
        p.metallic = 1.0f;
        return p;
    }

  private:
    const Material& material_;
    glm::vec4 color_;
    TextureSampler base_, orm_, occlusion_, emissive_;
};

std::vector<const TextureUse*> uses_of(const Material& m) {
    std::vector<const TextureUse*> uses;
    for (const TextureUse* use : texture_uses(m))
        if (*use) uses.push_back(use);
    return uses;
}

// The transform that all textures of the material share; the identity where they differ.
glm::mat3 shared_transform(const Material& m) {
    const std::vector<const TextureUse*> uses = uses_of(m);
    if (uses.empty()) return glm::mat3(1.0f);
    for (const TextureUse* use : uses)
        if (use->transform != uses.front()->transform) return glm::mat3(1.0f);
    return uses.front()->transform;
}

// A transform without an inverse shows a line or a point of its texture.
glm::mat3 inverse_of(const glm::mat3& tile) {
    return glm::determinant(tile) == 0.0f ? glm::mat3(1.0f) : glm::inverse(tile);
}

// Texels that the textures have along the sides of the tile.
glm::vec2 texels_of(const Material& m, std::span<const Texture> textures, const glm::mat3& tile) {
    glm::vec2 most(1.0f);
    for (const TextureUse* use : uses_of(m)) {
        const Texture& t = textures[static_cast<std::size_t>(use->texture)];
        const glm::mat3 from_tile = use->transform * inverse_of(tile);
        const glm::vec2 size(static_cast<float>(t.width), static_cast<float>(t.height));
        for (int side = 0; side < 2; ++side)
            most[side] = std::max(most[side], glm::length(glm::vec2(from_tile[side]) * size));
    }
    return most;
}

bool shows_alpha(const Material& m, std::span<const Texture> textures) {
    if (m.alpha_mode == AlphaMode::opaque) return false;
    if (m.base_color.a < 1.0f) return true;
    if (!m.base_color_texture) return false;
    const int channels = textures[static_cast<std::size_t>(m.base_color_texture.texture)].channels;
    return channels == 2 || channels == 4;
}

bool glows(const Material& m) {
    return m.emissive != glm::vec3(0.0f);
}

// The slopes that a normal map states, as the renderer reads it.
class NormalPoints {
  public:
    NormalPoints(const Material& m, std::span<const Texture> textures)
        : map_(m.normal_texture, textures),
          scale_(m.normal_scale, m.flip_green ? -m.normal_scale : m.normal_scale),
          two_channels_(map_ && map_.texture()->channels == 2) {}

    glm::vec2 slope(glm::vec2 uv) const {
        if (!map_) return glm::vec2(0.0f);
        const glm::vec4 texel = map_.at(uv);
        const f32::vec3 v = two_channels_
                                ? f32::vector_of_texel(f32::vec2(texel.x, texel.w))
                                : f32::vector_of_texel(f32::vec3(texel.x, texel.y, texel.z));
        const f32::vec3 n = f32::normal_of_vector(v, f32::vec2(scale_.x, scale_.y));
        return of(f32::slopes_of_normal(n));
    }

  private:
    TextureSampler map_;
    glm::vec2 scale_;
    bool two_channels_;
};

// The lobe of a material whose roughness and strength textures multiply, and its direction.
class LobePoints {
  public:
    LobePoints(const Material& m, std::span<const Texture> textures)
        : anisotropy_(m.anisotropy_texture, textures),
          rotation_(std::cos(m.anisotropy_rotation + m.anisotropy_texture_turn),
                    std::sin(m.anisotropy_rotation + m.anisotropy_texture_turn)),
          gltf_(gltf_lobe_of(m) ? *gltf_lobe_of(m) : GltfLobe{}),
          is_gltf_(gltf_lobe_of(m) != nullptr),
          alpha_(alpha_of(m)) {}

    void put(MaterialPoint& p, glm::vec2 uv, float roughness) const {
        float strength = gltf_.anisotropy_strength;
        p.direction = rotation_;
        if (anisotropy_) {
            const glm::vec4 texel = anisotropy_.at(uv);
            p.direction = of(f32::stretch_direction(f32::vec2(texel.x, texel.y),
                                                    f32::vec2(rotation_.x, rotation_.y)));
            strength *= texel.z;
        }
        p.alpha =
            is_gltf_
                ? of(f32::alpha_of_roughness(std::clamp(gltf_.roughness * roughness, 0.0f, 1.0f),
                                             std::clamp(strength, 0.0f, 1.0f)))
                : alpha_;
    }

  private:
    TextureSampler anisotropy_;
    glm::vec2 rotation_;
    GltfLobe gltf_;
    bool is_gltf_;
    glm::vec2 alpha_;
};

}  // namespace

bool has_textures(const Material& material) {
    return !uses_of(material).empty();
}

glm::ivec2 cloth_repeats(const Draft& draft) {
    return {usual_repeats(draft.ends), usual_repeats(draft.picks)};
}

MaterialPoints points_of_textures(const Material& m, std::span<const Texture> textures) {
    MaterialPoints out;
    out.tile = shared_transform(m);
    out.detail = texels_of(m, textures, out.tile);
    out.has_alpha = shows_alpha(m, textures);
    out.has_emission = glows(m);
    out.at = [common = CommonPoints(m, textures, m.base_color), normal = NormalPoints(m, textures),
              lobe = LobePoints(m, textures), uv_of = inverse_of(out.tile)](glm::vec2 at) {
        const glm::vec2 uv(uv_of * glm::vec3(at, 1.0f));
        float roughness = 1.0f;
        MaterialPoint p = common.at(uv, roughness);
        lobe.put(p, uv, roughness);
        p.slope = normal.slope(uv);
        return p;
    };
    return out;
}

// --- weaves ---------------------------------------------------------------------------------------

namespace {

class ClothPoints {
  public:
    ClothPoints(const Material& m, std::span<const Texture> textures, bool textured)
        : common_(m, textures, glm::vec4(1.0f, 1.0f, 1.0f, m.base_color.a)),
          cloth_(*cloth_of(m)),
          undyed_(m.base_color),
          yarns_(cloth_.yarns) {
        const Draft& draft = *cloth_.draft;
        cells_ = weave_bits(draft);
        shape_.crimp = cloth_.crimp;
        shape_.bulge = cloth_.bulge;
        shape_.gap = cloth_.gap;
        const float twist = cloth_.twist + m.anisotropy_rotation;
        shape_.twist = f32::vec2(std::cos(twist), std::sin(twist));
        const f32::Lobe lobe = lobe_of(m);
        alpha_ = {f32::lobe_alpha_x(lobe), f32::lobe_alpha_y(lobe)};
        const glm::ivec2 repeats = cloth_repeats(draft);
        const glm::vec2 across(static_cast<float>(draft.ends * repeats.x),
                               static_cast<float>(draft.picks * repeats.y));
        if (textured) return;
        // The first pick is at the bottom of the texture square and of the tile: v' = 1 - (1 - v) s.
        const glm::vec2 s(yarns_ / across.x, yarns_ / across.y);
        tile_ = glm::mat3(s.x, 0.0f, 0.0f, 0.0f, s.y, 0.0f, 0.0f, 1.0f - s.y, 1.0f);
        uv_of_ = glm::inverse(tile_);
        yarns_of_tile_ = across;
    }

    const glm::mat3& tile() const { return tile_; }
    glm::vec2 yarns_of_tile() const {
        return yarns_of_tile_ == glm::vec2(0.0f) ? glm::vec2(yarns_) : yarns_of_tile_;
    }

    MaterialPoint at(glm::vec2 in_tile) const {
        const glm::vec2 uv(uv_of_ * glm::vec3(in_tile, 1.0f));
        float roughness = 1.0f;
        MaterialPoint p = common_.at(uv, roughness);
        // Of the tile, so that its sides meet whatever `yarns` is.
        const glm::vec2 place = glm::vec2(in_tile.x, 1.0f - in_tile.y) * yarns_of_tile();
        const glm::vec2 whole = glm::floor(place);
        const Draft& draft = *cloth_.draft;
        const int end = in_repeat(whole.x, draft.ends), pick = in_repeat(whole.y, draft.picks);
        const int bits = cells_[static_cast<std::size_t>(pick * draft.ends + end)];
        const f32::WeavePoint point =
            f32::weave_point(f32::weave_cell_of_bits(bits), shape_, place.x - whole.x - 0.5f,
                             place.y - whole.y - 0.5f);
        if (!(point.cover > 0.0f)) return hole(p);
        p.base_color *= glm::vec4(color(point.warp > 0.5f, end, pick), 1.0f);
        p.alpha = alpha_;
        p.direction = of(point.fiber);
        p.slope = of(f32::slopes_of_normal(point.n));
        return p;
    }

  private:
    static int in_repeat(float whole, int count) {
        const int i = static_cast<int>(whole) % count;
        return i < 0 ? i + count : i;
    }

    // A hole reflects nothing: a black metal of roughness 1 comes near.
    static MaterialPoint hole(MaterialPoint p) {
        p.base_color = glm::vec4(0.0f, 0.0f, 0.0f, p.base_color.a);
        p.metallic = 1.0f;
        p.emissive = glm::vec3(0.0f);
        return p;
    }

    glm::vec3 color(bool warp, int end, int pick) const {
        const Draft& draft = *cloth_.draft;
        const std::optional<glm::vec3>& stated = warp ? cloth_.warp_color : cloth_.weft_color;
        const std::vector<glm::vec3>& drawn = warp ? draft.warp_colors : draft.weft_colors;
        if (stated) return *stated;
        if (drawn.empty()) return undyed_;
        return drawn[static_cast<std::size_t>(warp ? end : pick) % drawn.size()];
    }

    CommonPoints common_;
    Cloth cloth_;
    glm::vec3 undyed_;  // of yarns for which nothing states a color
    float yarns_;
    std::vector<std::uint8_t> cells_;
    f32::WeaveShape shape_;
    glm::vec2 alpha_{1.0f};
    glm::mat3 tile_{1.0f}, uv_of_{1.0f};
    glm::vec2 yarns_of_tile_{0.0f};
};

}  // namespace

MaterialPoints points_of_cloth(const Material& m, std::span<const Texture> textures) {
    const auto cloth = std::make_shared<const ClothPoints>(m, textures, has_textures(m));
    MaterialPoints out;
    out.tile = cloth->tile();
    out.detail = glm::max(kPointsAYarn * cloth->yarns_of_tile(), texels_of(m, textures, out.tile));
    out.has_alpha = shows_alpha(m, textures);
    out.has_emission = glows(m);
    out.at = [cloth](glm::vec2 at) { return cloth->at(at); };
    return out;
}

// --- measured materials -----------------------------------------------------------------------------

namespace {

class TablePoints {
  public:
    TablePoints(const Material& m, std::span<const Texture> textures)
        : common_(m, textures, m.base_color),
          normal_(m, textures),
          table_(tabulated_of(m)->material),
          lobes_(fit_lobes(*table_, Mdf::ggx)),
          f0_(dielectric_f0_of(*table_)),
          rotation_(m.anisotropy_rotation) {}

    glm::vec2 size() const {
        return {static_cast<float>(table_->width), static_cast<float>(table_->height)};
    }

    bool masked() const {
        return std::find(table_->exemplar.begin(), table_->exemplar.end(),
                         TabulatedMaterial::kNoExemplar) != table_->exemplar.end();
    }

    MaterialPoint at(glm::vec2 in_tile, glm::vec2 uv) const {
        float roughness = 1.0f;
        MaterialPoint p = common_.at(uv, roughness);
        const TabulatedMaterial& t = *table_;
        const auto index = [](float v, int size) {
            return std::clamp(static_cast<int>((v - std::floor(v)) * static_cast<float>(size)), 0,
                              size - 1);
        };
        const std::size_t texel = static_cast<std::size_t>(index(in_tile.y, t.height)) *
                                      static_cast<std::size_t>(t.width) +
                                  static_cast<std::size_t>(index(in_tile.x, t.width));
        if (t.exemplar[texel] == TabulatedMaterial::kNoExemplar) {
            p.base_color.a = 0.0f;
            return p;
        }
        const MetallicColor color =
            metallic_color(rgb(t.diffuse, texel), rgb(t.specular, texel), f0_);
        p.base_color = glm::vec4(color.base[0], color.base[1], color.base[2], p.base_color.a);
        p.metallic = color.metallic;
        const LobeFit& lobe = lobes_[t.exemplar[texel]];
        p.alpha = {static_cast<float>(lobe.alpha_along), static_cast<float>(lobe.alpha_across)};
        const double groove = groove_at(t, lobes_, texel) + static_cast<double>(rotation_);
        p.direction = {static_cast<float>(std::cos(groove)), static_cast<float>(std::sin(groove))};
        const float* n = t.normal.pixels.data() + 3 * texel;
        const glm::vec2 detail = normal_.slope(uv);
        p.slope = of(f32::slopes_of_normal(f32::normal_over(
            f32::vec3(n[0], n[1], n[2]), f32::normal_of_slopes(detail.x, detail.y))));
        return p;
    }

  private:
    static std::array<float, 3> rgb(const Image& image, std::size_t texel) {
        const float* p = image.pixels.data() + 3 * texel;
        return {p[0], p[1], p[2]};
    }

    CommonPoints common_;
    NormalPoints normal_;
    std::shared_ptr<const TabulatedMaterial> table_;
    std::vector<LobeFit> lobes_;
    float f0_;  // of the texels that are dielectrics
    float rotation_;
};

}  // namespace

MaterialPoints points_of_table(const Material& m, std::span<const Texture> textures) {
    const auto table = std::make_shared<const TablePoints>(m, textures);
    MaterialPoints out;
    out.tile = m.normal_texture.transform;
    out.detail = glm::max(table->size(), texels_of(m, textures, out.tile));
    out.has_alpha = table->masked();
    out.has_emission = glows(m);
    out.at = [table, uv_of = inverse_of(out.tile)](glm::vec2 at) {
        return table->at(at, glm::vec2(uv_of * glm::vec3(at, 1.0f)));
    };
    return out;
}

}  // namespace burnish
