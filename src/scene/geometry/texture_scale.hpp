// How large the texture square is on a model.
#pragma once

#include <optional>

#include "burnish/scene.hpp"

namespace burnish {

// The side of the texture square (texture coordinates from 0 to 1, first set) on the surfaces of one
// material, in the scene's meters: of each triangle the root of area over area in texture
// coordinates, and over all triangles the quantiles of it, weighted by their areas.
struct TextureSquare {
    double side;       // median
    double low, high;  // quartiles: half of the area lies between them
};

// None where no triangle has both areas.
std::optional<TextureSquare> texture_square(const Scene& scene, int material);

}  // namespace burnish
