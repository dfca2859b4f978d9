// Scratch maps as textures: the parameter `scratch`.
#pragma once

#include <string>

#include "burnish/material_assets.hpp"
#include "burnish/scratch_maps.hpp"

namespace burnish {

// Side in texels of the maps of a preset for rendering.
inline constexpr int kScratchPresetSize = 2048;

// Maps as they are read from a folder of them. `ground`: the first layer of their settings.
ScratchTextures scratch_textures(const ScratchMaps& maps, const ScratchLayer& ground);

// The maps of a preset, engraved by this call, or of a folder made by `burnish scratch`. A preset
// has both textures; the second one of a folder is read when `with_anisotropy`. Throws UsageError
// for a name that is neither a preset nor a folder, Error for a folder whose maps cannot be read.
ScratchTextures load_scratch(const std::string& name, bool with_anisotropy);

// The side of the tile of a preset or a folder, in mm; 0 where nothing states it.
double scratch_tile_mm(const std::string& name);

}  // namespace burnish
