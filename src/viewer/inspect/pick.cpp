#include "viewer/inspect/pick.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <span>
#include <string_view>

#include "burnish/f32.hpp"
#include "core/index_of.hpp"
#include "core/parallel.hpp"
#include "scene/camera/view.hpp"
#include "scene/geometry/normal_transform.hpp"

namespace burnish::viewer {
namespace {

bool is_drawn(const Instance& instance, const Scene& scene) {
    return instance.mesh >= 0 && index_of(instance.mesh) < scene.meshes.size() &&
           instance.material >= 0 && index_of(instance.material) < scene.materials.size();
}

// Changes with positions and indices.
std::uint64_t content_of(const Mesh& mesh) {
    const auto sum_of = [](const auto& values) -> std::uint64_t {
        const auto bytes = std::as_bytes(std::span(values));
        return std::hash<std::string_view>()(
            {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    };
    // An odd factor, so that the order counts.
    return sum_of(mesh.positions) * 0x9E3779B97F4A7C15U + sum_of(mesh.indices);
}

// The box of the transformed corners; a little larger, for the rounding of single precision.
Bounds box_in_world(const Bounds& box, const glm::dmat4& transform) {
    glm::dvec3 low(0.0), high(0.0);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec4 local((corner & 1) != 0 ? box.high.x : box.low.x,
                               (corner & 2) != 0 ? box.high.y : box.low.y,
                               (corner & 4) != 0 ? box.high.z : box.low.z, 1.0);
        const glm::dvec3 world(transform * local);
        low = corner == 0 ? world : glm::min(low, world);
        high = corner == 0 ? world : glm::max(high, world);
    }
    const glm::dvec3 more = 1e-6 * (glm::abs(low) + glm::abs(high));
    return {glm::vec3(low - more), glm::vec3(high + more)};
}

bool meets_box(const Bounds& box, const Ray& ray) {
    double from = ray.from, to = ray.to;
    for (int axis = 0; axis < 3; ++axis) {
        const auto low = static_cast<double>(box.low[axis]),
                   high = static_cast<double>(box.high[axis]);
        const double origin = ray.origin[axis], direction = ray.direction[axis];
        if (direction == 0) {
            if (origin < low || origin > high) return false;
            continue;
        }
        const double a = (low - origin) / direction, b = (high - origin) / direction;
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    return from <= to;
}

glm::vec3 unit_or_zero(glm::vec3 v) {
    // As surface.vert.
    return v / std::sqrt(std::max(glm::dot(v, v), 1e-30f));
}

// The corners of a triangle and the weights of a point in it.
struct Corners {
    std::array<std::size_t, 3> at{};
    glm::vec3 weights{0.0f};

    template <typename T>
    T mean(const std::vector<T>& values, T missing) const {
        if (values.empty()) return missing;
        return values[at[0]] * weights[0] + values[at[1]] * weights[1] + values[at[2]] * weights[2];
    }
};

// Normal and tangent, transformed at the vertices and then interpolated, as surface.vert does.
void put_frame(Hit& hit, const Mesh& mesh, const Corners& corners, const glm::mat4& transform,
               bool mirrored) {
    const glm::mat3 linear(transform);
    const glm::mat3 of_normals = normal_transform(linear);
    glm::vec3 normal(0.0f);
    glm::vec4 tangent(0.0f);
    for (int c = 0; c < 3; ++c) {
        const std::size_t v = corners.at[index_of(c)];
        const glm::vec3 n = unit_or_zero(mesh.normals.empty() ? glm::vec3(hit.geometric_normal)
                                                              : of_normals * mesh.normals[v]);
        const glm::vec4 stored = mesh.tangents.empty() ? glm::vec4(0, 0, 0, 1) : mesh.tangents[v];
        const f32::vec3 t =
            f32::tangent_or_any(f32::vec3(n), f32::vec3(unit_or_zero(linear * glm::vec3(stored))));
        normal += n * corners.weights[c];
        tangent += glm::vec4(t.x, t.y, t.z, mirrored ? -stored.w : stored.w) * corners.weights[c];
    }
    hit.normal = unit_or_zero(normal);
    hit.tangent = tangent;
}

Hit hit_of(const Scene& scene, int instance_index, const TreeHit& found, const Ray& ray,
           bool mirrored) {
    const Instance& instance = scene.instances[index_of(instance_index)];
    const Mesh& mesh = scene.meshes[index_of(instance.mesh)];
    Hit hit;
    hit.instance = instance_index;
    hit.mesh = instance.mesh;
    hit.material = instance.material;
    hit.triangle = found.triangle;
    hit.barycentric = found.barycentric;
    hit.distance = found.t;
    hit.position = ray.at(found.t);
    hit.front = found.front;
    Corners corners;
    corners.weights = glm::vec3(found.barycentric);
    std::array<glm::dvec3, 3> world{};
    const glm::dmat4 transform(instance.transform);
    for (std::size_t c = 0; c < 3; ++c) {
        corners.at[c] = mesh.indices[3 * std::size_t{found.triangle} + c];
        world[c] = glm::dvec3(transform * glm::dvec4(mesh.positions[corners.at[c]], 1.0));
    }
    const glm::dvec3 across = glm::cross(world[1] - world[0], world[2] - world[0]);
    hit.geometric_normal = glm::normalize(mirrored ? -across : across);
    put_frame(hit, mesh, corners, instance.transform, mirrored);
    hit.uv0 = corners.mean(mesh.texcoord0, glm::vec2(0.0f));
    hit.uv1 = corners.mean(mesh.texcoord1, glm::vec2(0.0f));
    hit.color = corners.mean(mesh.colors, glm::vec4(1.0f));
    return hit;
}

}  // namespace

Picker::Picker(const Scene& scene) {
    update(scene);
}

void Picker::update(const Scene& scene) {
    meshes_.resize(scene.meshes.size());
    parallel_for(scene.meshes.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Mesh& mesh = scene.meshes[i];
            const std::uint64_t content = content_of(mesh);
            if (meshes_[i].tree && meshes_[i].content == content) continue;
            meshes_[i] = {content, bounds_of(mesh), std::make_shared<const TriangleTree>(mesh)};
        }
    });
    update_instances(scene);
}

void Picker::update_instances(const Scene& scene) {
    placed_.clear();
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        if (!is_drawn(instance, scene)) continue;
        const KnownMesh& mesh = meshes_[index_of(instance.mesh)];
        if (mesh.tree->triangles() == 0) continue;
        const glm::dmat4 transform(instance.transform);
        const double determinant = glm::determinant(glm::dmat3(transform));
        // A model that is scaled to a plane or a line has no inverse.
        if (!(std::abs(determinant) > 0) || !std::isfinite(determinant)) continue;
        placed_.push_back({static_cast<int>(i), glm::inverse(transform),
                           box_in_world(mesh.bounds, transform), determinant < 0});
    }
}

