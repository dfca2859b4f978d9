// Reading models, environments and scene files into Scene. Every reader throws burnish::Error with
// one line naming the file, the key, what was expected and what was found, for any broken, hostile
// or unsupported input; none crashes, hangs, or allocates by a count it has not checked.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/parameters.hpp"
#include "burnish/scene.hpp"

namespace burnish {

// glTF 2.0 (.gltf, .glb), OBJ (.obj, with its .mtl) by content and extension, or "builtin:sphere",
// "builtin:plane", "builtin:cylinder", "builtin:torus", "builtin:drape".
Scene load_model(const std::string& path_or_builtin, int triangles = 0);
Scene load_gltf(const std::filesystem::path& path);
Scene load_obj(const std::filesystem::path& path);
bool is_builtin(std::string_view name);
std::span<const std::string_view> builtin_names();

// `name` without the "builtin:" prefix; `triangles` is a wish (0: a good default).
Mesh make_builtin_mesh(std::string_view name, int triangles = 0);

// .hdr, .exr (or any allowed image) lat-long, or "builtin:studio" (soft boxes in a dark room; the
// default), "builtin:white" (constant 1, the furnace), "builtin:black".
Environment load_environment(const std::string& path_or_builtin);

// A scene file (JSON): schema in docs/scene-file.md.
struct SceneFile {
    Scene scene;
    ParameterValues values;   // the file's "parameters"
    std::string environment;  // "" when the file names none
};
SceneFile load_scene_file(const std::filesystem::path& path);
bool is_scene_file(const std::filesystem::path& path);  // JSON with "format": "burnish-scene"

// Puts the material parameters that are set in `values` onto every material of the scene.
void apply_material_parameters(Scene& scene, const ParameterValues& values);

// Throws UsageError when `values` says the roughness pair in two ways, named as keys or as flags.
void require_one_roughness(const ParameterValues& values, bool as_flags);

// Throws UsageError when `method` has nothing to act on: a deformation for a model without half
// vectors.
void require_drawable(Brdf brdf, Method method);

// Adds a warning for each normal map in use whose mean direction is far from +z: an object-space
// map, a height map, a photograph. Black texels (padding between charts) do not count.
void warn_of_odd_normal_maps(Scene& scene);

}  // namespace burnish
