#include <cmath>

#include "image/image_io.hpp"

namespace burnish {

float srgb_from_linear(float linear) {
    constexpr float kBreak = 0.0031308f;
    return linear <= kBreak ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

float linear_from_srgb(float srgb) {
    constexpr float kBreak = 0.04045f;
    return srgb <= kBreak ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f);
}

}  // namespace burnish
