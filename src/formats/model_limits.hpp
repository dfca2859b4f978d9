// Limits of what a model may ask for, and why.
#pragma once

#include <cstddef>

namespace burnish {

// Metres from the origin. Cross products of two edges and their squared length, which every normal
// needs, must stay below the largest float: (1e9)^4 = 1e36.
inline constexpr double kFarthest = 1e9;

// Texture coordinates beyond 2^24 have no fraction left in a float.
inline constexpr float kLargestTexcoord = 16777216.0f;

// Meshes drawn, each with its own transform: a gigabyte of instances.
inline constexpr std::size_t kMostInstances = std::size_t{1} << 22;

}  // namespace burnish
