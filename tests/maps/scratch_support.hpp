// Settings for tests of scratch maps.
#pragma once

#include <cstdint>
#include <limits>

#include "burnish/scratch_maps.hpp"

namespace burnish {

inline constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

inline ScratchSettings one_layer(int size, double count, double length_mm, double width_mm,
                                 double depth_mm) {
    ScratchSettings settings;
    settings.size = size;
    ScratchLayer layer;
    layer.count = count;
    layer.length_mm = constant_spread(length_mm);
    layer.width_mm = constant_spread(width_mm);
    layer.depth_mm = constant_spread(depth_mm);
    settings.layers = {layer};
    return settings;
}

inline ScratchMaps made(const ScratchSettings& settings, const ScratchInputs& inputs = {}) {
    return engrave(settings, inputs, kNoLimit);
}

inline ScratchMaps preset_maps(std::string_view name, int size) {
    ScratchSettings settings = scratch_preset(name, "");
    settings.size = size;
    return made(settings);
}

}  // namespace burnish
