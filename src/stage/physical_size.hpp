// Physical sizes of scratch maps, maps, measured materials and weaves, on a model whose unit is the
// meter.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "burnish/layered_materials.hpp"
#include "burnish/material_assets.hpp"
#include "burnish/parameters.hpp"
#include "burnish/scene.hpp"

namespace burnish {

// Each line with the materials that it is true of.
using SizeLines = std::vector<std::pair<std::string, std::vector<std::string>>>;
struct SizeReport {
    SizeLines notes, warnings;
};

// Writes what the parameters physical_size, maps_tile_mm and weave_yarns_per_cm ask for as uv_scale
// and weave_yarns of the material, by the size of its texture square (texture_square). A uv_scale
// that is set holds. Appends what was found, and why a size could not be had, to `report`.
void apply_physical_size(ParameterValues& values, const Scene& scene, std::size_t material,
                         const MaterialAssets& assets, SizeReport& report);

// The lines, "brass and 98 others: ...", and after them the size of the model: a warning where it
// says that the unit may be another. Nothing without lines.
void append_sizes(const SizeReport& report, const Scene& scene, Remarks& remarks);

}  // namespace burnish
