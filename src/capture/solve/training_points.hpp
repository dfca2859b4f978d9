// Chooses the points of a stack that exemplars are made from.
#pragma once

#include <cstddef>
#include <vector>

#include "burnish/progress.hpp"
#include "capture/stack/image_stack.hpp"

namespace burnish {

struct TrainingPoints {
    std::vector<std::size_t> pixels;  // in increasing order
    std::vector<float> values;        // pixels x lights x 3, as decoded by the stack
};

// Chooses pixels spread evenly over the stack's mask and reads their values. `wanted`: upper bound
// of their number; 0: 8192 or as many as have 4 million samples, whichever is fewer. Deterministic
// for a stack. Throws Error, Interrupted.
TrainingPoints training_points(const ImageStack& stack, int wanted, const Progress& progress);

// At most `most` of the points, spread evenly over them. `lights`: those of the stack.
TrainingPoints some_of(const TrainingPoints& points, std::size_t most, std::size_t lights);

}  // namespace burnish
