// Single values of a texture, whatever its type.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>

#include "burnish/image.hpp"

namespace burnish {

// The value at `index`, channels counted in: integers over 0..1, floats as they are stored.
inline float texel_value(const Texture& texture, std::size_t index) {
    const auto stored = [&]<typename Stored>(Stored value) {
        std::memcpy(&value, texture.texels.data() + index * sizeof value, sizeof value);
        if constexpr (std::is_same_v<Stored, float>) return value;
        return static_cast<float>(value) / static_cast<float>(std::numeric_limits<Stored>::max());
    };
    switch (texture.type) {
        case TexelType::u8:
            return stored(std::uint8_t{});
        case TexelType::u16:
            return stored(std::uint16_t{});
        case TexelType::f32:
            return stored(float{});
    }
    return 0.0f;
}

// Stores a value that texel_value returns, up to rounding; integers take 0..1.
inline void set_texel_value(Texture& texture, std::size_t index, float value) {
    const auto store = [&]<typename Stored>(Stored stored) {
        if constexpr (std::is_same_v<Stored, float>)
            stored = value;
        else
            stored = static_cast<Stored>(
                std::lround(std::clamp(value, 0.0f, 1.0f) *
                            static_cast<float>(std::numeric_limits<Stored>::max())));
        std::memcpy(texture.texels.data() + index * sizeof stored, &stored, sizeof stored);
    };
    switch (texture.type) {
        case TexelType::u8:
            return store(std::uint8_t{});
        case TexelType::u16:
            return store(std::uint16_t{});
        case TexelType::f32:
            return store(float{});
    }
}

}  // namespace burnish
