#include "rays/closed_in_lights.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>

#include "rays/ray_scene.hpp"
#include "rays/vertex_rays.hpp"
#include "rays/world_mesh.hpp"

namespace burnish {
namespace {

// Of each hemisphere: an opening of a sixteenth of a sphere is not missed.
constexpr int kDirections = 48;

bool has_position(const Light& light) {
    return light.type != LightType::directional;
}

// The mesh whose inner side a ray meets first.
std::optional<std::uint32_t> inside_of(const RayScene& rays, const std::vector<WorldMesh>& meshes,
                                       const glm::vec3& from, const glm::vec3& direction) {
    const std::optional<RayHit> hit = rays.nearest({from, direction, 0.0f, 0.0f});
    if (!hit) return std::nullopt;
    const bool from_behind = glm::dot(hit->normal, direction) > 0.0f;
    // Two-sided surfaces have no inner side.
    if (!from_behind || meshes[hit->mesh].double_sided) return std::nullopt;
    return hit->mesh;
}

std::optional<std::uint32_t> closes_in(const RayScene& rays, const std::vector<WorldMesh>& meshes,
                                       const glm::vec3& from) {
    std::optional<std::uint32_t> body;
    for (const glm::vec3& w : even_hemisphere(kDirections))
        for (const float side : {1.0f, -1.0f}) {
            body = inside_of(rays, meshes, from, {w.x, w.y, side * w.z});
            if (!body) return std::nullopt;
        }
    return body;
}

}  // namespace

std::vector<std::string> warnings_of_closed_in_lights(const Scene& scene) {
    std::vector<std::string> warnings;
    if (std::ranges::none_of(scene.lights, has_position)) return warnings;
    const std::vector<WorldMesh> meshes = world_meshes(scene);
    const RayScene rays(meshes);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        if (!has_position(scene.lights[i])) continue;
        const std::optional<std::uint32_t> body = closes_in(rays, meshes, scene.lights[i].position);
        if (!body) continue;
        const Instance& instance =
            scene.instances[static_cast<std::size_t>(meshes[*body].instance)];
        const std::string& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)].name;
        warnings.push_back(
            fmt::format("light {}: lies within the object {}{}, which keeps its light in where "
                        "there are shadows; "
                        "it is drawn so; a light outside the object reaches the scene",
                        i + 1, meshes[*body].instance, mesh.empty() ? "" : " (" + mesh + ")"));
    }
    return warnings;
}

}  // namespace burnish
