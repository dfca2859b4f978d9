// An environment with its maps for rendering, in the format of the device.
#pragma once

#include <cstdint>
#include <vector>

#include "burnish/prepared_environment.hpp"

namespace burnish {

// RGBA half floats in the order of OpenGL's cube maps (cube_map.hpp): face, row, column, channel;
// alpha is 1.
struct HalfCube {
    int size = 0;  // texels along an edge of a face
    std::vector<std::uint16_t> values;

    const std::uint16_t* face(int index) const {
        const auto edge = static_cast<std::size_t>(size);
        return values.data() + static_cast<std::size_t>(index) * edge * edge * 4;
    }
};

struct PreparedEnvironment {
    Environment environment;
    std::vector<HalfCube> radiance;  // cube_from_latlong and its mips, the last of size 1
    HalfCube irradiance;             // cube_irradiance
    std::vector<HalfCube> backdrop;  // as radiance, of Environment::backdrop; empty: radiance
    // Radiance and irradiance are the stored values times this: half floats end at 65504, a sun's
    // radiance may be larger.
    float scale = 1.0f;
};

}  // namespace burnish
