// Scene files (JSON): docs/reference/scene-file.md is the schema in words. Throws Error with one
// line naming the file, the key, what was expected and what was found, for any broken, hostile or
// unsupported input; never crashes, hangs, or allocates by a count that it has not checked.
//
// Threads: any number may call these functions at a time. Lifetime: what they return refers to
// nothing else.
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
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
        bool renamed = false;    // the file, not the model, gave the material its name
    };

    // A model in its place: what it is called in the file, and what of the scene is its own.
    struct Object {
        std::string model;  // builtin:<name>, or a path from the current folder
        glm::vec3 translate{0.0f}, rotate_deg{0.0f}, scale{1.0f};
        int first_material = 0, materials = 0;  // objects of one model and set share them
        int first_instance = 0, instances = 0;
    };

    Scene scene;                // its materials are those of the models; nothing is hidden
    std::vector<Layer> layers;  // one a material of the scene
    ParameterValues values;     // the file's "parameters" but for those of materials
    std::string environment;    // "" when the file names none
    std::vector<Object> objects;
    std::vector<int> hidden;    // instances of the scene that are not drawn, ascending
    int model_lights = 0;       // lights of the models, the first ones of the scene
    bool drops_lights = false;  // "model_lights": false
    std::string viewer;  // the member "viewer" as JSON, "" for none: a renderer passes over it
};

// `over`: values of a layer above; of them triangles counts, as it changes the built-in meshes.
SceneFile load_scene_file(const std::filesystem::path& path, const ParameterValues& over = {});
bool is_scene_file(const std::filesystem::path& path);  // JSON with "format": "burnish-scene"

// A model as a scene file would hold it: one object, without values. Throws as load_model.
SceneFile scene_file_of_model(const std::string& path_or_builtin, int triangles = 0);

}  // namespace burnish
