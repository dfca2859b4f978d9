// What a tabulated material must be, whoever made it.
#pragma once

#include <string>

#include "burnish/tabulated_material.hpp"

namespace burnish {

// Throws Error naming `file`, the part and channel at fault: sizes, numbers that are not finite,
// negative distributions or colours, masses away from 1, indices out of range, normals that do not
// point out of the surface.
void check_tabulated_material(const std::string& file, const TabulatedMaterial& material);

}  // namespace burnish
