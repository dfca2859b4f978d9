// A normal map as slopes, and the mips of slopes: what each texel of a level stands for is their
// mean and their variance, not the mean of unit normals, which is too short and too smooth.
#pragma once

#include <vector>

#include "burnish/f32.hpp"
#include "burnish/image.hpp"

namespace burnish {

// Steeper texels are held to this slope along an axis: 88.3 degrees.
inline constexpr float kSteepestSlope = 1.0f / f32::kLeastNormalZ;

// n.x/n.z and n.y/n.z of the normal: minus the slopes of the height.
struct SlopeTexel {
    float x = 0.0f;
    float y = 0.0f;
    float variance_x = 0.0f;  // 0 in level 0
    float variance_y = 0.0f;
};

struct SlopeLevel {
    int width = 0;
    int height = 0;
    std::vector<SlopeTexel> texels;  // row 0 at the top
};

// Levels 0 to 1x1, each side halved and rounded down; every texel stands for the texels of level 0
// under it, by area. `map` holds normals, n = 2 rgb - 1; of two channels z is what is left of 1. A
// texel that is no direction out of the surface counts as flat.
std::vector<SlopeLevel> slope_mips(const Texture& map);

}  // namespace burnish
