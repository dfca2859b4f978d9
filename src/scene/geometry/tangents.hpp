// Normals and tangents, as MikkTSpace defines them, for meshes without them, and repair of broken
// ones. Indices must be in range (the loaders check them).
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>

#include "burnish/mesh.hpp"

namespace burnish {

// Replaces the normals. Flat, as glTF requires: every triangle gets its own three vertices and its
// face normal. Smooth: vertices at the same position share the mean of their face normals, weighted
// by area and angle.
void make_normals(Mesh& mesh, bool flat);

// The normal of the triangle that has `corner` (an index into mesh.indices), with a length of twice
// its area times the angle at the corner. Smooth normals are sums of these. Zero for triangles
// without area.
glm::dvec3 corner_normal(const Mesh& mesh, std::size_t corner);

// Replaces the tangents by those of the coordinates that `source` names, as MikkTSpace defines them. Corners with the same
// position, normal and texture coordinates are one. Corners joined by shared edges and of the same
// orientation form a group. The tangent of a group is the mean of the triangles' tangents,
// projected on the plane of the normal and weighted by angle. A vertex whose corners fall into
// several groups (mirrored coordinates) is split, so the mesh may grow. v runs downwards, as in
// glTF: the bitangent w cross(n, t) points up in the picture. Without texture coordinates, or with
// degenerate ones only, the tangent is tangent_of_normal(). Keeps the source in the mesh.
void make_tangents(Mesh& mesh, const TangentSource& source = {});

// A unit vector perpendicular to a unit normal: east on a globe whose poles, at +-y, are
// discontinuities.
glm::vec3 tangent_of_normal(glm::vec3 normal);

// Makes normals and tangents, if any, finite and of unit length, w = +-1. Lengths up to 5 % off, as
// quantized attributes have, are corrected silently. Zero, infinite and NaN vectors, and tangents
// parallel to the normal, are replaced. Makes missing normals (smooth). Returns the number of
// vertices with a normal or tangent that was replaced or more than 5 % off.
std::size_t repair_frames(Mesh& mesh);

}  // namespace burnish
