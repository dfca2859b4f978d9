// Normals and tangents for meshes that come without, as MikkTSpace defines them, and repair of
// broken ones. Indices are taken to be in range (the loaders check them).
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>

#include "burnish/mesh.hpp"

namespace burnish {

// Replaces the normals. Flat: every triangle gets its own three vertices and its face normal, which
// is what glTF asks for. Smooth: vertices at the same position share the mean of their face
// normals, weighted by area and angle.
void make_normals(Mesh& mesh, bool flat);

// The normal of the triangle that has `corner` (an index into mesh.indices), as long as twice its
// area times the angle there: what a smooth normal is the sum of. Zero for triangles without area.
glm::dvec3 corner_normal(const Mesh& mesh, std::size_t corner);

// Replaces the tangents by those of texcoord0, the way MikkTSpace makes them: corners with the same
// position, normal and texture coordinates are one; those joined by shared edges and of the same
// orientation form a group, whose tangent is the mean of the triangles' ones, projected on the
// plane of the normal and weighted by angle. A vertex whose corners fall into several groups
// (mirrored coordinates) is split, so the mesh may grow. v is taken to run downwards, as in glTF:
// the bitangent w cross(n, t) points up in the picture. Where there are no texture coordinates, or
// only degenerate ones, the tangent is tangent_of_normal().
void make_tangents(Mesh& mesh);

// A unit vector perpendicular to a unit normal: east on a globe with poles at +-y, where it jumps.
glm::vec3 tangent_of_normal(glm::vec3 normal);

// Makes normals and, where there are any, tangents unit length and finite, w = +-1. Lengths up to
// 5 % off, as quantised attributes have, are mended silently; zero, infinite and NaN ones, and
// tangents parallel to the normal, are replaced. Returns how many vertices had such. Missing
// normals are made (smooth).
std::size_t repair_frames(Mesh& mesh);

}  // namespace burnish
