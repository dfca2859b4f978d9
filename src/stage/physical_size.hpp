// Physical sizes of scratch maps and weaves, on a model whose unit is the meter.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "burnish/material_assets.hpp"
#include "burnish/parameters.hpp"
#include "burnish/scene.hpp"

namespace burnish {

// A line for each finding, with the materials that it is true of.
using SizeNotes = std::vector<std::pair<std::string, std::vector<std::string>>>;

// Writes what the parameters physical_size and weave_yarns_per_cm ask for as uv_scale and weave_yarns
// of the material, by the size of its texture square (texture_square_side). A uv_scale that is set
// holds. Appends what was found, or why nothing could be, to `notes`.
void apply_physical_size(ParameterValues& values, const Scene& scene, std::size_t material,
                         const MaterialAssets& assets, SizeNotes& notes);

// "brass and 98 others: ..."
std::vector<std::string> lines_of(const SizeNotes& notes);

}  // namespace burnish
