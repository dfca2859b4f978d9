#include "gpu/upload/cloth_maps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <span>
#include <string>
#include <utility>

#include "burnish/draft.hpp"
#include "burnish/error.hpp"
#include "gpu/device/texture_units.hpp"
#include "maps/weave/cloth_levels.hpp"
#include "scene/material/material_values.hpp"

namespace burnish::gpu {
namespace {

f32::WeaveShape shape_of(const Cloth& c) {
    return {c.crimp, c.bulge, c.gap, {1.0f, 0.0f}};
}

// Cosine and sine of the angle from the yarn to the x axis of the lobe.
f32::vec2 turn_of(const Material& m) {
    const float angle = cloth_of(m)->twist + m.anisotropy_rotation;
    return {std::cos(angle), std::sin(angle)};
}

void upload_levels(GLuint texture, const std::vector<ClothLevel>& levels, bool warp) {
    glActiveTexture(GL_TEXTURE0 + kScratchUnit);
    glBindTexture(GL_TEXTURE_2D, texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const ClothLevel& l = levels[i];
        glTexImage2D(GL_TEXTURE_2D, static_cast<GLint>(i), GL_RGBA16F, l.width, l.height, 0,
                     GL_RGBA, GL_FLOAT, (warp ? l.warp : l.weft).data());
    }
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, static_cast<GLint>(levels.size()) - 1);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glBindTexture(GL_TEXTURE_2D, 0);
}

void upload_cells(GLuint texture, const Draft& draft) {
    const std::vector<std::uint8_t> bits = weave_bits(draft);
    glActiveTexture(GL_TEXTURE0 + kScratchUnit);
    glBindTexture(GL_TEXTURE_2D, texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8UI, draft.ends, draft.picks, 0, GL_RED_INTEGER,
                 GL_UNSIGNED_BYTE, bits.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindTexture(GL_TEXTURE_2D, 0);
}

void upload_lobes(GLuint texture, const ClothMeans& means) {
    glActiveTexture(GL_TEXTURE0 + kScratchUnit);
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    std::vector<std::array<float, 4>> texels;
    for (const WeaveMean* mean : {&means.weft, &means.warp})
        texels.insert(texels.end(), mean->table.begin(), mean->table.end());
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA16F, means.weft.side, means.weft.side, 2, 0,
                 GL_RGBA, GL_FLOAT, texels.data());
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
    for (const GLenum name :
         std::initializer_list<GLenum>{GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D_ARRAY, name, GL_LINEAR);
    for (const GLenum name : std::initializer_list<GLenum>{GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glTexParameteri(GL_TEXTURE_2D_ARRAY, name, GL_CLAMP_TO_EDGE);
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
}

glm::vec3 base_of(const Material& m) {
    return glm::vec3(m.base_color);
}

// Whether the levels of one cloth serve the other.
bool same_levels(const Material& a, const Material& b) {
    const Cloth &c = *cloth_of(a), &d = *cloth_of(b);
    return c.draft == d.draft && c.gap == d.gap && c.warp_color == d.warp_color &&
           c.weft_color == d.weft_color && base_of(a) == base_of(b);
}

glm::vec4 lobe_words(const f32::Lobe& lobe) {
    return {lobe.p0, lobe.p1, lobe.paper_norm, lobe.projected_norm};
}

void bind_texture(Program& program, const char* name, GLuint unit, GLenum target, GLuint texture) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(target, texture);
    program.set(name, static_cast<int>(unit));
}

}  // namespace

bool has_yarn_colors(const Cloth& cloth) {
    const Draft& d = *cloth.draft;
    return (!cloth.warp_color && !d.warp_colors.empty()) ||
           (!cloth.weft_color && !d.weft_colors.empty());
}

ClothLobe cloth_lobe_of(const Material& m) {
    const Cloth& cloth = *cloth_of(m);
    const WeaveLobe lobe{static_cast<int>(m.brdf), lobe_of(m), static_cast<int>(drawn_method(m)),
                         m.conserve, turn_of(m)};
    return {weave_families(*cloth.draft), shape_of(cloth), lobe};
}

bool ClothMaps::serves(const Material& material,
                       const std::shared_ptr<const ClothMeans>& means) const {
    return means_ == means && same_levels(material_, material);
}

ClothMaps::ClothMaps(const Material& m, std::shared_ptr<const ClothMeans> means)
    : material_(m), means_(std::move(means)) {
    const Cloth& cloth = *cloth_of(m);
    const Draft& draft = *cloth.draft;
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    if (draft.ends > most || draft.picks > most)
        throw Error(draft.name, "repeat",
                    "at most " + std::to_string(most) + " yarns a side on this device",
                    std::to_string(draft.ends) + " x " + std::to_string(draft.picks));
    warp_color_ = cloth.warp_color.value_or(base_of(m));
    weft_color_ = cloth.weft_color.value_or(base_of(m));
    const bool warp_from_draft = !cloth.warp_color && !draft.warp_colors.empty();
    const bool weft_from_draft = !cloth.weft_color && !draft.weft_colors.empty();
    const std::vector<ClothLevel> levels =
        cloth_levels(draft, cloth.gap, warp_color_, weft_color_, warp_from_draft, weft_from_draft);
    upload_cells(cells_.get(), draft);
    upload_levels(weft_.get(), levels, false);
    upload_levels(warp_.get(), levels, true);
    upload_lobes(lobes_.get(), *means_);
    const f32::Lobe lobe = lobe_of(m);
    int layer = 0;
    for (const WeaveMean* mean : {&means_->weft, &means_->warp})
        wide_lobe_[layer++] = lobe_words(f32::widen_lobe(lobe, mean->variance.x, mean->variance.y));
    check_gl("uploading a weave");
}

void ClothMaps::bind(Program& program, const Material& m) const {
    bind_texture(program, "u_weave_cells", kWeaveCellsUnit, GL_TEXTURE_2D, cells_.get());
    bind_texture(program, "u_weave_weft", kWeaveWeftUnit, GL_TEXTURE_2D, weft_.get());
    bind_texture(program, "u_weave_warp", kWeaveWarpUnit, GL_TEXTURE_2D, warp_.get());
    bind_texture(program, "u_weave_lobes", kWeaveLobesUnit, GL_TEXTURE_2D_ARRAY, lobes_.get());
    const Cloth& cloth = *cloth_of(m);
    const f32::vec2 turn = turn_of(m);
    program.set("u_weave_yarns", cloth.yarns);
    program.set("u_weave_shape", glm::vec3(cloth.crimp, cloth.bulge, cloth.gap));
    program.set("u_weave_twist", glm::vec2(turn.x, turn.y));
    const WeaveMean* means[] = {&means_->weft, &means_->warp};
    std::array<glm::vec3, 2> nodes, widths;
    for (std::size_t i = 0; i < 2; ++i) {
        nodes[i] = means[i]->node;
        widths[i] = glm::vec3(means[i]->width, means[i]->peak);
    }
    const std::array<glm::vec3, 2> colors = {weft_color_, warp_color_};
    program.set("u_weave_nodes", std::span<const glm::vec3>(nodes));
    program.set("u_weave_widths", std::span<const glm::vec3>(widths));
    program.set("u_weave_colors", std::span<const glm::vec3>(colors));
    program.set("u_weave_wide_lobes", std::span<const glm::vec4>(wide_lobe_));
}

}  // namespace burnish::gpu