std::optional<Hit> Picker::pick(const Scene& scene, const Ray& ray) const {
    std::optional<TreeHit> nearest;
    const Placed* of = nullptr;
    Ray left = ray;  // its end moves to the nearest hit so far
    for (const Placed& placed : placed_) {
        if (!meets_box(placed.bounds, left)) continue;
        const Instance& instance = scene.instances[index_of(placed.instance)];
        const bool both = scene.materials[index_of(instance.material)].double_sided;
        // The direction is not made unit, so that t is in meters of the world.
        const TreeRay local = {glm::dvec3(placed.local_from_world * glm::dvec4(left.origin, 1.0)),
                               glm::dmat3(placed.local_from_world) * left.direction, left.from,
                               left.to};
        const auto found = meshes_[index_of(instance.mesh)].tree->nearest(
            local, both ? TriangleTree::Faces::both : TriangleTree::Faces::front);
        if (!found) continue;
        nearest = found;
        of = &placed;
        left.to = found->t;
    }
    if (!nearest) return std::nullopt;
    return hit_of(scene, of->instance, *nearest, ray, of->mirrored);
}

std::optional<Hit> pick(const Scene& scene, const Picker& picker, const Camera& camera,
                        glm::dvec2 pixel, WindowSize window) {
    return picker.pick(scene, ray_of(camera, pixel, window));
}

glm::dvec3 towards_eye(const Camera& camera, glm::dvec3 point) {
    const CameraBasis basis = camera_basis(camera);
    return camera.orthographic ? basis.back : glm::normalize(basis.position - point);
}

}  // namespace burnish::viewer
