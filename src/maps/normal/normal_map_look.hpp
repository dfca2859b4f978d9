// Tells tangent-space normal maps from height maps and other pictures by their texels.
#pragma once

#include "burnish/image.hpp"

namespace burnish {

// True for a picture of three or four channels nearly all of whose texels are unit vectors
// (2 rgb - 1), with a mean near +z. Black texels (padding between charts) do not count. Looks at
// about a million texels at most. A height map is gray, which is no unit vector but for one shade; a
// photograph has texels of any length.
bool looks_like_normal_map(const Texture& texture);

}  // namespace burnish
