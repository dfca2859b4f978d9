// A preview picture of cloth maps. Private to the weave command.
#pragma once

#include "burnish/image.hpp"
#include "burnish/weave_maps.hpp"

namespace burnish {

// The cloth under a lamp: the tile, two by two tiles, a few yarns; normals, heights and fiber
// directions of these yarns. Throws no errors of its own.
Image weave_preview(const WeaveMaps& maps, const WeaveMapSettings& settings);

}  // namespace burnish
