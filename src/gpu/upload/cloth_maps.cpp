#include "gpu/upload/cloth_maps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <span>
#include <string>

#include "burnish/error.hpp"
#include "gpu/device/texture_units.hpp"
#include "maps/weave/draft.hpp"
#include "scene/material/material_lobe.hpp"

namespace burnish::gpu {
namespace {

std::size_t index_of(int i) {
    return static_cast<std::size_t>(i);
}

f32::WeaveShape shape_of(const Cloth& c) {
    return {c.crimp, c.bulge, c.gap, {1.0f, 0.0f}};
}

// From the yarn to the lobe's x axis.
f32::vec2 turn_of(const Material& m) {
    const float angle = cloth_of(m)->twist + m.anisotropy_rotation;
    return {std::cos(angle), std::sin(angle)};
}

// The mean over [low, high] of values a unit wide: weights of the first and the last, and the sum.
template <typename Value>
glm::vec4 mean_over(float low, float high, int count, Value value) {
    glm::vec4 sum(0.0f);
    for (int i = std::max(static_cast<int>(low), 0);
         i < std::min(static_cast<int>(std::ceil(high)), count); ++i) {
        const float part =
            std::min(high, static_cast<float>(i + 1)) - std::max(low, static_cast<float>(i));
        sum += value(i) * std::max(part, 0.0f);
    }
    return sum / (high - low);
}

std::vector<glm::vec4> reduced(const std::vector<glm::vec4>& from, int width, int height,
                               int to_width, int to_height) {
    const auto span = [](int i, int count, int of) {
        const float each = static_cast<float>(of) / static_cast<float>(count);
        return glm::vec2(each * static_cast<float>(i), each * static_cast<float>(i + 1));
    };
    std::vector<glm::vec4> rows(index_of(to_width) * index_of(height));
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < to_width; ++x) {
            const glm::vec2 s = span(x, to_width, width);
            rows[index_of(y) * index_of(to_width) + index_of(x)] =
                mean_over(s.x, s.y, width,
                          [&](int i) { return from[index_of(y) * index_of(width) + index_of(i)]; });
        }
    }
    std::vector<glm::vec4> to(index_of(to_width) * index_of(to_height));
    for (int y = 0; y < to_height; ++y) {
        for (int x = 0; x < to_width; ++x) {
            const glm::vec2 s = span(y, to_height, height);
            to[index_of(y) * index_of(to_width) + index_of(x)] = mean_over(
                s.x, s.y, height,
                [&](int i) { return rows[index_of(i) * index_of(to_width) + index_of(x)]; });
        }
    }
    return to;
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

void upload_lobes(GLuint texture, std::initializer_list<const WeaveMean*> means) {
    glActiveTexture(GL_TEXTURE0 + kScratchUnit);
    glBindTexture(GL_TEXTURE_2D_ARRAY, texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    std::vector<std::array<float, 4>> texels;
    for (const WeaveMean* mean : means)
        texels.insert(texels.end(), mean->table.begin(), mean->table.end());
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA16F, kWeaveTableSide, kWeaveTableSide,
                 static_cast<GLsizei>(means.size()), 0, GL_RGBA, GL_FLOAT, texels.data());
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

// Whether maps made for one serve the other.
bool same_cloth(const Material& a, const Material& b) {
    const Cloth &c = *cloth_of(a), &d = *cloth_of(b);
    return c.draft == d.draft && c.crimp == d.crimp && c.bulge == d.bulge && c.gap == d.gap &&
           c.twist == d.twist && c.fuzz == d.fuzz && c.warp_color == d.warp_color &&
           c.weft_color == d.weft_color && alpha_of(a) == alpha_of(b) && a.mdf == b.mdf &&
           a.brdf == b.brdf && a.method == b.method && a.conserve == b.conserve &&
           a.anisotropy_rotation == b.anisotropy_rotation && base_of(a) == base_of(b);
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
    return (!cloth.warp_color && !d.warp_colours.empty()) ||
           (!cloth.weft_color && !d.weft_colours.empty());
}

std::vector<ClothLevel> cloth_levels(const Draft& draft, float gap, glm::vec3 warp_color,
                                     glm::vec3 weft_color, bool warp_from_draft,
                                     bool weft_from_draft) {
    ClothLevel first;
    first.width = draft.ends;
    first.height = draft.picks;
    for (int pick = 0; pick < draft.picks; ++pick) {
        for (int end = 0; end < draft.ends; ++end) {
            const bool up = draft.is_warp_up(end, pick);
            const float upper = f32::weave_upper_share(gap), lower = f32::weave_lower_share(gap);
            const glm::vec3 warp = warp_from_draft ? draft.warp_colours[index_of(end)] : warp_color;
            const glm::vec3 weft =
                weft_from_draft ? draft.weft_colours[index_of(pick)] : weft_color;
            first.warp.push_back(glm::vec4(warp, 1.0f) * (up ? upper : lower));
            first.weft.push_back(glm::vec4(weft, 1.0f) * (up ? lower : upper));
        }
    }
    std::vector<ClothLevel> levels{std::move(first)};
    while (levels.back().width > 1 || levels.back().height > 1) {
        const ClothLevel& last = levels.back();
        ClothLevel next;
        next.width = std::max(last.width / 2, 1);
        next.height = std::max(last.height / 2, 1);
        next.warp = reduced(last.warp, last.width, last.height, next.width, next.height);
        next.weft = reduced(last.weft, last.width, last.height, next.width, next.height);
        levels.push_back(std::move(next));
    }
    return levels;
}

void ClothMaps::make(Made& made, const Material& m) {
    const Cloth& cloth = *cloth_of(m);
    const Draft& draft = *cloth.draft;
    GLint most = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
    if (draft.ends > most || draft.picks > most)
        throw Error(draft.name, "repeat",
                    "at most " + std::to_string(most) + " yarns a side on this device",
                    std::to_string(draft.ends) + " x " + std::to_string(draft.picks));
    made.material = m;
    made.warp_color = cloth.warp_color.value_or(base_of(m));
    made.weft_color = cloth.weft_color.value_or(base_of(m));
    const bool warp_from_draft = !cloth.warp_color && !draft.warp_colours.empty();
    const bool weft_from_draft = !cloth.weft_color && !draft.weft_colours.empty();
    const std::vector<ClothLevel> levels = cloth_levels(
        draft, cloth.gap, made.warp_color, made.weft_color, warp_from_draft, weft_from_draft);
    upload_cells(made.cells.get(), draft);
    upload_levels(made.weft.get(), levels, false);
    upload_levels(made.warp.get(), levels, true);
    const WeaveLobe lobe{static_cast<int>(m.brdf), lobe_of(m), static_cast<int>(drawn_method(m)),
                         m.conserve, turn_of(m)};
    const WeaveFamilies families = weave_families(draft);
    made.weft_mean = weave_mean(families.weft, shape_of(cloth), lobe);
    made.warp_mean = weave_mean(families.warp, shape_of(cloth), lobe);
    upload_lobes(made.lobes.get(), {&made.weft_mean, &made.warp_mean});
    int layer = 0;
    for (WeaveMean* mean : {&made.weft_mean, &made.warp_mean}) {
        mean->table.clear();
        made.wide_lobe[layer++] =
            lobe_words(f32::widen_lobe(lobe.lobe, mean->variance.x, mean->variance.y));
    }
    check_gl("uploading a weave");
}

void ClothMaps::bind(Program& program, int index, const Material& m) {
    std::unique_ptr<Made>& made = made_[index];
    if (!made || !same_cloth(made->material, m)) {
        made = std::make_unique<Made>();
        make(*made, m);
    }
    bind_texture(program, "u_weave_cells", kWeaveCellsUnit, GL_TEXTURE_2D, made->cells.get());
    bind_texture(program, "u_weave_weft", kWeaveWeftUnit, GL_TEXTURE_2D, made->weft.get());
    bind_texture(program, "u_weave_warp", kWeaveWarpUnit, GL_TEXTURE_2D, made->warp.get());
    bind_texture(program, "u_weave_lobes", kWeaveLobesUnit, GL_TEXTURE_2D_ARRAY, made->lobes.get());
    const Cloth& cloth = *cloth_of(m);
    const f32::vec2 turn = turn_of(m);
    program.set("u_weave_yarns", cloth.yarns);
    program.set("u_weave_shape", glm::vec3(cloth.crimp, cloth.bulge, cloth.gap));
    program.set("u_weave_twist", glm::vec2(turn.x, turn.y));
    const WeaveMean* means[] = {&made->weft_mean, &made->warp_mean};
    std::array<glm::vec3, 2> nodes, widths;
    for (std::size_t i = 0; i < 2; ++i) {
        nodes[i] = means[i]->node;
        widths[i] = glm::vec3(means[i]->width, means[i]->peak);
    }
    const std::array<glm::vec3, 2> colors = {made->weft_color, made->warp_color};
    program.set("u_weave_nodes", std::span<const glm::vec3>(nodes));
    program.set("u_weave_widths", std::span<const glm::vec3>(widths));
    program.set("u_weave_colors", std::span<const glm::vec3>(colors));
    program.set("u_weave_wide_lobes", std::span<const glm::vec4>(made->wide_lobe));
}

}  // namespace burnish::gpu
