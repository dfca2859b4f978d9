// The light that surfaces reflect to one another.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "burnish/f32.hpp"
#include "burnish/progress.hpp"
#include "burnish/visibility.hpp"
#include "rays/bounce_material.hpp"
#include "rays/environment_lookup.hpp"
#include "rays/ray_scene.hpp"
#include "rays/sample_mesh.hpp"
#include "rays/vertex_rays.hpp"

namespace burnish {

// References stay the caller's.
struct BounceScene {
    const SampleMesh& mesh;
    const SampleMesh::Fans& fans;
    const RayScene& rays;  // of mesh.meshes()
    std::span<const BounceMaterial> materials;
    std::span<const f32::Harmonics> blocked;  // of every point
    const HitTable& hits;
    int count = 0;  // rays a point
};

class BounceLight {
  public:
    // Finds the light that reaches every point from the environment and the lights.
    // `bounces`: how often bounce() will be called, which shares its rays among the calls.
    BounceLight(const BounceScene& scene, const SceneLight& light, int bounces,
                const Progress& progress);

    // What blocks the view of every point, lit directly and by `before`, the surroundings of one reflection
    // less (empty: none).
    std::vector<f32::Surroundings> bounce(std::span<const f32::Surroundings> before,
                                          const Progress& progress) const;

    // Surroundings::sky of a point: 0 for the side of its normal, 1 for the other, where it is 1 unless the point is
    // double-sided.
    float sky_ratio(std::uint32_t point, std::size_t side) const;

  private:
    // Irradiance over pi of a side of a point.
    struct Direct {
        glm::vec3 sky{0.0f}, lamps{0.0f};
    };
    std::size_t sides_of(std::uint32_t point) const;
    glm::vec3 sky_at(std::uint32_t point, std::size_t side,
                     std::span<const EnvironmentLookup::SkyLamp> sky_lamps) const;
    glm::vec3 lamps_at(std::uint32_t point, std::size_t side, const SceneLight& light) const;
    glm::vec3 radiance_of(const RayHit& hit, const glm::vec3& direction,
                          std::span<const f32::Surroundings> before) const;
    f32::Surroundings surroundings_of(std::uint32_t point,
                                      std::span<const f32::Surroundings> before) const;

    BounceScene scene_;
    EnvironmentLookup environment_;
    std::vector<glm::vec3> directions_;
    std::size_t step_ = 1;  // of the blocked rays of a point, one in so many carries light
    std::array<std::vector<Direct>, 2>
        direct_;  // of the sides of every point; the second of double-sided ones
};

}  // namespace burnish
