// Tangents that follow the texture coordinates which a material reads its normals with.
//
// Threads: one at a time for each scene. Lifetime: what they return refers to nothing else.
#pragma once

#include <string>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/scene.hpp"

namespace BURNISH_API burnish {

// The coordinates in whose frame the material stores directions: those of its normal texture, with
// the texture's transform; without one, those of its anisotropy texture; else set 0 as it is.
TangentSource tangent_source_of(const Material& material);

// Makes anew the tangents of every mesh that has them not from its file (Mesh::tangent_source) and
// not from the coordinates that the materials of its instances ask for. A mesh that materials of
// different coordinates share is copied: the copy is appended, and instances are pointed to it.
// Sets Material::anisotropy_texture_turn of every material. Call it after a change of a material's
// textures or their transforms; applying twice is applying once. Returns warnings where the
// direction of an anisotropy texture is an approximation.
std::vector<std::string> fit_tangents(Scene& scene);

}  // namespace burnish
