#include "core/parallel.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>

namespace burnish {

void parallel_for(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body) {
    if (count == 0) return;
    grain = std::clamp<std::size_t>(grain, 1, count);
    const std::size_t ranges = (count - 1) / grain + 1;
    oneapi::tbb::parallel_for(std::size_t{0}, ranges, [&](std::size_t range) {
        const std::size_t begin = range * grain;
        body(begin, begin + std::min(grain, count - begin));
    });
}

}  // namespace burnish
