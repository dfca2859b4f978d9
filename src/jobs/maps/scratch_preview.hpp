// A scratch map to look at. Private to the scratch command.
#pragma once

#include "maps/scratch/scratch.hpp"
#include "plot/sheet.hpp"

namespace burnish {

// Relief of the tile, of two by two tiles and of a part texel by texel; normals, heights and
// groove directions of that part.
Sheet scratch_preview(const ScratchMaps& maps);

}  // namespace burnish
