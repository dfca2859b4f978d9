// Converts a normal map to slopes, with mips of slopes: the mean slope and the variance of the
// slopes under each texel. A mean of unit normals would be too short and too smooth.
#pragma once

#include <span>
#include <vector>

#include "burnish/f32.hpp"
#include "burnish/image.hpp"

namespace burnish {

// Largest slope along an axis, 88.3 degrees; steeper texels are clamped.
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

// Levels 0 to 1x1, each side halved and rounded down. Every texel is the mean, by area, of the
// texels of level 0 under it. `map` holds normals, n = 2 rgb - 1; with two channels z follows from
// unit length. A texel that is not a direction out of the surface counts as flat.
std::vector<SlopeLevel> slope_mips(const Texture& map);

// The covariance of the slopes under each texel, for every level of slope_mips; 0 in level 0.
std::vector<std::vector<float>> slope_covariances(std::span<const SlopeLevel> levels);

}  // namespace burnish
