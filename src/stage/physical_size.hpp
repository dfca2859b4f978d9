// Physical sizes of scratch maps and weaves, on a model whose unit is the meter.
#pragma once

#include <string>
#include <vector>

#include "burnish/material_assets.hpp"
#include "burnish/parameters.hpp"
#include "burnish/scene.hpp"

namespace burnish {

// Writes what the parameters physical_size and weave_yarns_per_cm ask for as uv_scale and weave_yarns
// of the material, by the size of its texture square (texture_square_side). A uv_scale that is set
// holds. Appends what was found, or why nothing could be, to `notes`.
void apply_physical_size(ParameterValues& values, const Scene& scene, std::size_t material,
                         const MaterialAssets& assets, std::vector<std::string>& notes);

}  // namespace burnish
