// The built-in cloth: a square cloth hung over a round table, folded by a small cloth solver.
#pragma once

#include "burnish/mesh.hpp"

namespace burnish {

// A sheet of about `triangles` triangles, visible from both sides. Texture coordinates are the
// cloth at rest, a meter square; tangents run along the warp. The sheet does not go through itself:
// layers of it keep a distance of about 1 cm. The mesh is the same for every call and number of
// threads.
Mesh make_drape(int triangles);

}  // namespace burnish
