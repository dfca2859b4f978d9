// The layout of a stack's file, and its writer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "burnish/progress.hpp"
#include "capture/stack/image_stack.hpp"

namespace burnish {

// Samples are stored as 16-bit codes of the square root of their ratio to the light's largest
// sample. A step is at most 0.3 % of a sample that is a ten thousandth of the largest.
inline constexpr float kMostCode = 65534.0f;
inline constexpr std::uint16_t kClippedCode = 65535;

inline constexpr char kStackMagic[16] = "burnish-stack 2";

struct StackHeader {
    char magic[16];
    std::uint64_t identity;
    std::uint64_t width, height, lights, band_pixels;
    double clipped_share, black_share, brightest;
};
// After the header the file holds the mask (width x height bytes), the scales (lights floats), the
// clipping flags (lights bytes) and the samples, band by band.

inline std::uint64_t data_start(const StackHeader& h) {
    return sizeof(StackHeader) + h.width * h.height + h.lights * (sizeof(float) + 1);
}

// Writes the whole stack into the open file. `name` is for messages.
void write_stack(int file, const std::string& name, const StackSource& source,
                 std::uint64_t identity, std::size_t band_bytes, const Progress& progress);

}  // namespace burnish
