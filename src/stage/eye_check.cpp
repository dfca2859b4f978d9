#include "stage/eye_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <limits>

namespace burnish {
namespace {

// A surface that a ray meets, at `distance` in lengths of the ray's direction; infinity: none.
struct Hit {
    double distance = std::numeric_limits<double>::infinity();
    bool back = false;
    bool back_drawn = false;  // the surface shows its back faces
};

// Distance along the ray to the plane of a triangle inside it; no hit: infinity. Moeller and Trumbore
// 1997. `facing` > 0: the ray meets the front, where corners run counter-clockwise.
double distance_to(const std::array<glm::dvec3, 3>& p, glm::dvec3 from, glm::dvec3 ray,
                   double& facing) {
    constexpr double kNone = std::numeric_limits<double>::infinity();
    const glm::dvec3 a = p[1] - p[0], b = p[2] - p[0], q = glm::cross(ray, b);
    const double det = glm::dot(a, q);
    if (det == 0.0) return kNone;
    const glm::dvec3 s = from - p[0], r = glm::cross(s, a);
    const double u = glm::dot(s, q) / det, v = glm::dot(ray, r) / det;
    const double t = glm::dot(b, r) / det;
    // NaN of a triangle without area fails every comparison.
    if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0)) return kNone;
    facing = det;
    return t;
}

template <typename Use>
void for_triangles(const Scene& scene, const Use& use) {
    for (const Instance& instance : scene.instances) {
        if (instance.mesh < 0) continue;
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        const glm::dmat4 world(instance.transform);
        const bool mirrored = glm::determinant(glm::dmat3(world)) < 0.0;
        const Material& material = scene.materials[static_cast<std::size_t>(instance.material)];
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            std::array<glm::dvec3, 3> p;
            for (std::size_t k = 0; k < 3; ++k)
                p[k] = glm::dvec3(world *
                                  glm::dvec4(glm::dvec3(mesh.positions[mesh.indices[i + k]]), 1.0));
            if (mirrored) std::swap(p[1], p[2]);
            use(p, material);
        }
    }
}

// Six directions, none along an axis or an edge of usual meshes.
constexpr std::array<glm::dvec3, 6> kRays = {{{0.93, 0.21, 0.31},
                                              {-0.89, 0.34, -0.29},
                                              {0.27, 0.91, -0.33},
                                              {-0.35, -0.88, 0.23},
                                              {0.19, -0.37, 0.9},
                                              {-0.24, 0.29, -0.93}}};

std::array<Hit, kRays.size()> nearest_hits(const Scene& scene, glm::dvec3 eye) {
    std::array<Hit, kRays.size()> hits;
    for_triangles(scene, [&](const std::array<glm::dvec3, 3>& p, const Material& material) {
        for (std::size_t i = 0; i < kRays.size(); ++i) {
            double facing = 0.0;
            const double distance = distance_to(p, eye, kRays[i], facing);
            if (distance < hits[i].distance)
                hits[i] = {distance, facing < 0.0, material.double_sided};
        }
    });
    return hits;
}

bool contains(const Bounds& bounds, glm::vec3 p) {
    for (int i = 0; i < 3; ++i)
        if (!(p[i] >= bounds.low[i] && p[i] <= bounds.high[i])) return false;
    return true;
}

// How many of the rays meet a back first, and how many of these backs are drawn.
struct Backs {
    std::size_t all = 0, drawn = 0;
    bool most() const { return 2 * all > kRays.size(); }
};
Backs backs_around(const Scene& scene, glm::vec3 eye) {
    Backs backs;
    if (!contains(bounds_of(scene), eye)) return backs;
    for (const Hit& hit : nearest_hits(scene, glm::dvec3(eye))) {
        backs.all += hit.back ? 1 : 0;
        backs.drawn += hit.back && hit.back_drawn ? 1 : 0;
    }
    return backs;
}

// Distance from the target at which the line of sight last leaves the model; 0: it does not meet it.
double outermost(const Scene& scene, const Camera& camera) {
    const glm::dvec3 target(camera.target);
    const glm::dvec3 away = glm::normalize(glm::dvec3(camera.position) - target);
    double farthest = 0.0;
    for_triangles(scene, [&](const std::array<glm::dvec3, 3>& p, const Material&) {
        double facing = 0.0;
        const double distance = distance_to(p, target, away, facing);
        if (std::isfinite(distance)) farthest = std::max(farthest, distance);
    });
    return farthest;
}

// What leads out of the model.
std::string remedy_for(const Scene& scene, const ParameterValues& values, const Camera& camera) {
    if (values.is_set("camera_position")) return "--double-sided draws them";
    const double surface = outermost(scene, camera);
    if (values.is_set("camera_distance"))
        return fmt::format("--camera-distance above {:.3g} is outside", surface);
    const double framed = values.real("camera_zoom") *
                          static_cast<double>(glm::distance(camera.position, camera.target));
    return fmt::format(
        "--camera-zoom below {:.3g} is outside, and a smaller --camera-fov keeps the "
        "eye farther away at the same zoom",
        framed / surface);
}

}  // namespace

bool is_inside_model(const Scene& scene, glm::vec3 eye) {
    return backs_around(scene, eye).most();
}

void warn_of_eye_inside(const Scene& scene, const ParameterValues& values, const Camera& camera,
                        std::vector<std::string>& warnings) {
    if (values.is_set("camera_index")) return;
    const bool position = values.is_set("camera_position");
    const std::string_view name = position                           ? "camera_position"
                                  : values.is_set("camera_distance") ? "camera_distance"
                                  : values.is_set("camera_zoom")     ? "camera_zoom"
                                                                     : "";
    if (name.empty()) return;
    const Backs backs = backs_around(scene, camera.position);
    const bool all_drawn = backs.drawn == backs.all;
    if (!backs.most() || (position && all_drawn)) return;
    warnings.push_back(fmt::format(
        "{}: the eye is inside the model and sees {}; {}", name,
        all_drawn ? "the inner sides of its surfaces" : "through it, as back faces are not drawn",
        remedy_for(scene, values, camera)));
}

}  // namespace burnish
