// A model of any kind. Throws Error with one line naming the file, the key, what was expected and
// what was found, for any broken, hostile or unsupported input; never crashes, hangs, or allocates
// by a count that it has not checked.
//
// Threads: any number may call these functions at a time. Lifetime: what they return refers to
// nothing else.
#pragma once

#include <string>

#include "burnish/api.hpp"
#include "burnish/scene.hpp"

namespace BURNISH_API burnish {

// glTF 2.0 (.gltf, .glb) or OBJ (.obj), told by extension and content, or a built-in mesh
// ("builtin:sphere" ...), whose number of triangles is about `triangles` (0: a good default).
Scene load_model(const std::string& path_or_builtin, int triangles = 0);

}  // namespace burnish
