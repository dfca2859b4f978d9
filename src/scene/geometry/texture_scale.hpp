// How large the texture square is on a model.
#pragma once

#include <optional>

#include "burnish/scene.hpp"

namespace burnish {

// The side of the texture square (texture coordinates from 0 to 1, first set) on the surfaces of one
// material, in the scene's meters: the median over their triangles, weighted by their areas, of the
// root of area over area in texture coordinates. None where no triangle has both areas.
std::optional<double> texture_square_side(const Scene& scene, int material);

}  // namespace burnish
