// Maps of a surface as the textures that a Material has.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "burnish/image.hpp"
#include "burnish/material_assets.hpp"
#include "burnish/parameters.hpp"
#include "stage/map_set.hpp"

namespace burnish {

// The names of the parameters that name one map each, "base_color_map" and its like, by role.
std::string_view map_parameter(MapRole role);  // "": none of its own
bool names_maps(const ParameterValues& values);
// The same text for the same maps.
std::string map_names(const ParameterValues& values);

// Loads the maps that `values` name: the folder `maps`, and over it each map by its own parameter.
// `append` adds a texture to the scene and returns its index. Roughness, glossiness (1 - roughness)
// and metallic become one texture, opacity the alpha of the base color, a height the normals of its
// slopes, `height_scale` high. Throws UsageError for names that are no files, Error for files that
// cannot be read.
MapTextures load_map_textures(const ParameterValues& values,
                              const std::function<int(Texture)>& append);

}  // namespace burnish
