#include "burnish/load_model.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "burnish/builtin_meshes.hpp"
#include "burnish/error.hpp"
#include "core/files.hpp"
#include "formats/gltf/gltf.hpp"
#include "formats/obj/obj.hpp"

namespace burnish {
namespace {

constexpr std::string_view kBuiltin = "builtin:";

std::string lower_extension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

Scene scene_of_builtin(const std::string& name, int triangles) {
    Scene scene;
    scene.name = name;
    const std::string_view shape = std::string_view(name).substr(kBuiltin.size());
    scene.meshes.push_back(make_builtin_mesh(shape, triangles));
    Material& material = scene.materials.emplace_back();
    material.name = "default";
    material.base_color = {0.8f, 0.8f, 0.8f, 1.0f};
    material.lobe = GltfLobe{0.4f};  // a metal with a visible lobe; glTF's default is fully rough
    material.double_sided = shape == "drape" || shape == "plane";  // sheets
    scene.instances.emplace_back();
    return scene;
}

// A folder in the place of a model, with the model in it or the flag that takes it.
std::string found_folder(const std::filesystem::path& folder) {
    std::error_code error;
    if (std::filesystem::exists(folder / "material.gltf", error))
        return "a folder (with a model in it: material.gltf)";
    return "a folder (a folder of maps is drawn by builtin:sphere --maps FOLDER)";
}

}  // namespace

Scene load_model(const std::string& path_or_builtin, int triangles) {
    if (path_or_builtin.starts_with(kBuiltin)) return scene_of_builtin(path_or_builtin, triangles);
    const std::filesystem::path path(path_or_builtin);
    const std::string extension = lower_extension(path);
    if (extension == ".obj") return load_obj(path);
    if (extension == ".gltf" || extension == ".glb") return load_gltf(path);
    // Other names are recognized by content: a binary glTF starts with "glTF".
    if (std::filesystem::is_directory(path))
        throw Error(path_or_builtin, "", "a model or a scene", found_folder(path));
    std::ifstream file(path, std::ios::binary);
    if (!file) throw Error(path_or_builtin, "", "a readable file", reason_of(errno));
    char magic[4] = {};
    if (file.read(magic, 4) && std::string_view(magic, 4) == "glTF") return load_gltf(path);
    throw Error(path_or_builtin, "", "a model (.gltf, .glb, .obj, a scene .json or builtin:<name>)",
                extension.empty() ? "a name without extension" : shown(extension));
}

}  // namespace burnish
