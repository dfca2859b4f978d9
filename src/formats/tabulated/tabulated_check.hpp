// Validity of a tabulated material from any source.
#pragma once

#include <string>

#include "burnish/tabulated_material.hpp"

namespace burnish {

// Throws Error naming `file`, part and channel for: wrong sizes, numbers that are not finite,
// negative distributions or colors, masses other than 1, indices out of range, normals that do not
// point out of the surface.
void check_tabulated_material(const std::string& file, const TabulatedMaterial& material);

}  // namespace burnish
