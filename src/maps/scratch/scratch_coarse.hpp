// Scratch maps of few texels, to be looked at while settings change.
//
// Threads: functions may be called from any thread. Lifetime: what they return refers to nothing else.
#pragma once

#include "burnish/scratch_maps.hpp"

namespace burnish {

// Texels a side of a coarse map that takes about 30 ms on two cores: 128 to 512, and no more than
// the settings ask for.
int coarse_scratch_size(const ScratchSettings& settings);

// The same scratches in the same places as engrave() draws them, on `size` texels a side. A groove that
// is narrower than the texels is leveled by them; therefore all heights are multiplied by one number,
// so that the mean squared slope is about that of maps of settings.size. It is found from small
// windows of the full maps, which are engraved for it. moments is left empty. Throws as engrave does.
ScratchMaps engrave_coarse(const ScratchSettings& settings, const ScratchInputs& inputs, int size);

}  // namespace burnish
