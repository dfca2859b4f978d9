#include "image/display.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.hpp"
#include "image/image_io.hpp"

namespace burnish {

namespace {

using Rgb = std::array<float, 3>;

Rgb reinhard(Rgb c) {
    const float luminance = 0.2126f * c[0] + 0.7152f * c[1] + 0.0722f * c[2];
    const float scale = 1.0f / (1.0f + luminance);
    return {c[0] * scale, c[1] * scale, c[2] * scale};
}

// K. Narkowicz, "ACES Filmic Tone Mapping Curve", 2015.
float aces_channel(float c) {
    return (c * (2.51f * c + 0.03f)) / (c * (2.43f * c + 0.59f) + 0.14f);
}

// Khronos PBR Neutral Tone Mapper, specification 1.0 (2024): the offset undoes the 4 % Fresnel
// floor, values beyond the start of compression roll off and lose saturation.
Rgb khronos_neutral(Rgb c) {
    constexpr float kFresnel = 0.04f;
    constexpr float kStart = 0.8f - kFresnel;
    constexpr float kDesaturation = 0.15f;
    const float low = std::min({c[0], c[1], c[2]});
    const float offset = low < 2 * kFresnel ? low - low * low / (4 * kFresnel) : kFresnel;
    for (float& v : c) v -= offset;
    const float peak = std::max({c[0], c[1], c[2]});
    if (peak < kStart) return c;
    const float d = 1 - kStart;
    const float new_peak = 1 - d * d / (peak + d - kStart);
    const float g = 1 - 1 / (kDesaturation * (peak - new_peak) + 1);
    for (float& v : c) v = v * (new_peak / peak) * (1 - g) + new_peak * g;
    return c;
}

Rgb tone_mapped(Rgb c, ToneMap tone_map) {
    switch (tone_map) {
        case ToneMap::linear:
            return c;
        case ToneMap::reinhard:
            return reinhard(c);
        case ToneMap::aces:
            return {aces_channel(c[0]), aces_channel(c[1]), aces_channel(c[2])};
        case ToneMap::khronos_neutral:
            return khronos_neutral(c);
    }
    return c;
}

}  // namespace

std::span<const std::string_view> tone_map_names() {
    static constexpr std::array<std::string_view, 4> names = {"linear", "reinhard", "aces",
                                                              "khronos-neutral"};
    return names;
}

Image to_display(const Image& linear, double exposure_ev, ToneMap tone_map) {
    Image display = linear;
    const float gain = static_cast<float>(std::exp2(exposure_ev));
    const auto channels = static_cast<std::size_t>(linear.channels);
    const std::size_t count = linear.pixels.size() / channels;
    parallel_for(count, 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            float* pixel = display.pixels.data() + i * channels;
            const Rgb mapped =
                tone_mapped({pixel[0] * gain, pixel[1] * gain, pixel[2] * gain}, tone_map);
            for (std::size_t c = 0; c < 3; ++c)
                pixel[c] = srgb_from_linear(std::clamp(mapped[c], 0.0f, 1.0f));
        }
    });
    return display;
}

}  // namespace burnish
