#include "viewer/motion/orbit.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "core/constants.hpp"
#include "scene/camera/angles.hpp"
#include "scene/camera/framing.hpp"
#include "scene/camera/view.hpp"

namespace burnish::viewer {
namespace {

// Nearer to a point than this share of its distance from the origin, single precision would move the
// picture by more than a pixel: 2^-24 over 1e-4 is 6e-4 of the distance.
constexpr double kNearestShare = 1e-4;
constexpr double kFarthest = 1e9;  // meters; squares still fit single precision

// Columns right, up, back of a level camera.
glm::dmat3 level_axes(DirectionAngles angles) {
    const double azimuth = angles.azimuth_deg * kDegree;
    const glm::dvec3 back = direction_at(angles);
    const glm::dvec3 right(std::cos(azimuth), 0.0, -std::sin(azimuth));
    return {right, glm::cross(back, right), back};
}

// Where the camera stands as seen from its target. A vertical view has its azimuth from the up direction,
// as place_camera sets it.
DirectionAngles place_of(const CameraBasis& basis) {
    DirectionAngles angles = angles_of(basis.back);
    // 1e-4 radians: place_camera changes the up direction of steeper views.
    if (std::hypot(basis.back.x, basis.back.z) > 1e-4) return angles;
    angles.azimuth_deg = angles_of(basis.back.y > 0 ? -basis.up : basis.up).azimuth_deg;
    return angles;
}

// Meters a pixel at a depth.
double pixel_size(const Camera& camera, int height_px, double depth) {
    const double size = 2 * half_height_of(camera) / height_px;
    return camera.orthographic ? size : size * depth;
}

Camera shifted(const Camera& camera, glm::dvec3 by) {
    Camera moved = camera;
    moved.position = glm::vec3(glm::dvec3(camera.position) + by);
    moved.target = glm::vec3(glm::dvec3(camera.target) + by);
    return moved;
}

}  // namespace

Camera orbited(const Camera& camera, glm::dvec3 pivot, glm::dvec2 drag_px, int height_px) {
    const double turn = kTwoPi / height_px;
    return orbited_by(camera, pivot, -drag_px.x * turn, drag_px.y * turn);
}

Camera orbited(const Camera& camera, glm::dvec2 drag_px, int height_px) {
    return orbited(camera, glm::dvec3(camera.target), drag_px, height_px);
}

Camera orbited_by(const Camera& camera, glm::dvec3 pivot, double azimuth_rad,
                  double elevation_rad) {
    const CameraBasis basis = camera_basis(camera);
    const DirectionAngles before = place_of(basis);
    const DirectionAngles after = {
        before.azimuth_deg + azimuth_rad * kDegreesPerRadian,
        std::clamp(before.elevation_deg + elevation_rad * kDegreesPerRadian, -kHighestElevationDeg,
                   kHighestElevationDeg)};
    const glm::dmat3 turned = level_axes(after) * glm::transpose(level_axes(before));
    const glm::dvec3 position = pivot + turned * (basis.position - pivot);
    const double distance = glm::length(basis.position - glm::dvec3(camera.target));
    Camera moved = camera;
    moved.position = glm::vec3(position);
    moved.target = glm::vec3(position - distance * direction_at(after));
    moved.up = glm::vec3(0.0f, 1.0f, 0.0f);
    return moved;
}

double depth_of(const Camera& camera, glm::dvec3 point) {
    const CameraBasis basis = camera_basis(camera);
    return glm::dot(basis.position - point, basis.back);
}

Camera panned(const Camera& camera, glm::dvec2 drag_px, int height_px, double depth) {
    if (!camera.orthographic && !(depth > 0)) return camera;
    const CameraBasis basis = camera_basis(camera);
    const double pixel = pixel_size(camera, height_px, depth);
    return shifted(camera, (basis.up * drag_px.y - basis.right * drag_px.x) * pixel);
}

Camera panned(const Camera& camera, glm::dvec2 drag_px, int height_px) {
    return panned(camera, drag_px, height_px, depth_of(camera, glm::dvec3(camera.target)));
}

glm::dvec3 under_cursor(const Camera& camera, glm::dvec2 cursor_px, WindowSize window) {
    const CameraBasis basis = camera_basis(camera);
    const glm::dvec3 target(camera.target);
    const double pixel =
        pixel_size(camera, window.height, glm::dot(basis.position - target, basis.back));
    return target + (basis.right * (cursor_px.x - 0.5 * window.width) -
                     basis.up * (cursor_px.y - 0.5 * window.height)) *
                        pixel;
}

Camera zoomed(const Camera& camera, double factor, glm::dvec3 fixed) {
    const CameraBasis basis = camera_basis(camera);
    const glm::dvec3 away = basis.position - fixed;
    const double size = camera.orthographic ? camera.ymag : glm::length(away);
    const double wanted = size * factor;
    const bool too_near = factor < 1 && wanted < kNearestShare * glm::length(fixed);
    if (!(factor > 0) || !(wanted > 0) || !(wanted < kFarthest) || too_near) return camera;
    if (camera.orthographic) {
        const glm::dvec3 across = away - basis.back * glm::dot(away, basis.back);
        Camera moved = shifted(camera, across * (factor - 1));
        moved.ymag = static_cast<float>(wanted);
        return moved;
    }
    Camera moved = camera;
    moved.position = glm::vec3(fixed + away * factor);
    moved.target = glm::vec3(fixed + (glm::dvec3(camera.target) - fixed) * factor);
    return moved;
}

Camera zoomed(const Camera& camera, double factor, glm::dvec2 cursor_px, WindowSize window) {
    return zoomed(camera, factor, under_cursor(camera, cursor_px, window));
}

double wheel_factor(double steps) {
    return std::pow(0.9, steps);
}

Camera framed(const Camera& camera, const Bounds& bounds, double aspect) {
    const CameraBasis basis = camera_basis(camera);
    const glm::vec3 center = bounds.center();
    Framing framing(center, glm::vec3(basis.back), glm::vec3(basis.up),
                    static_cast<double>(camera.yfov), aspect);
    for (int corner = 0; corner < 8; ++corner) {
        framing.include({(corner & 1) != 0 ? bounds.high.x : bounds.low.x,
                         (corner & 2) != 0 ? bounds.high.y : bounds.low.y,
                         (corner & 4) != 0 ? bounds.high.z : bounds.low.z});
    }
    Camera moved = camera;
    moved.target = center;
    moved.position = glm::vec3(glm::dvec3(center) + framing.distance() * basis.back);
    if (camera.orthographic) moved.ymag = static_cast<float>(framing.half_height());
    return moved;
}

}  // namespace burnish::viewer
