// What is common to all kinds of models.
#include "burnish/scene.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <glm/common.hpp>

#include "burnish/error.hpp"
#include "core/files.hpp"
#include "scene/load.hpp"

namespace burnish {
namespace {

constexpr std::string_view kBuiltin = "builtin:";

// Transforms the box's eight corners: a bound, not the tightest.
void include_box(const Bounds& box, const glm::mat4& transform, Bounds& bounds, bool& empty) {
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 local((corner & 1) ? box.high.x : box.low.x,
                              (corner & 2) ? box.high.y : box.low.y,
                              (corner & 4) ? box.high.z : box.low.z);
        const glm::vec3 world(transform * glm::vec4(local, 1.0f));
        bounds.low = empty ? world : glm::min(bounds.low, world);
        bounds.high = empty ? world : glm::max(bounds.high, world);
        empty = false;
    }
}

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
    material.roughness = 0.4f;  // a metal that shows its lobe; glTF's own default is fully rough
    material.double_sided = shape == "drape" || shape == "plane";  // sheets
    scene.instances.emplace_back();
    return scene;
}

}  // namespace

Method drawn_method(const Material& m) {
    const bool isotropic = !m.anisotropy_texture && !m.tabulated &&
                           (m.alpha ? m.alpha->x == m.alpha->y : m.anisotropy_strength == 0.0f);
    return m.method == Method::normal_map && isotropic ? Method::gram_schmidt : m.method;
}

Bounds bounds_of(const Scene& scene) {
    std::vector<Bounds> boxes;
    boxes.reserve(scene.meshes.size());
    for (const Mesh& mesh : scene.meshes) boxes.push_back(bounds_of(mesh));
    Bounds bounds;
    bool empty = true;
    for (const Instance& instance : scene.instances) {
        const auto mesh = static_cast<std::size_t>(instance.mesh);
        if (!scene.meshes[mesh].positions.empty())
            include_box(boxes[mesh], instance.transform, bounds, empty);
    }
    return bounds;
}

Scene load_model(const std::string& path_or_builtin, int triangles) {
    if (path_or_builtin.starts_with(kBuiltin)) return scene_of_builtin(path_or_builtin, triangles);
    const std::filesystem::path path(path_or_builtin);
    const std::string extension = lower_extension(path);
    if (extension == ".obj") return load_obj(path);
    if (extension == ".gltf" || extension == ".glb") return load_gltf(path);
    // Other names are told by content: a binary glTF starts with its name.
    if (std::filesystem::is_directory(path))
        throw Error(path_or_builtin, "", "a model or a scene", "a folder");
    std::ifstream file(path, std::ios::binary);
    if (!file) throw Error(path_or_builtin, "", "a readable file", reason_of(errno));
    char magic[4] = {};
    if (file.read(magic, 4) && std::string_view(magic, 4) == "glTF") return load_gltf(path);
    throw Error(path_or_builtin, "", "a model (.gltf, .glb, .obj, a scene .json or builtin:<name>)",
                extension.empty() ? "a name without extension" : shown(extension));
}

}  // namespace burnish
