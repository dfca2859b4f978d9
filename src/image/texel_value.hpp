// Stored numbers of a Texture as floats.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "burnish/image.hpp"

namespace burnish {

// The number at `index`, counted in channels: codes of u8 and u16 as 0..1, f32 as it is. The color
// space is not looked at.
inline float stored_value(const Texture& texture, std::size_t index) {
    const auto code_at = [&](auto code) {
        std::memcpy(&code, texture.texels.data() + index * sizeof code, sizeof code);
        return code;
    };
    const auto fraction = [](auto code) {
        return static_cast<float>(code) /
               static_cast<float>(std::numeric_limits<decltype(code)>::max());
    };
    switch (texture.type) {
        case TexelType::u8:
            return fraction(code_at(std::uint8_t{}));
        case TexelType::u16:
            return fraction(code_at(std::uint16_t{}));
        case TexelType::f32:
            return code_at(0.0f);
    }
    return 0.0f;
}

}  // namespace burnish
