// From linear radiance to what a display shows: exposure, a named tone map, the sRGB curve.
//
// Threads: any number may call these functions at a time. Lifetime: what they return refers to
// nothing else.
#pragma once

#include <span>
#include <string_view>

#include "burnish/api.hpp"
#include "burnish/image.hpp"

namespace BURNISH_API burnish {

enum class ToneMap {
    linear,          // clip at 1
    reinhard,        // c / (1 + c) on luminance
    aces,            // Narkowicz 2015 fit of the ACES filmic curve
    khronos_neutral  // Khronos PBR Neutral 1.0: keeps base colours, rolls highlights off to white
};

// Names in the order of the enumeration: the choices of the parameter `tone_map`.
std::span<const std::string_view> tone_map_names();

// RGB or RGBA linear Rec. 709 in, the same channels display-encoded in [0, 1] out; alpha is kept
// and colour is un-premultiplied already. `exposure_ev`: radiance times 2^EV before the tone map.
Image to_display(const Image& linear, double exposure_ev, ToneMap tone_map);

}  // namespace burnish
