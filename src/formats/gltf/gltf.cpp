// glTF 2.0: container -> JSON -> buffers -> materials, meshes, nodes -> scene.
#include "formats/gltf/gltf.hpp"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <optional>

#include "burnish/error.hpp"
#include "formats/far_model.hpp"
#include "formats/gltf/gltf_container.hpp"
#include "formats/gltf/gltf_document.hpp"
#include "formats/gltf/gltf_extras.hpp"
#include "formats/gltf/gltf_instancing.hpp"
#include "formats/gltf/gltf_lights.hpp"
#include "formats/gltf/gltf_materials.hpp"
#include "formats/gltf/gltf_meshes.hpp"
#include "formats/gltf/gltf_nodes.hpp"
#include "formats/model_limits.hpp"
#include "formats/model_textures.hpp"

namespace burnish {
namespace {

// False for a singular transform, which leaves normals without a direction.
bool keeps_volume(const glm::dmat4& world) {
    const glm::dmat3 linear(world);
    double largest = 0.0;
    for (int c = 0; c < 3; ++c) largest = std::max(largest, glm::length(linear[c]));
    // Below this ratio the inverse, which normals need, exceeds the precision of floats.
    return std::abs(glm::determinant(linear)) > 1e-12 * largest * largest * largest;
}

// The transforms to world space of what the node draws: one, or one an instance.
std::vector<glm::dmat4> placed_copies(const tinygltf::Node& node, const glm::dmat4& world,
                                      const std::string& key, GltfAccessors& accessors,
                                      GltfReport& report) {
    const auto instances = read_gltf_instances(node, key, accessors, report);
    if (!instances) return {world};
    std::vector<glm::dmat4> copies;
    std::size_t flat = 0;
    for (const glm::dmat4& local : *instances) {
        const glm::dmat4 placed = world * local;
        if (!in_reach(placed))
            report.fail(key + ".extensions.EXT_mesh_gpu_instancing",
                        fmt::format("transforms with numbers up to {:g}", kFarthest),
                        "larger ones");
        if (keeps_volume(placed))
            copies.push_back(placed);
        else
            ++flat;
    }
    if (flat > 0)
        report.warn(fmt::format("{}: {} instances have no volume: they are not drawn", key, flat));
    return copies;
}

// Bounds of what is placed, in double precision.
struct PlacedBounds {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};

    void include(const Bounds& box, const glm::dmat4& world) {
        for (int corner = 0; corner < 8; ++corner) {
            const glm::dvec3 local((corner & 1) ? box.high.x : box.low.x,
                                   (corner & 2) ? box.high.y : box.low.y,
                                   (corner & 4) ? box.high.z : box.low.z);
            const glm::dvec3 p(world * glm::dvec4(local, 1.0));
            low = glm::min(low, p);
            high = glm::max(high, p);
        }
    }
};

// Adds an instance for each mesh that is drawn.
PlacedBounds place_meshes(const tinygltf::Model& model,
                          const std::vector<GltfPlacement>& placements, GltfAccessors& accessors,
                          GltfMeshes& meshes, GltfReport& report, Scene& scene) {
    PlacedBounds bounds;
    for (const GltfPlacement& placement : placements) {
        const int mesh = model.nodes[static_cast<std::size_t>(placement.node)].mesh;
        if (mesh < 0) continue;
        const std::string key = fmt::format("nodes[{}]", placement.node);
        if (!keeps_volume(placement.world)) {
            report.warn(key + ": its transform flattens the mesh: it is not drawn");
            continue;
        }
        const auto copies = placed_copies(model.nodes[static_cast<std::size_t>(placement.node)],
                                          placement.world, key, accessors, report);
        for (const GltfPart& part : meshes.parts(mesh, key + ".mesh")) {
            if (copies.size() > kMostInstances - scene.instances.size())
                report.fail(key, fmt::format("at most {} meshes drawn", kMostInstances), "more");
            const Bounds box = bounds_of(scene.meshes[static_cast<std::size_t>(part.mesh)]);
            for (const glm::dmat4& world : copies) {
                scene.instances.push_back({part.mesh, part.material, glm::mat4(world)});
                bounds.include(box, world);
            }
        }
    }
    return bounds;
}

// Moves everything that the nodes place by `offset`, in double precision.
void move_placements(const glm::dvec3& offset, std::vector<GltfPlacement>& placements) {
    for (GltfPlacement& placement : placements) placement.world[3] += glm::dvec4(offset, 0.0);
}

// Places the meshes. The nodes of a model far from the origin are moved to it, with lights and
// cameras, before their transforms become floats.
void place_nodes(const tinygltf::Model& model, std::vector<GltfPlacement>& placements,
                 GltfAccessors& accessors, GltfMeshes& meshes, GltfReport& report, Scene& scene) {
    const PlacedBounds bounds = place_meshes(model, placements, accessors, meshes, report, scene);
    const std::optional<glm::dvec3> center = center_of_far_model(bounds.low, bounds.high);
    if (!center) return;
    scene.instances.clear();
    move_placements(-*center, placements);
    place_meshes(model, placements, accessors, meshes, report, scene);
    report.warn(far_model_warning(*center, "the positions of its nodes, lights and cameras"));
}

}  // namespace

Scene load_gltf(const std::filesystem::path& path) {
    GltfReport report(path.string());
    const GltfContainer container = open_gltf_container(path, report);
    const GltfDocument document = parse_gltf_document(container.json, report);
    const tinygltf::Model& model = *document.model;
    ModelFiles files(container.folder);
    GltfBuffers buffers(container, document, files, report);
    GltfImages images(container, document, buffers, files, report);
    GltfAccessors accessors(model, buffers, report);

    Scene scene;
    scene.name = path.stem().string();
    GltfMaterials materials = read_gltf_materials(model, images, report);
    scene.materials = std::move(materials.materials);
    GltfMeshes meshes(document, buffers, accessors, std::move(materials.sets), report, scene);
    std::vector<GltfPlacement> placements = walk_gltf_nodes(model, report);
    place_nodes(model, placements, accessors, meshes, report, scene);
    GltfPictures pictures = images.decode();
    scene.textures = std::move(pictures.textures);
    for (std::string& line : leave_out_textures(scene, pictures.failures))
        report.warn(std::move(line));
    for (std::string& line : complete_normal_maps(scene)) report.warn(std::move(line));
    for (std::string& line : gray_packed_warnings(scene)) report.warn(std::move(line));
    for (const auto& [index, json] : document.extras)
        if (index < scene.materials.size())
            apply_gltf_extras(json, path.parent_path(),
                              fmt::format("materials[{}].extras.burnish", index), report,
                              scene.materials[index]);
    meshes.finish();
    add_gltf_lights(model, placements, report, scene);
    add_gltf_cameras(model, placements, report, scene);
    if (scene.instances.empty()) report.warn("nothing to draw: the scene has no triangles");
    scene.warnings = report.take_warnings();
    return scene;
}

}  // namespace burnish
