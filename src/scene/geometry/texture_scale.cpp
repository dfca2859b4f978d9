#include "scene/geometry/texture_scale.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

namespace burnish {
namespace {

struct Side {
    double length, area;
};

void append_sides(const Mesh& mesh, const glm::dmat4& transform, std::vector<Side>& sides) {
    if (mesh.texcoord0.empty()) return;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        glm::dvec3 p[3];
        glm::dvec2 t[3];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t vertex = mesh.indices[i + k];
            p[k] = glm::dvec3(transform * glm::dvec4(glm::dvec3(mesh.positions[vertex]), 1.0));
            t[k] = glm::dvec2(mesh.texcoord0[vertex]);
        }
        const double area = glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
        const glm::dvec2 a = t[1] - t[0], b = t[2] - t[0];
        const double of_texture = std::abs(a.x * b.y - a.y * b.x);
        const double length = std::sqrt(area / of_texture);
        if (area > 0.0 && of_texture > 0.0 && std::isfinite(length))
            sides.push_back({length, area});
    }
}

// The length below which `share` of the area lies. `sides` are in order.
double quantile(const std::vector<Side>& sides, double share) {
    double whole = 0.0, so_far = 0.0;
    for (const Side& side : sides) whole += side.area;
    for (const Side& side : sides) {
        so_far += side.area;
        if (so_far >= share * whole) return side.length;
    }
    return sides.back().length;
}

}  // namespace

std::optional<TextureSquare> texture_square(const Scene& scene, int material) {
    std::vector<Side> sides;
    for (const Instance& instance : scene.instances)
        if (instance.mesh >= 0 && instance.material == material)
            append_sides(scene.meshes[static_cast<std::size_t>(instance.mesh)],
                         glm::dmat4(instance.transform), sides);
    if (sides.empty()) return std::nullopt;
    std::sort(sides.begin(), sides.end(),
              [](const Side& a, const Side& b) { return a.length < b.length; });
    return TextureSquare{quantile(sides, 0.5), quantile(sides, 0.25), quantile(sides, 0.75)};
}

}  // namespace burnish
