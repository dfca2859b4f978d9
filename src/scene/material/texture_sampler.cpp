#include "scene/material/texture_sampler.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "burnish/image_io.hpp"
#include "image/texel_value.hpp"

namespace burnish {
namespace {

const std::array<float, 256>& linear_of_bytes() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> t{};
        for (std::size_t i = 0; i < t.size(); ++i)
            t[i] = linear_from_srgb(static_cast<float>(i) / 255.0f);
        return t;
    }();
    return table;
}

float channel_at(const Texture& texture, std::size_t index, bool color) {
    const bool encoded = color && texture.color_space == ColorSpace::srgb;
    if (!encoded) return texel_value(texture, index);
    if (texture.type == TexelType::u8)
        return linear_of_bytes()[std::to_integer<std::size_t>(texture.texels[index])];
    return texture.type == TexelType::u16 ? linear_from_srgb(texel_value(texture, index))
                                          : texel_value(texture, index);
}

}  // namespace

int wrapped_texel(int i, int size, Wrap wrap) {
    if (i >= 0 && i < size) return i;
    if (wrap == Wrap::clamp) return std::clamp(i, 0, size - 1);
    const int period = wrap == Wrap::mirror ? 2 * size : size;
    const int at = ((i % period) + period) % period;
    return at < size ? at : period - 1 - at;
}

glm::vec4 linear_texel(const Texture& t, int column, int row) {
    const auto channels = static_cast<std::size_t>(t.channels);
    const std::size_t at =
        channels * (static_cast<std::size_t>(row) * static_cast<std::size_t>(t.width) +
                    static_cast<std::size_t>(column));
    glm::vec4 out(1.0f);
    if (t.channels >= 3) {
        for (std::size_t c = 0; c < channels; ++c)
            out[static_cast<int>(c)] = channel_at(t, at + c, c < 3);
    } else {
        out.x = out.y = out.z = channel_at(t, at, true);
        if (t.channels == 2) out.w = channel_at(t, at + 1, false);
    }
    return out;
}

TextureSampler::TextureSampler(const TextureUse& use, std::span<const Texture> textures)
    : use_(use) {
    if (!use) return;
    const Texture& texture = textures[static_cast<std::size_t>(use.texture)];
    if (!texture.empty()) texture_ = &texture;
}

glm::vec4 TextureSampler::texel(int x, int y) const {
    return linear_texel(*texture_, wrapped_texel(x, texture_->width, use_.wrap_s),
                        wrapped_texel(y, texture_->height, use_.wrap_t));
}

glm::vec4 TextureSampler::at(glm::vec2 uv) const {
    if (texture_ == nullptr) return glm::vec4(1.0f);
    const glm::vec3 p = use_.transform * glm::vec3(uv, 1.0f);
    const glm::vec2 size(static_cast<float>(texture_->width), static_cast<float>(texture_->height));
    // Whole turns first, so that single precision keeps its digits for the place in the texture.
    // Mirrored textures repeat after two.
    const glm::vec2 turned = glm::vec2(p) - 2.0f * glm::floor(0.5f * glm::vec2(p));
    const bool clamps_s = use_.wrap_s == Wrap::clamp, clamps_t = use_.wrap_t == Wrap::clamp;
    const glm::vec2 place(clamps_s ? glm::clamp(p.x, -1.0f, 2.0f) : turned.x,
                          clamps_t ? glm::clamp(p.y, -1.0f, 2.0f) : turned.y);
    const glm::vec2 at = place * size;
    if (use_.nearest)
        return texel(static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)));
    const glm::vec2 low = glm::floor(at - 0.5f);
    const glm::vec2 f = at - 0.5f - low;
    const int x = static_cast<int>(low.x), y = static_cast<int>(low.y);
    const glm::vec4 above = glm::mix(texel(x, y), texel(x + 1, y), f.x);
    return glm::mix(above, glm::mix(texel(x, y + 1), texel(x + 1, y + 1), f.x), f.y);
}

}  // namespace burnish
