// Which way the green channel of a normal map points, told by the map itself.
#pragma once

#include "burnish/image.hpp"

namespace burnish {

// The normals of a height have slopes whose cross derivatives agree: d(slope_x)/dy = d(slope_y)/dx, y
// up. Returns the correlation of the two over the texels, from -1 to 1: near 1 where green points up
// (OpenGL), near -1 where it points down (DirectX), near 0 where the map is flat, noise, or no map of a
// height. `map`: three or four channels; others give 0. Looks at about a million texels at most.
double slope_symmetry(const Texture& map);

}  // namespace burnish
