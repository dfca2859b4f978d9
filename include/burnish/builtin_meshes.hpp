// Meshes and names that need no file: "builtin:sphere", "plane", "cylinder", "torus", "drape".
//
// Threads: any number may call these functions at a time. Lifetime: what they return refers to
// nothing else.
#pragma once

#include <span>
#include <string_view>

#include "burnish/api.hpp"
#include "burnish/mesh.hpp"

namespace BURNISH_API burnish {

bool is_builtin(std::string_view name);  // begins with "builtin:"
std::span<const std::string_view> builtin_names();

// `name` without the "builtin:" prefix; `triangles` is a wish (0: a good default).
Mesh make_builtin_mesh(std::string_view name, int triangles = 0);

}  // namespace burnish
