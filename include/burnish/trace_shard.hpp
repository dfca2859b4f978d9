// A part of the samples of a trace, for several processes or machines.
#pragma once

#include "burnish/api.hpp"

namespace BURNISH_API burnish {

// Shard `index` of `count`, from 0: sample k of it is sample index + k count of every pixel.
struct TraceShard {
    int index = 0, count = 1;
};

}  // namespace burnish
