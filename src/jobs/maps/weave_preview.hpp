// Maps of cloth to look at. Private to the weave command.
#pragma once

#include "burnish/image.hpp"
#include "burnish/weave_maps.hpp"

namespace burnish {

// The cloth under a lamp: the tile, two by two tiles, a few yarns; normals, heights and fibre
// directions of these. Throws nothing of its own.
Image weave_preview(const WeaveMaps& maps, const WeaveMapSettings& settings);

}  // namespace burnish
