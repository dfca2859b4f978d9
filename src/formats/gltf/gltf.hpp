// glTF 2.0 (.gltf, .glb) into a Scene. Throws Error for any broken, hostile or unsupported input,
// with one line: file, key, expected, found. Never crashes, hangs, or allocates by an unchecked
// count.
#pragma once

#include <filesystem>

#include "burnish/scene.hpp"

namespace burnish {

Scene load_gltf(const std::filesystem::path& path);

}  // namespace burnish
