#include "reference/texture_pyramid.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>

#include "core/index_of.hpp"
#include "core/parallel.hpp"
#include "maps/normal/box_taps.hpp"
#include "scene/material/texture_sampler.hpp"

namespace burnish {
namespace {

// A texel whose channels are those of the texture: one channel is gray, two are gray and alpha.
glm::vec4 spread(const float* values, int channels) {
    if (channels >= 3) return {values[0], values[1], values[2], channels == 4 ? values[3] : 1.0f};
    return {values[0], values[0], values[0], channels == 2 ? values[1] : 1.0f};
}

float stored_channel(const glm::vec4& texel, int channel, int channels) {
    return channels == 2 && channel == 1 ? texel.w : texel[channel];
}

bool is_finite(const glm::vec4& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

// Within two repetitions, so that single precision keeps its digits for the place in the texture.
float turned(float at, Wrap wrap) {
    return wrap == Wrap::clamp ? std::clamp(at, -1.0f, 2.0f) : at - 2.0f * std::floor(0.5f * at);
}

}  // namespace

TexturePyramid::TexturePyramid(const Texture& texture, PyramidForm form)
    : texture_(&texture), form_(form) {
    if (form == PyramidForm::slopes)
        slopes_ = slope_mips(*texture_);
    else
        add_levels();
}

// Every level is the mean of the one before, by area.
void TexturePyramid::add_levels() {
    const int channels = texture_->channels;
    levels_.push_back({texture_->width, texture_->height, {}});
    const TextureUse use;
    while (levels_.back().width > 1 || levels_.back().height > 1) {
        const std::size_t above = levels_.size() - 1;
        const int from_x = levels_[above].width, from_y = levels_[above].height;
        Level level{std::max(from_x / 2, 1), std::max(from_y / 2, 1), {}};
        level.values.resize(index_of(level.width) * index_of(level.height) * index_of(channels));
        parallel_for(index_of(level.height), 16, [&](std::size_t begin, std::size_t end) {
            for (std::size_t row = begin; row < end; ++row) {
                const Taps ys = taps_of(static_cast<int>(row), from_y, level.height);
                for (int x = 0; x < level.width; ++x) {
                    const Taps xs = taps_of(x, from_x, level.width);
                    glm::dvec4 sum(0.0);
                    for (int j = 0; j < ys.count; ++j)
                        for (int i = 0; i < xs.count; ++i)
                            sum += glm::dvec4(texel(above, xs.first + i, ys.first + j, use)) *
                                   (xs.weight[i] * ys.weight[j]);
                    float* to = level.values.data() +
                                (row * index_of(level.width) + index_of(x)) * index_of(channels);
                    for (int c = 0; c < channels; ++c)
                        to[c] = stored_channel(glm::vec4(sum), c, channels);
                }
            }
        });
        levels_.push_back(std::move(level));
    }
}

glm::ivec2 TexturePyramid::size_of(std::size_t level) const {
    if (form_ == PyramidForm::slopes) return {slopes_[level].width, slopes_[level].height};
    return {levels_[level].width, levels_[level].height};
}

glm::vec4 TexturePyramid::texel(std::size_t level, int x, int y, const TextureUse& use) const {
    const glm::ivec2 size = size_of(level);
    const int column = wrapped_texel(x, size.x, use.wrap_s);
    const int row = wrapped_texel(y, size.y, use.wrap_t);
    const std::size_t at = index_of(row) * index_of(size.x) + index_of(column);
    if (form_ == PyramidForm::slopes) {
        const SlopeTexel& t = slopes_[level].texels[at];
        return {t.x, t.y, t.variance_x, t.variance_y};
    }
    if (level > 0)
        return spread(levels_[level].values.data() + at * index_of(texture_->channels),
                      texture_->channels);
    const glm::vec4 found = linear_texel(*texture_, column, row);
    if (is_finite(found)) return found;
    return form_ == PyramidForm::normal ? glm::vec4(0.5f, 0.5f, 1.0f, 0.5f) : glm::vec4(0.0f);
}

glm::vec4 TexturePyramid::at_level(std::size_t level, glm::vec2 place,
                                   const TextureUse& use) const {
    const glm::vec2 at = place * glm::vec2(size_of(level));
    if (use.nearest)
        return texel(level, static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)),
                     use);
    const glm::vec2 low = glm::floor(at - 0.5f);
    const glm::vec2 f = at - 0.5f - low;
    const int x = static_cast<int>(low.x), y = static_cast<int>(low.y);
    return glm::mix(glm::mix(texel(level, x, y, use), texel(level, x + 1, y, use), f.x),
                    glm::mix(texel(level, x, y + 1, use), texel(level, x + 1, y + 1, use), f.x),
                    f.y);
}

glm::vec4 TexturePyramid::at(const TextureUse& use, glm::vec2 uv,
                             const TextureFootprint& footprint) const {
    const glm::vec3 p = use.transform * glm::vec3(uv, 1.0f);
    const glm::vec2 place(turned(p.x, use.wrap_s), turned(p.y, use.wrap_t));
    const glm::mat2 turn(use.transform);
    const glm::vec2 size(size_of(0));
    const float side =
        std::max(glm::length(turn * footprint.a * size), glm::length(turn * footprint.b * size));
    const auto last = static_cast<float>(level_count() - 1);
    // 1e-6 texels: the logarithm of no footprint.
    const float lod = std::clamp(std::log2(std::max(side, 1e-6f)) - kFinerLevels, 0.0f, last);
    if (use.nearest) return at_level(static_cast<std::size_t>(std::lround(lod)), place, use);
    const auto fine = static_cast<std::size_t>(lod);
    const float between = lod - static_cast<float>(fine);
    const glm::vec4 value = at_level(fine, place, use);
    return between > 0.0f ? glm::mix(value, at_level(fine + 1, place, use), between) : value;
}

}  // namespace burnish
