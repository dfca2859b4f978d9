#include "rays/sample_mesh.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "scene/geometry/normal_transform.hpp"
#include "scene/geometry/weld.hpp"

namespace burnish {
namespace {

bool is_finite(const glm::vec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

glm::vec3 unit_or_zero(const glm::vec3& v) {
    const float length = glm::length(v);
    return length > 0.0f && std::isfinite(length) ? v / length : glm::vec3(0.0f);
}

bool is_sound(const Mesh& mesh) {
    const std::size_t n = mesh.positions.size();
    const auto fits = [n](const auto& values) { return values.empty() || values.size() == n; };
    return n > 0 && !mesh.indices.empty() && fits(mesh.normals) && fits(mesh.tangents) &&
           fits(mesh.texcoord0) && fits(mesh.texcoord1) && fits(mesh.colors);
}

// Whether the index is one of a list.
template <typename List>
bool is_of(int index, const List& list) {
    return index >= 0 && static_cast<std::size_t>(index) < list.size();
}

WorldMesh world_mesh(const Mesh& mesh, const Instance& instance, const Material& material) {
    WorldMesh out;
    out.material = instance.material;
    out.double_sided = material.double_sided;
    out.blocks = material.alpha_mode != AlphaMode::blend;
    const glm::mat4& m = instance.transform;
    const glm::mat3 linear(m);
    const glm::mat3 of_normals = normal_transform(linear);
    out.mirrored = is_mirrored(linear);
    for (const glm::vec3& p : mesh.positions) {
        const glm::vec3 world(m * glm::vec4(p, 1.0f));
        out.positions.push_back(is_finite(world) ? world : glm::vec3(0.0f));
    }
    for (const glm::vec3& n : mesh.normals) out.normals.push_back(unit_or_zero(of_normals * n));
    out.normals.resize(out.positions.size(), glm::vec3(0.0f));
    for (std::size_t c = 0; c + 2 < mesh.indices.size(); c += 3) {
        bool sound = true;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t index = mesh.indices[c + k];
            sound = sound && index < mesh.positions.size() &&
                    is_finite(glm::vec3(m * glm::vec4(mesh.positions[index], 1.0f)));
        }
        // A triangle that is left out still has its place, so that triangles keep their numbers.
        for (std::size_t k = 0; k < 3; ++k)
            out.indices.push_back(sound ? mesh.indices[c + (out.mirrored && k > 0 ? 3 - k : k)]
                                        : 0);
    }
    return out;
}

}  // namespace

std::vector<WorldMesh> world_meshes(const Scene& scene) {
    std::vector<WorldMesh> meshes;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        if (!is_of(instance.mesh, scene.meshes) || !is_of(instance.material, scene.materials))
            continue;
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        if (!is_sound(mesh)) continue;
        meshes.push_back(world_mesh(mesh, instance,
                                    scene.materials[static_cast<std::size_t>(instance.material)]));
        meshes.back().instance = static_cast<int>(i);
    }
    return meshes;
}

SampleMesh::SampleMesh(std::vector<WorldMesh> meshes) : meshes_(std::move(meshes)) {
    added_.resize(meshes_.size());
    weld_points();
}

void SampleMesh::weld_points() {
    std::vector<std::array<std::uint32_t, 2>> all;  // mesh, vertex
    for (std::size_t m = 0; m < meshes_.size(); ++m)
        for (std::size_t v = 0; v < meshes_[m].positions.size(); ++v)
            all.push_back({static_cast<std::uint32_t>(m), static_cast<std::uint32_t>(v)});
    const auto position = [&](std::size_t i) { return meshes_[all[i][0]].positions[all[i][1]]; };
    const auto normal = [&](std::size_t i) { return meshes_[all[i][0]].normals[all[i][1]]; };
    const Welding places = weld<3>(all.size(), [&](std::size_t i, std::uint32_t* words) {
        for (int c = 0; c < 3; ++c) words[c] = weld_bits(position(i)[c]);
    });
    // Normals of one point that several files or transforms have computed differ in the last digits.
    const Welding points = weld<4>(all.size(), [&](std::size_t i, std::uint32_t* words) {
        words[0] = places.ids[i];
        for (int c = 0; c < 3; ++c)
            words[c + 1] = static_cast<std::uint32_t>(std::lround(normal(i)[c] * 1024.0f));
    });
    places_ = places.classes;
    positions_.resize(points.classes);
    normals_.resize(points.classes);
    double_sided_.resize(points.classes);
    vertex_points_.resize(meshes_.size());
    vertex_places_.resize(meshes_.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::uint32_t point = points.ids[i];
        positions_[point] = position(i);
        normals_[point] = normal(i);
        if (meshes_[all[i][0]].double_sided) double_sided_[point] = 1;
        vertex_points_[all[i][0]].push_back(point);
        vertex_places_[all[i][0]].push_back(places.ids[i]);
    }
}

SampleMesh::Fans SampleMesh::fans() const {
    Fans fans;
    fans.first.assign(points() + 1, 0);
    const auto each = [&](const auto& visit) {
        for (std::size_t m = 0; m < meshes_.size(); ++m) {
            const std::vector<std::uint32_t>& indices = meshes_[m].indices;
            for (std::size_t c = 0; c < indices.size(); ++c)
                visit(vertex_points_[m][indices[c]],
                      Corner{static_cast<std::uint32_t>(m), static_cast<std::uint32_t>(c / 3)});
        }
    };
    each([&](std::uint32_t point, Corner) { ++fans.first[point + 1]; });
    for (std::size_t i = 0; i < points(); ++i) fans.first[i + 1] += fans.first[i];
    fans.corners.resize(fans.first.back());
    std::vector<std::uint32_t> next(fans.first.begin(), fans.first.end() - 1);
    each([&](std::uint32_t point, Corner corner) { fans.corners[next[point]++] = corner; });
    return fans;
}

std::array<glm::vec3, 3> SampleMesh::corners_of(const Corner& corner) const {
    const WorldMesh& mesh = meshes_[corner.mesh];
    const std::size_t first = 3 * static_cast<std::size_t>(corner.triangle);
    return {mesh.positions[mesh.indices[first]], mesh.positions[mesh.indices[first + 1]],
            mesh.positions[mesh.indices[first + 2]]};
}

}  // namespace burnish
