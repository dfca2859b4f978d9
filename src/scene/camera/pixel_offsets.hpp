// Where the samples of a pixel lie.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace burnish {

// The offsets of `count` >= 1 samples from the middle of their pixel, in pixels, in the order in which
// they are drawn. They are distributed as the pixel filter: a tent of half width 1 along each axis.
// Samples come in pairs of opposite offsets after a first one in the middle where `count` is odd. Their
// mean is therefore exactly 0, and so is that of the first n, if n is even or odd as `count` is. After
// one sample of a pair the mean is off by 1/n of that sample's offset.
std::vector<glm::dvec2> pixel_offsets(int count);

}  // namespace burnish
