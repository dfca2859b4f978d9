// Ambient occlusion of a height map by itself.
#pragma once

#include "burnish/image.hpp"
#include "burnish/progress.hpp"

namespace burnish {

// The share of the light of a uniform sky that reaches each texel, weighted by the cosine to the
// surface's mean normal: 1 on a plane. `height`: 1 channel of a tile that repeats, in the units of
// `texel_width` and `texel_height`, the sides of a texel. One channel of the same size.
//
// A horizon at angle a in some direction leaves cos^2 a of the light of that direction (N. Max,
// "Horizon mapping", 1988; the integral of cos t sin t from 0 to pi/2 - a is cos^2 a / 2). The horizon
// is looked for in 12 directions, at distances that grow by half up to 1/8 of the tile.
Image height_occlusion(const Image& height, double texel_width, double texel_height,
                       const Progress& progress = {});

}  // namespace burnish
