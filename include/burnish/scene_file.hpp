// Scene files (JSON): docs/reference/scene-file.md is the schema in words. Throws Error with one
// line naming the file, the key, what was expected and what was found, for any broken, hostile or
// unsupported input; never crashes, hangs, or allocates by a count that it has not checked.
//
// Threads: any number may call these functions at a time. Lifetime: what they return refers to
// nothing else.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/parameters.hpp"
#include "burnish/scene.hpp"

namespace BURNISH_API burnish {

// What a scene file says: models are read, parameters are kept as values (stage/ applies them).
struct SceneFile {
    // What the file lays over one of the scene's materials.
    struct Layer {
        ParameterValues values;  // of "parameters" and, over them, of the object's set
        std::string place;       // "scene.json: objects[2]", for messages
    };

    Scene scene;                // its materials are those of the models
    std::vector<Layer> layers;  // one a material of the scene
    ParameterValues values;     // the file's "parameters" but for those of materials
    std::string environment;    // "" when the file names none
};

SceneFile load_scene_file(const std::filesystem::path& path);
bool is_scene_file(const std::filesystem::path& path);  // JSON with "format": "burnish-scene"

}  // namespace burnish
