// The built-in cloth: a square cloth hung over a round table, folded by a small cloth solver.
#pragma once

#include "burnish/mesh.hpp"

namespace burnish {

// About `triangles` triangles of one sheet, to be shown from both sides. Texture coordinates are
// the cloth at rest, tangents run along the warp. Same mesh every time, on every thread count.
Mesh make_drape(int triangles);

}  // namespace burnish
