// Rays against the triangles of a scene, by Embree.
//
// Threads: queries may be made from any number of threads. Lifetime: it keeps nothing of the meshes.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>

#include "rays/world_mesh.hpp"

namespace burnish {

struct Ray {
    glm::vec3 origin{0.0f};
    glm::vec3 direction{0.0f, 0.0f, 1.0f};  // unit
    float nearest = 0.0f;                   // meters
    float farthest = 0.0f;                  // 0: no end
};

struct RayHit {
    float distance = 0.0f;
    std::uint32_t mesh = 0;      // index into the meshes
    std::uint32_t triangle = 0;  // three of its indices
    float u = 0.0f, v = 0.0f;    // weights of the second and the third corner
    glm::vec3 normal{0.0f};      // geometric, not unit; counter-clockwise corners face it
};

class RayScene {
  public:
    // Meshes that block nothing are left out. Throws Error where there is no memory.
    explicit RayScene(std::span<const WorldMesh> meshes);

    bool is_blocked(const Ray& ray) const;
    std::optional<RayHit> nearest(const Ray& ray) const;

  private:
    struct Tree;
    std::shared_ptr<const Tree> tree_;
};

}  // namespace burnish
