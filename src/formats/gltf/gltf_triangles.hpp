// Triangle lists, strips and fans.
#pragma once

#include <cstdint>
#include <vector>

namespace burnish {

// Three indices per triangle, counter-clockwise as the primitive mode of glTF (4, 5 or 6) defines
// it. Surplus indices and triangles that use a vertex twice are dropped.
std::vector<std::uint32_t> triangle_list(std::vector<std::uint32_t> indices, int mode);

}  // namespace burnish
