// Triangle lists, strips and fans.
#pragma once

#include <cstdint>
#include <vector>

namespace burnish {

// Three indices a triangle, counter-clockwise as the primitive mode of glTF (4, 5 or 6) defines it.
// Left-over indices and triangles that use a vertex twice are dropped.
std::vector<std::uint32_t> triangle_list(std::vector<std::uint32_t> indices, int mode);

}  // namespace burnish
