// What every vertex of a scene sees of its surroundings: found by rays, on the CPU, once a scene.
//
// A vertex keeps the share of each direction that the scene blocks as a function on the sphere
// (shading/surface/visibility.glsl), and the light that comes from what blocks it. Edges are split where the
// share changes fast between their ends, so that a table of two triangles shows the contact of what stands
// on it.
//
// Threads: a VisibilityFinder is used by one thread at a time; it works on all cores. Results may be read from
// any number of threads. Lifetime: a finder keeps nothing of the scene.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/mesh.hpp"
#include "burnish/prepared_environment.hpp"
#include "burnish/progress.hpp"
#include "burnish/scene.hpp"

namespace BURNISH_API burnish {

// One vertex, as it is uploaded: signed numbers of 16 bits, 32767 for 1.
struct VertexVisibility {
    // Coefficients of Harmonics in the order of its members.
    std::array<std::int16_t, 16> blocked{};
    // Surroundings: half floats of color, slope, and sky - 1 of the side of the normal and of the other.
    std::array<std::uint16_t, 8> around{};
};

struct InstanceVisibility {
    // The instance's mesh with split edges: its first vertices are those of the mesh. None: the mesh itself.
    std::shared_ptr<const Mesh> mesh;
    std::vector<VertexVisibility> vertices;  // one a vertex; empty: the instance sees everything
};

struct Visibility {
    std::vector<InstanceVisibility> instances;  // by the number of the instance
    std::vector<std::string> warnings;          // one line each
};

struct VisibilitySettings {
    int rays = 256;     // a vertex, 16 to 4096: more is smoother
    bool split = true;  // split edges where visibility changes fast
};

// What lights a scene, for the light that surfaces reflect to one another.
struct SceneLight {
    std::shared_ptr<const PreparedEnvironment> environment;  // none: dark
    float intensity = 1.0f;                                  // of the environment
    float rotation = 0.0f;                                   // radians about +y
    std::span<const Light> lights;
};

// The scene with the mean color of each texture in place of its texels, which is all that a finder reads of them:
// for a finder on a thread of its own.
Scene scene_for_visibility(const Scene& scene);

class VisibilityFinder {
  public:
    // Finds what the vertices see. Surfaces that blend block nothing, masked ones block with all of their
    // triangles. An instance that sees nothing at all, as its normals point inwards or it is closed in, is
    // left to see everything, and a warning says so. Large scenes get fewer rays, so that the time is
    // bounded. Throws Error for settings out of range, Interrupted when `progress` is cancelled.
    VisibilityFinder(const Scene& scene, const VisibilitySettings& settings,
                     const Progress& progress = {});
    ~VisibilityFinder();
    VisibilityFinder(VisibilityFinder&&) noexcept;
    VisibilityFinder& operator=(VisibilityFinder&&) noexcept;

    // The materials that light is reflected by from now on, in the order of the scene's. Which surfaces block is
    // not changed.
    void set_materials(std::span<const Material> materials, std::span<const Texture> textures);

    // Without the light of surroundings.
    std::shared_ptr<const Visibility> visibility() const;
    // With the light that `bounces` reflections (0 to 8) bring from what blocks the view. Materials reflect
    // with their mean color, and highlights by the environment alone.
    std::shared_ptr<const Visibility> lit(const SceneLight& light, int bounces,
                                          const Progress& progress = {});
    // Rays that were traced for the visibility, for measurements.
    std::size_t rays() const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace burnish
