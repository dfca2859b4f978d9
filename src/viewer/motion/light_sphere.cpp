#include "viewer/motion/light_sphere.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/constants.hpp"
#include "scene/camera/view.hpp"
#include "scene/light/area_lights.hpp"
#include "viewer/inspect/point_lobe.hpp"

namespace burnish::viewer {
namespace {

// `v` rotated by `angle` about the unit `axis` (Rodrigues).
glm::dvec3 rotated_about(glm::dvec3 v, glm::dvec3 axis, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return v * c + glm::cross(axis, v) * s + axis * (glm::dot(axis, v) * (1 - c));
}

// A drag of the ball: the rotation by which its front follows the cursor.
struct BallTurn {
    glm::dvec3 axis{0.0, 1.0, 0.0};
    double angle = 0;  // radians

    BallTurn(const Camera& camera, glm::dvec2 drag_px, int height_px) {
        const CameraBasis basis = camera_basis(camera);
        const double length = glm::length(drag_px);
        if (!(length > 0)) return;
        axis = (basis.up * drag_px.x + basis.right * drag_px.y) / length;
        angle = kPi * length / height_px;
    }
    glm::dvec3 operator()(glm::dvec3 v) const { return rotated_about(v, axis, angle); }
};

std::optional<glm::dvec3> highlight_under(const SurfaceAt& at, Method method, glm::dvec3 to_eye) {
    const PointLobe lobe(at, method);
    if (!at.reflects() || !lobe.has_meaning()) return std::nullopt;
    const glm::dvec3 eye = to_tangent_frame(at, to_eye);
    const glm::dvec3 light = lobe.peak_to_light(eye);
    if (!(light.z > 0) || !(glm::dot(light, lobe.normal(eye)) > 0)) return std::nullopt;
    return to_world(at, light);
}

}  // namespace

glm::dvec3 towards_light(const Light& light, glm::dvec3 point) {
    const glm::dvec3 towards = light.type == LightType::directional
                                   ? -glm::dvec3(light.direction)
                                   : glm::dvec3(light.position) - point;
    const double length = glm::length(towards);
    // A light at the point lights it from above.
    return length > 0 ? towards / length : glm::dvec3(0.0, 1.0, 0.0);
}

glm::dvec3 dragged_direction(const Camera& camera, glm::dvec3 to_light, glm::dvec2 drag_px,
                             int height_px) {
    return glm::normalize(BallTurn(camera, drag_px, height_px)(to_light));
}

Light dragged_light(const Camera& camera, const Light& light, glm::dvec3 pivot, glm::dvec2 drag_px,
                    int height_px) {
    const BallTurn turn(camera, drag_px, height_px);
    Light moved = light;
    moved.direction = glm::vec3(glm::normalize(turn(glm::dvec3(light.direction))));
    if (light.type == LightType::rectangle || light.type == LightType::disc)
        moved.up = glm::vec3(turn(glm::dvec3(light.up)));
    if (light.type != LightType::directional)
        moved.position = glm::vec3(pivot + turn(glm::dvec3(light.position) - pivot));
    return moved;
}

BallPlace place_on_ball(const Camera& camera, glm::dvec3 direction) {
    const CameraBasis basis = camera_basis(camera);
    return {{glm::dot(direction, basis.right), glm::dot(direction, basis.up)},
            glm::dot(direction, basis.back) >= 0};
}

glm::dvec3 direction_on_ball(const Camera& camera, const BallPlace& place) {
    const CameraBasis basis = camera_basis(camera);
    const double radius = glm::length(place.at);
    const glm::dvec2 at = radius > 1 ? place.at / radius : place.at;
    const double depth = std::sqrt(std::max(1 - glm::dot(at, at), 0.0));
    return glm::normalize(basis.right * at.x + basis.up * at.y +
                          basis.back * (place.front ? depth : -depth));
}

std::optional<glm::dvec3> direction_for_highlight(const Scene& scene, const Hit& hit,
                                                  glm::dvec3 to_eye) {
    const SurfaceAt at = surface_at(scene, hit, to_eye);
    return highlight_under(at, at.method, to_eye);
}

std::optional<glm::dvec3> direction_for_highlight(const Scene& scene, const Hit& hit,
                                                  glm::dvec3 to_eye, Method method) {
    return highlight_under(surface_at(scene, hit, to_eye), method, to_eye);
}

std::optional<Light> light_for_highlight(const Scene& scene, const Hit& hit, glm::dvec3 to_eye,
                                         const Light& light) {
    const std::optional<glm::dvec3> towards = direction_for_highlight(scene, hit, to_eye);
    if (!towards) return std::nullopt;
    Light placed = light;
    // A tube shines to all sides of its axis: it moves and does not turn.
    if (light.type != LightType::point && light.type != LightType::tube)
        placed.direction = glm::vec3(-*towards);
    if (light.type == LightType::directional) return placed;
    // `up` may not lie along the new direction.
    if (light.type == LightType::rectangle || light.type == LightType::disc)
        placed.up = glm::normalize(area_axes(placed).y);
    const double distance = glm::length(glm::dvec3(light.position) - hit.position);
    placed.position = glm::vec3(hit.position + *towards * distance);
    return placed;
}

}  // namespace burnish::viewer
