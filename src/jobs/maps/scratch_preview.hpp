// A preview picture of scratch maps. Private to the scratch command.
#pragma once

#include "burnish/image.hpp"
#include "burnish/scratch_maps.hpp"

namespace burnish {

// Relief of the tile, of two by two tiles and of a part texel by texel; normals, heights and
// groove directions of that part.
Image scratch_preview(const ScratchMaps& maps);

}  // namespace burnish
