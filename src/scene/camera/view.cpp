#include "scene/camera/view.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include "burnish/error.hpp"

namespace burnish {
namespace {

struct Planes {
    double near_plane, far_plane;
};

Planes planes_of(const Camera& camera, const Bounds& bounds, const CameraBasis& basis) {
    const double radius = std::max(static_cast<double>(bounds.radius()), 1e-6);
    const double depth = glm::dot(basis.position - glm::dvec3(bounds.center()), basis.back);
    Planes p;
    // 1 % beyond the bounding sphere, so that nothing touches a plane.
    p.far_plane = camera.far_plane > 0 ? camera.far_plane : depth + 1.01 * radius;
    p.near_plane = camera.near_plane > 0 ? camera.near_plane : depth - 1.01 * radius;
    if (camera.orthographic) {
        p.far_plane = std::max(p.far_plane, p.near_plane + 1e-3 * radius);
        return p;
    }
    // For an eye inside the scene, a near plane at 1/10000 of the far distance keeps a 24-bit depth
    // buffer precise.
    p.far_plane = std::max(p.far_plane, 1e-3 * radius);
    if (!(camera.near_plane > 0)) p.near_plane = std::max(p.near_plane, 1e-4 * p.far_plane);
    p.far_plane = std::max(p.far_plane, p.near_plane * 1.001);
    return p;
}

}  // namespace

CameraBasis camera_basis(const Camera& camera) {
    const glm::dvec3 position(camera.position);
    const glm::dvec3 back = position - glm::dvec3(camera.target);
    const double distance = glm::length(back);
    if (!(distance > 0) || !std::isfinite(distance)) {
        throw Error("camera", "target", "a place other than the camera's", "the same or no place");
    }
    CameraBasis b;
    b.position = position;
    b.back = back / distance;
    const glm::dvec3 helper = std::abs(b.back.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, -1);
    const glm::dvec3 wished = glm::cross(glm::dvec3(camera.up), b.back);
    // 1e-9: `up` is parallel to the view direction; the helper axis replaces it.
    b.right = glm::length(wished) > 1e-9 ? wished : glm::cross(helper, b.back);
    b.right = glm::normalize(b.right);
    b.up = glm::cross(b.back, b.right);
    return b;
}

double half_height_of(const Camera& camera) {
    const double half_height =
        camera.orthographic ? camera.ymag : std::tan(0.5 * static_cast<double>(camera.yfov));
    if (!(half_height > 0) || !(half_height < 1e9)) {
        throw Error("camera", camera.orthographic ? "ymag" : "yfov", "a view of some height",
                    std::to_string(camera.orthographic ? camera.ymag : camera.yfov));
    }
    return half_height;
}

std::vector<Tile> tiles_of(int width, int height, int side) {
    std::vector<Tile> tiles;
    for (int y = 0; y < height; y += side) {
        for (int x = 0; x < width; x += side) {
            tiles.push_back({x, y, std::min(side, width - x), std::min(side, height - y)});
        }
    }
    return tiles;
}

View make_view(const Camera& camera, const Bounds& bounds, int width, int height, const Tile& tile,
               glm::dvec2 offset_px) {
    const CameraBasis basis = camera_basis(camera);
    const Planes planes = planes_of(camera, bounds, basis);
    const double half_height = half_height_of(camera);
    // The tile's window on the image plane at distance 1, moved by the offset.
    const double pixel = 2 * half_height / height;
    const double left = (tile.x + offset_px.x - 0.5 * width) * pixel;
    const double bottom = (tile.y + offset_px.y - 0.5 * height) * pixel;
    const double right = left + tile.width * pixel;
    const double top = bottom + tile.height * pixel;

    const glm::dmat4 view(
        glm::dvec4(basis.right.x, basis.up.x, basis.back.x, 0),
        glm::dvec4(basis.right.y, basis.up.y, basis.back.y, 0),
        glm::dvec4(basis.right.z, basis.up.z, basis.back.z, 0),
        glm::dvec4(-glm::dot(basis.right, basis.position), -glm::dot(basis.up, basis.position),
                   -glm::dot(basis.back, basis.position), 1));
    View v;
    if (camera.orthographic) {
        v.clip_from_world = glm::mat4(
            glm::ortho(left, right, bottom, top, planes.near_plane, planes.far_plane) * view);
        v.eye = glm::vec4(glm::vec3(basis.back), 0.0f);
        v.ray_center = glm::vec3(-basis.back);
        return v;
    }
    const double n = planes.near_plane;
    v.clip_from_world = glm::mat4(
        glm::frustum(left * n, right * n, bottom * n, top * n, n, planes.far_plane) * view);
    v.eye = glm::vec4(glm::vec3(basis.position), 1.0f);
    v.ray_center = glm::vec3(-basis.back + basis.right * (0.5 * (left + right)) +
                             basis.up * (0.5 * (bottom + top)));
    v.ray_x = glm::vec3(basis.right * (0.5 * (right - left)));
    v.ray_y = glm::vec3(basis.up * (0.5 * (top - bottom)));
    return v;
}

Tile screen_bounds(const View& view, const Bounds& box, const Tile& tile) {
    glm::vec2 low(1.0f);
    glm::vec2 high(-1.0f);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 p((corner & 1) != 0 ? box.high.x : box.low.x,
                          (corner & 2) != 0 ? box.high.y : box.low.y,
                          (corner & 4) != 0 ? box.high.z : box.low.z);
        const glm::vec4 clip = view.clip_from_world * glm::vec4(p, 1.0f);
        if (!(clip.w > 0.0f)) return {0, 0, tile.width, tile.height};
        const glm::vec2 ndc = glm::clamp(glm::vec2(clip) / clip.w, -1.0f, 1.0f);
        low = glm::min(low, ndc);
        high = glm::max(high, ndc);
    }
    // One pixel more on each side, for rounding.
    const auto pixel = [](float ndc, int size) {
        return static_cast<int>((0.5f * ndc + 0.5f) * static_cast<float>(size));
    };
    const int left = std::max(pixel(low.x, tile.width) - 1, 0);
    const int bottom = std::max(pixel(low.y, tile.height) - 1, 0);
    const int right = std::min(pixel(high.x, tile.width) + 2, tile.width);
    const int top = std::min(pixel(high.y, tile.height) + 2, tile.height);
    return {left, bottom, std::max(right - left, 0), std::max(top - bottom, 0)};
}

}  // namespace burnish
