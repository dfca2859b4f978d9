// Wavefront OBJ with its .mtl into a Scene. Throws Error with one line naming the file, the key, what was expected and what was found, for
// any broken, hostile or unsupported input; never crashes, hangs, or allocates by a count that it
// has not checked.
#pragma once

#include <filesystem>

#include "burnish/scene.hpp"

namespace burnish {

Scene load_obj(const std::filesystem::path& path);

}  // namespace burnish
