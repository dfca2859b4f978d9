// The halved levels of slope moments. Private to the scratch generator.
#pragma once

#include <vector>

#include "burnish/scratch_maps.hpp"

namespace burnish {

// Levels 1 (half the size, rounded down) to the last (1x1). Every texel is the mean of the part of
// the full map under it, by area, so that every level has the mean of the full map.
std::vector<MomentLevel> moment_levels(const ScratchMaps& maps);

}  // namespace burnish
