// What was taken for what from a folder of maps.
#pragma once

#include <string>
#include <vector>

#include "burnish/material_assets.hpp"
#include "burnish/parameters.hpp"

namespace burnish {

// For a flip_green beside a folder whose normal map is DirectX's by its name; empty: it has an effect,
// or is not set.
std::string warning_of_idle_flip(const ParameterValues& values, const MapTextures& maps);

// A line for the maps of the folder that `values` name, and one for each map that was passed over.
// Maps that a parameter beside the folder takes the place of are named with it. `maps`: those of
// `values`. Empty without a folder.
std::vector<std::string> map_notes(const ParameterValues& values, const MapTextures& maps);

}  // namespace burnish
