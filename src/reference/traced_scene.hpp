// The triangles of a scene for rays, and what its surfaces are at a hit.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <vector>

#include "burnish/scene.hpp"
#include "rays/ray_scene.hpp"
#include "reference/material_reader.hpp"
#include "reference/surface_hit.hpp"

namespace burnish {

// How wide a ray has become: a cone about it (Akenine-Moller et al., "Texture Level of Detail Strategies for Real-Time
// Ray Tracing", 2019).
struct RayCone {
    float width = 0.0f;   // meters
    float spread = 0.0f;  // meters a meter
};

// Threads: immutable. Lifetime: refers to the meshes, materials and textures of the scene.
class TracedScene {
  public:
    // Throws Error for textures that do not exist and where there is no memory.
    explicit TracedScene(const Scene& scene);

    // The nearest triangle that shows. `camera`: back faces of materials that are not double-sided are not seen, as in
    // pictures; `chance`: a blended surface is passed by this number in [0, 1) or above its alpha.
    std::optional<RayHit> nearest(Ray ray, const RayCone& cone, bool camera, float chance) const;
    SurfaceHit at(const RayHit& hit, const Ray& ray, const RayCone& cone) const;
    const MaterialReader& reader(int material) const {
        return readers_[static_cast<std::size_t>(material)];
    }
    // Whether light from `distance` meters (0: infinitely far) along `direction` is kept from the surface. Blended
    // surfaces block nothing.
    bool is_blocked(const SurfaceHit& from, const glm::vec3& direction, float distance) const;
    // A ray from a surface.
    Ray leaving(const SurfaceHit& from, const glm::vec3& direction) const;
    bool is_blocked(Ray ray) const;

    bool sees_through() const { return sees_through_; }  // some surface is masked or blended

  private:
    struct Attributes {
        const Mesh* mesh = nullptr;
        std::vector<glm::vec4> tangents;  // world
        bool reads_textures = false;
        bool sees_through = false;  // masked or blended
        bool culled = false;        // its back faces are not seen
    };
    Attributes attributes_of(const Scene& scene, const WorldMesh& world) const;
    void put_texture_coordinates(SurfaceHit& at, const RayHit& hit, const Ray& ray,
                                 const RayCone& cone) const;

    std::vector<MaterialReader> readers_;
    std::vector<WorldMesh> meshes_;
    std::vector<Attributes> attributes_;
    std::optional<RayScene> all_, blocking_;  // the second only where some surface blends
    bool masked_ = false;                     // some surface has holes
    bool sees_through_ = false;
};

}  // namespace burnish
