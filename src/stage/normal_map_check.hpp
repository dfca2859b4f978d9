// Warnings for textures that are not normal maps.
#pragma once

#include "burnish/scene.hpp"

namespace burnish {

// Adds a warning for each normal map in use whose mean direction is far from +z, such as an
// object-space map, a height map or a photograph. Black texels (padding between charts) do not
// count.
void warn_of_odd_normal_maps(Scene& scene);

}  // namespace burnish
