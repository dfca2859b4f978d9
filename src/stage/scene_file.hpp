// Scene files (JSON): docs/reference/scene-file.md is the schema in words. Throws Error with one line naming the file, the key, what was expected and what was found, for
// any broken, hostile or unsupported input; never crashes, hangs, or allocates by a count that it
// has not checked.
#pragma once

#include <filesystem>
#include <string>

#include "burnish/parameters.hpp"
#include "burnish/scene.hpp"

namespace burnish {

struct SceneFile {
    Scene scene;
    ParameterValues values;   // the file's "parameters"
    std::string environment;  // "" when the file names none
};
SceneFile load_scene_file(const std::filesystem::path& path);
bool is_scene_file(const std::filesystem::path& path);  // JSON with "format": "burnish-scene"

}  // namespace burnish
