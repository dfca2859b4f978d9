// `burnish info` of models and scene files.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "burnish/scene.hpp"

namespace burnish {

// Several lines, each ended by a newline. Many meshes or materials that differ only in numbers
// share a line.
std::string describe_scene(const std::string& path, const Scene& scene);

// The same with the environment and the camera of the file. Throws as load_scene_file.
std::string describe_scene_file(const std::string& path);

}  // namespace burnish
