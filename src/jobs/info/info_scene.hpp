// `burnish info` of models and scene files.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "burnish/scene.hpp"

namespace burnish {

// Several lines, each ended by a newline. Meshes and materials that differ in numbers alone share a
// line when they are many.
std::string describe_scene(const std::string& path, const Scene& scene);

// The same with what the file says of environment and camera. Throws as load_scene_file.
std::string describe_scene_file(const std::string& path);

}  // namespace burnish
