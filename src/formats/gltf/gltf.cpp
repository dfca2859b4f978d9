// glTF 2.0: container -> JSON -> buffers -> materials, meshes, nodes -> scene.
#include "formats/gltf/gltf.hpp"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <cmath>
#include <glm/matrix.hpp>

#include "burnish/error.hpp"
#include "formats/gltf/gltf_container.hpp"
#include "formats/gltf/gltf_document.hpp"
#include "formats/gltf/gltf_lights.hpp"
#include "formats/gltf/gltf_materials.hpp"
#include "formats/gltf/gltf_meshes.hpp"
#include "formats/gltf/gltf_nodes.hpp"
#include "formats/model_limits.hpp"

namespace burnish {
namespace {

// False for a singular transform, which leaves normals without a direction.
bool keeps_volume(const glm::mat4& world) {
    const glm::dmat3 linear(world);
    double largest = 0.0;
    for (int c = 0; c < 3; ++c) largest = std::max(largest, glm::length(linear[c]));
    // Below this ratio the inverse, which normals need, exceeds the precision of floats.
    return std::abs(glm::determinant(linear)) > 1e-12 * largest * largest * largest;
}

void place_meshes(const tinygltf::Model& model, const std::vector<GltfPlacement>& placements,
                  GltfMeshes& meshes, GltfReport& report, Scene& scene) {
    for (const GltfPlacement& placement : placements) {
        const int mesh = model.nodes[static_cast<std::size_t>(placement.node)].mesh;
        if (mesh < 0) continue;
        const std::string key = fmt::format("nodes[{}]", placement.node);
        if (!keeps_volume(placement.world)) {
            report.warn(key + ": its transform flattens the mesh: it is not drawn");
            continue;
        }
        for (const GltfPart& part : meshes.parts(mesh, key + ".mesh")) {
            if (scene.instances.size() == kMostInstances)
                report.fail(key, fmt::format("at most {} meshes drawn", kMostInstances), "more");
            scene.instances.push_back({part.mesh, part.material, placement.world});
        }
    }
}

}  // namespace

Scene load_gltf(const std::filesystem::path& path) {
    GltfReport report(path.string());
    const GltfContainer container = open_gltf_container(path, report);
    const GltfDocument document = parse_gltf_document(container.json, report);
    const tinygltf::Model& model = *document.model;
    GltfBuffers buffers(container, document, report);
    GltfImages images(container, document, buffers, report);
    GltfAccessors accessors(model, buffers, report);

    Scene scene;
    scene.name = path.stem().string();
    scene.materials = read_gltf_materials(model, images, report);
    GltfMeshes meshes(model, accessors, report, scene);
    const std::vector<GltfPlacement> placements = walk_gltf_nodes(model, report);
    place_meshes(model, placements, meshes, report, scene);
    meshes.finish();
    scene.textures = images.decode();
    add_gltf_lights(model, placements, report, scene);
    add_gltf_cameras(model, placements, report, scene);
    if (scene.instances.empty()) report.warn("nothing to draw: the scene has no triangles");
    scene.warnings = report.take_warnings();
    return scene;
}

}  // namespace burnish
