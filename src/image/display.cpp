#include "burnish/display.hpp"

#include <array>
#include <cmath>

#include "burnish/f32.hpp"
#include "core/parallel.hpp"

namespace burnish {

static_assert(static_cast<int>(ToneMap::linear) == f32::kToneMapLinear &&
              static_cast<int>(ToneMap::reinhard) == f32::kToneMapReinhard &&
              static_cast<int>(ToneMap::aces) == f32::kToneMapAces &&
              static_cast<int>(ToneMap::khronos_neutral) == f32::kToneMapKhronosNeutral);

std::span<const std::string_view> tone_map_names() {
    static constexpr std::array<std::string_view, 4> kNames = {"linear", "reinhard", "aces",
                                                               "khronos-neutral"};
    return kNames;
}

Image to_display(const Image& linear, double exposure_ev, ToneMap tone_map) {
    Image display = linear;
    const float gain = static_cast<float>(std::exp2(exposure_ev));
    const auto channels = static_cast<std::size_t>(linear.channels);
    const std::size_t count = linear.pixels.size() / channels;
    parallel_for(count, 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            float* pixel = display.pixels.data() + i * channels;
            const f32::vec3 shown =
                f32::display_color(static_cast<int>(tone_map),
                                   f32::vec3(pixel[0] * gain, pixel[1] * gain, pixel[2] * gain));
            pixel[0] = shown.x;
            pixel[1] = shown.y;
            pixel[2] = shown.z;
        }
    });
    return display;
}

}  // namespace burnish
