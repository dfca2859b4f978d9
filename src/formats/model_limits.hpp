// Limits on the contents of models, with reasons.
#pragma once

#include <cstddef>

namespace burnish {

// Largest distance from the origin, in meters. Normals need the cross product of two edges and its
// squared length, which must stay below the largest float: (1e9)^4 = 1e36.
inline constexpr double kFarthest = 1e9;

// Texture coordinates beyond 2^24 have no fractional bits in a float.
inline constexpr float kLargestTexcoord = 16777216.0f;

// Mesh instances, each with its own transform: about a gigabyte.
inline constexpr std::size_t kMostInstances = std::size_t{1} << 22;

}  // namespace burnish
