// The parts of MaterialReader for materials that bring detail of their own: woven cloth and measured texels.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "burnish/draft.hpp"
#include "core/constants.hpp"
#include "core/index_of.hpp"
#include "maps/weave/weave_cells.hpp"
#include "rays/vectors.hpp"
#include "reference/material_reader.hpp"

namespace burnish {
namespace {

int in_repeat(float whole, int count) {
    const int i = static_cast<int>(std::fmod(whole, static_cast<float>(count)));
    return i < 0 ? i + count : i;
}

glm::vec3 yarn_color(const Material& m, bool warp, int end, int pick) {
    const Cloth& cloth = *cloth_of(m);
    const auto& stated = warp ? cloth.warp_color : cloth.weft_color;
    const auto& drawn = warp ? cloth.draft->warp_colors : cloth.draft->weft_colors;
    if (stated) return *stated;
    if (drawn.empty()) return glm::vec3(m.base_color);
    return drawn[index_of(warp ? end : pick) % drawn.size()];
}

}  // namespace

void MaterialReader::put_yarn(Shading& s, PointSurface& out, const SurfaceHit& hit) const {
    const Cloth& cloth = *cloth_of(m_);
    const glm::vec2 uv = own_coordinates(hit);
    // v runs down the texture square, picks up.
    const glm::vec2 place = glm::vec2(uv.x, 1.0f - uv.y) * cloth.yarns;
    const glm::vec2 whole = glm::floor(place);
    const int end = in_repeat(whole.x, cloth.draft->ends);
    const int pick = in_repeat(whole.y, cloth.draft->picks);
    const float twist = cloth.twist + m_.anisotropy_rotation;
    const f32::WeaveShape shape{cloth.crimp, cloth.bulge, cloth.gap,
                                f32::vec2(std::cos(twist), std::sin(twist))};
    const f32::WeavePoint point =
        f32::weave_point(weave_cell(*cloth.draft, end, pick), shape, place.x - whole.x - 0.5f,
                         place.y - whole.y - 0.5f);
    out.reflects = point.cover > 0.5f;
    s.base_color = s.base_color * to_f32(yarn_color(m_, point.warp > 0.5f, end, pick));
    s.direction = point.fiber;
    s.n = point.n;
}

void MaterialReader::put_texel(Shading& s, PointSurface& out, const SurfaceHit& hit,
                               const glm::vec2& xi) const {
    const TabulatedMaterial& t = *tabulated_of(m_)->material;
    const glm::vec2 size(static_cast<float>(t.width), static_cast<float>(t.height));
    // A step of half a texel either way has the four texels about the point by their bilinear weights.
    const glm::vec2 place = glm::floor(own_coordinates(hit) * size + xi - 0.5f);
    const std::size_t texel = index_of(in_repeat(place.y, t.height)) * index_of(t.width) +
                              index_of(in_repeat(place.x, t.width));
    const std::uint16_t exemplar = t.exemplar[texel];
    out.reflects = exemplar != TabulatedMaterial::kNoExemplar;
    if (!out.reflects) return;
    const auto color = [&](const Image& image) {
        const float* p = image.pixels.data() + 3 * texel;
        return f32::vec3(p[0], p[1], p[2]);
    };
    s.base_color = color(t.diffuse);
    s.surface = f32::surface_colored(s.surface, s.base_color, s.metallic);
    s.surface.specular = color(t.specular);
    const f32::vec3 disk = color(t.normal);
    s.n = f32::normal_over(f32::vector_of_disk(disk.x, disk.y), s.n);
    const float groove = t.groove[exemplar];
    const bool follows = method_ == f32::kMethodFollowGrain;
    const float angle = t.angle[texel] + (follows ? groove : 0.0f);
    out.table = &tables_[exemplar];
    out.table_groove = f32::tabulated_rotation(method_, groove / static_cast<float>(kTwoPi));
    s.direction = f32::direction_added(f32::vec2(std::cos(angle), std::sin(angle)), turn_);
    out.grooves_along_x = true;
}

}  // namespace burnish
