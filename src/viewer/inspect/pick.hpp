// What a pixel shows: the nearest triangle on its ray.
//
// Threads: a Picker may be read from any number of threads, update() excluded. Lifetime: it keeps trees
// of the meshes and nothing else of the scene.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "burnish/scene.hpp"
#include "viewer/inspect/ray.hpp"
#include "viewer/inspect/triangle_tree.hpp"

namespace burnish::viewer {

// A point of a surface. Positions and directions are in world space; attributes are interpolated as
// the renderer interpolates them.
struct Hit {
    int instance = 0;  // indices into the scene
    int mesh = 0;
    int material = 0;
    std::uint32_t triangle = 0;   // its corners are Mesh::indices[3 triangle + 0, 1, 2]
    glm::dvec3 barycentric{0.0};  // weights of the corners, sum 1
    double distance = 0;  // along the ray, meters; negative behind an orthographic camera's place
    glm::dvec3 position{0.0};
    glm::dvec3 geometric_normal{0.0, 0.0, 1.0};  // of the triangle, unit, towards its front
    glm::vec3 normal{0.0f, 0.0f, 1.0f};  // interpolated, unit, towards the front; 0: normals cancel
    glm::vec4 tangent{1.0f, 0.0f, 0.0f, 1.0f};  // interpolated; w < 0: mirrored bitangent
    glm::vec2 uv0{0.0f}, uv1{0.0f};             // 0 where the mesh has none
    glm::vec4 color{1.0f};                      // of the vertices, linear
    bool front = true;                          // the ray sees the front
};

class Picker {
  public:
    Picker() = default;
    explicit Picker(const Scene& scene);

    // Follows a scene that has changed. A tree is made anew for a mesh whose positions or indices have
    // changed; looking for that takes 10 ms a million triangles.
    void update(const Scene& scene);
    // The same where only instances have changed, no mesh.
    void update_instances(const Scene& scene);

    // The nearest hit, or none. Back faces of materials that are not double-sided are not seen, as in
    // pictures; textures and alpha are not looked at. `scene`: the one of the last update.
    std::optional<Hit> pick(const Scene& scene, const Ray& ray) const;

  private:
    struct KnownMesh {
        std::uint64_t content = 0;  // of positions and indices
        Bounds bounds;
        std::shared_ptr<const TriangleTree> tree;
    };
    struct Placed {
        int instance = 0;
        glm::dmat4 local_from_world{1.0};
        Bounds bounds;  // world
        bool mirrored = false;
    };

    std::vector<KnownMesh> meshes_;  // of the scene, in its order
    std::vector<Placed> placed_;
};

// Shortcut for a pixel of a picture.
std::optional<Hit> pick(const Scene& scene, const Picker& picker, const Camera& camera,
                        glm::dvec2 pixel, WindowSize window);

// Unit, from the hit to the eye of the camera.
glm::dvec3 towards_eye(const Camera& camera, glm::dvec3 point);

}  // namespace burnish::viewer
