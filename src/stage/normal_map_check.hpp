// Warnings of normal maps that are none.
#pragma once

#include "burnish/scene.hpp"

namespace burnish {

// Adds a warning for each normal map in use whose mean direction is far from +z: an object-space
// map, a height map, a photograph. Black texels (padding between charts) do not count.
void warn_of_odd_normal_maps(Scene& scene);

}  // namespace burnish
