// The points of a stack that exemplars are made from.
#pragma once

#include <cstddef>
#include <vector>

#include "burnish/progress.hpp"
#include "capture/stack/image_stack.hpp"

namespace burnish {

struct TrainingPoints {
    std::vector<std::size_t> pixels;  // in increasing order
    std::vector<float> values;        // pixels x lights x 3, as the stack decodes them
};

// Pixels spread evenly over the stack's mask, and their values. `wanted`: at most so many; 0: 8192,
// and no more than have 4 million samples. The same for the same stack. Throws Error, Interrupted.
TrainingPoints training_points(const ImageStack& stack, int wanted, const Progress& progress);

}  // namespace burnish
