// The halved levels of slope moments. Private to the scratch generator.
#pragma once

#include <vector>

#include "burnish/scratch_maps.hpp"

namespace burnish {

// Levels 1 (half the size, rounded down) to the last (1x1). Every texel is the area-weighted mean
// of the part of the full map under it, so that all levels have the same mean.
std::vector<MomentLevel> moment_levels(const ScratchMaps& maps);

}  // namespace burnish
