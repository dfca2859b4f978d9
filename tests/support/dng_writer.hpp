// Small DNG files as a camera writes them: uncompressed samples of 16 bits behind a mosaic of color
// filters, with or without a preview.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "burnish/image.hpp"

namespace burnish::test {

struct DngSettings {
    std::uint16_t black = 256, white = 16383;  // sensor values of no light and of full
    // Color of the four filters of a 2 x 2 block, row by row: 0 red, 1 green, 2 blue.
    std::array<std::uint8_t, 4> filters = {0, 1, 1, 2};
    // A preview in the first directory, the sensor data in a directory of its own: as cameras do.
    bool has_preview = true;
    bool says_dng = true;           // has the tag DNGVersion
    std::uint16_t orientation = 1;  // as of Exif
    // Camera color of white under the light of the picture; the camera's white balance.
    std::array<double, 3> as_shot_neutral = {0.5, 1.0, 0.625};
    std::string model = "Model One";
};

// What the sensor counts where `picture` (linear camera RGB, 1 is full) falls on it: at each pixel
// the channel of its filter, black + value (white - black), clipped and rounded.
std::vector<std::uint16_t> sensor_samples(const Image& picture, const DngSettings& settings = {});

// The file of width x height samples, row 0 at the top. Sides are even.
std::vector<std::byte> dng_of(int width, int height, const std::vector<std::uint16_t>& samples,
                              const DngSettings& settings = {});

// Both at once.
std::vector<std::byte> dng_of(const Image& picture, const DngSettings& settings = {});

}  // namespace burnish::test
