// Tangent frames for meshes that come without, as MikkTSpace defines them, and repair of broken ones.
#pragma once

#include "burnish/mesh.hpp"

namespace burnish {

// Area-and-angle weighted smooth normals (flat where glTF demands flat) for meshes without normals.
void make_normals(Mesh& mesh, bool flat);

// Per-vertex tangents from texcoord0 the way MikkTSpace does it: per-corner, angle-weighted, grouped
// by shared vertex and orientation (mirrored UVs split vertices). Without UVs, or where they are
// degenerate, a frame derived from the normal alone, continuous where it can be.
void make_tangents(Mesh& mesh);

// Zero, NaN or non-unit normals and tangents, and tangents parallel to the normal, are replaced by
// sound ones; returns how many vertices were mended.
std::size_t repair_frames(Mesh& mesh);

}  // namespace burnish
