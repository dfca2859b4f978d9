// Normal maps from a height map, and of round bumps, the "illusory bumps" of K11 Fig 9.
//
// Maps are tangent-space RGB, n = 2 rgb - 1, x to the right, y up the picture (glTF, OpenGL), and
// tile without a seam. Heights are in texels, one channel.
#pragma once

#include <cstdint>

#include "burnish/image.hpp"

namespace burnish {

struct BumpOptions {
    int count = 64;              // 1..4096 bumps on the tile, rounded to a square number
    double max_tilt_deg = 35.0;  // 0..80, steepest slope of every bump
    double irregularity = 0.35;  // 0..1: 0 a regular grid, 1 scattered
    double dimples = 0.0;        // 0..1, fraction of bumps that point inwards
    std::uint32_t seed = 1;
};

// A tile of size x size texels (2..16384). The normals come from the closed form of the height, not
// from differences. Throws UsageError for options out of range.
Image bump_normal_map(int size, const BumpOptions& options = {});
Image bump_height_map(int size, const BumpOptions& options = {});

// Normals of a height map that tiles, by central differences of `scale` times the height, in
// texels. Throws Error when the image is empty or does not have one channel.
Image normal_map_from_height(const Image& height, double scale);

}  // namespace burnish
