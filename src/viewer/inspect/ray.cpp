#include "viewer/inspect/ray.hpp"

#include <glm/geometric.hpp>
#include <limits>

#include "scene/camera/view.hpp"

namespace burnish::viewer {

Ray ray_of(const Camera& camera, glm::dvec2 pixel, WindowSize window) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const CameraBasis basis = camera_basis(camera);
    const double size = 2 * half_height_of(camera) / window.height;
    const glm::dvec3 across = basis.right * ((pixel.x - 0.5 * window.width) * size) -
                              basis.up * ((pixel.y - 0.5 * window.height) * size);
    const auto near_plane = static_cast<double>(camera.near_plane);
    const auto far_plane = static_cast<double>(camera.far_plane);
    Ray ray;
    if (camera.orthographic) {
        ray.origin = basis.position + across;
        ray.direction = -basis.back;
        ray.from = near_plane > 0 ? near_plane : -kInfinity;
        ray.to = far_plane > 0 ? far_plane : kInfinity;
        return ray;
    }
    // Of depth 1.
    const glm::dvec3 towards = across - basis.back;
    const double length = glm::length(towards);
    ray.origin = basis.position;
    ray.direction = towards / length;
    ray.from = near_plane > 0 ? near_plane * length : 0.0;
    ray.to = far_plane > 0 ? far_plane * length : kInfinity;
    return ray;
}

std::optional<glm::dvec2> pixel_of(const Camera& camera, glm::dvec3 point, WindowSize window) {
    const CameraBasis basis = camera_basis(camera);
    const glm::dvec3 v = point - basis.position;
    const double depth = camera.orthographic ? 1.0 : -glm::dot(v, basis.back);
    if (!(depth > 0)) return std::nullopt;
    const double pixels = window.height / (2 * half_height_of(camera) * depth);
    return glm::dvec2(0.5 * window.width + glm::dot(v, basis.right) * pixels,
                      0.5 * window.height - glm::dot(v, basis.up) * pixels);
}

}  // namespace burnish::viewer
