// Parallel loops on oneTBB. Results must not depend on the number of threads.
#pragma once

#include <cstddef>
#include <functional>

namespace burnish {

// Calls body(begin, end) for the ranges [k grain, (k+1) grain) that cover [0, count), the last one
// possibly shorter. The ranges depend on `count` and `grain` alone, so that a sum kept per range
// (index begin / grain) and added up in order is the same on any number of threads. A grain of 0
// counts as 1. The first exception thrown by `body` reaches the caller; ranges not yet started are
// then left out.
void parallel_for(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body);

}  // namespace burnish
