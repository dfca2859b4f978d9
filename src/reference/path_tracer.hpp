// Paths from the eye through a scene: the radiance of a pixel, a sample at a time. docs/theory/tracer.md says what is
// computed and how it is sampled.
//
// Threads: immutable; any number may take samples. Lifetime: refers to the scene.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>

#include "burnish/render_settings.hpp"
#include "burnish/scene.hpp"
#include "reference/ground_shadow.hpp"
#include "reference/lamps.hpp"
#include "reference/owen_points.hpp"
#include "reference/sky.hpp"
#include "reference/traced_scene.hpp"
#include "scene/camera/view.hpp"

namespace burnish {

// What a path brings. World space, meters.
struct PathSample {
    glm::vec3 radiance{0.0f};  // times the coverage
    float coverage = 1.0f;     // 0 where a transparent background is seen
    // Of the first surface, where there is one.
    bool meets_surface = false;
    glm::vec3 albedo{
        0.0f};  // its mean over samples is the share of constant light that is reflected
    glm::vec3 normal{0.0f};  // n~, unit
    glm::vec3 grain{0.0f};   // along the grooves, unit, either way; 0: isotropic
    float depth = 0.0f;      // along the axis of the camera
};

class PathTracer {
  public:
    // `reflections`: of light between surfaces, 0: lights and environment alone. Of the settings, those count that
    // are not of one renderer. Throws Error for a scene or a camera that cannot be drawn.
    PathTracer(const Scene& scene, const Environment& environment, const Camera& camera,
               const RenderSettings& settings, int reflections, bool layers = false);

    PathTracer(const PathTracer&) = delete;
    PathTracer& operator=(const PathTracer&) = delete;

    // Sample `number` of a pixel: the same whenever and wherever it is asked for. Row 0 at the top.
    PathSample sample(int x, int y, std::uint32_t number) const;

    int width() const { return settings_.width; }
    int height() const { return settings_.height; }

  private:
    struct Vertex {
        const SurfaceHit& hit;
        PointSurface surface;
        int depth = 0;
    };
    // A ray, and how it was drawn.
    struct Walk {
        Ray ray;
        RayCone cone;
        glm::vec3 weight{1.0f};
        glm::vec3 sky_weight{1.0f};  // for light of the environment, which occlusion maps darken
        float pdf = 0.0f;            // of the direction, per steradian
        int depth = 0;               // surfaces before
        // The direction that was drawn. Where it leads into the surface, as a perturbed normal may have it, the ray goes
        // along its mirror image: docs/theory/tracer.md.
        glm::vec3 drawn{0.0f};
        bool below = false;
    };
    Walk start(int x, int y, const std::array<float, 4>& xi) const;
    std::optional<glm::vec3> emitter_seen(const Walk& walk, const std::optional<RayHit>& hit) const;
    void put_background(const Walk& walk, const std::array<float, 4>& xi, PathSample& out,
                        const PathPoints& points) const;
    std::optional<RayHit> surface_on(const Walk& walk, const PathPoints& points) const;
    glm::vec3 lights_met(const Walk& walk, const std::optional<RayHit>& hit) const;
    void note_first(const Vertex& vertex, PathSample& out) const;

    glm::vec3 lit(const Vertex& vertex, const PathPoints& points) const;
    glm::vec3 lit_by(const Vertex& vertex, std::size_t light, const glm::vec2& xi) const;
    glm::vec3 lit_by_punctual(const Vertex& vertex, const PunctualLight& light) const;
    glm::vec3 lit_by_area(const Vertex& vertex, const AreaLamp& light, const glm::vec2& xi) const;
    glm::vec3 lit_by_sky(const Vertex& vertex, const glm::vec2& xi) const;
    std::size_t light_count() const;
    float chosen_from(int depth) const;  // lights of which a vertex takes one
    glm::vec3 left_by_occlusion(const PointSurface& surface, const glm::vec3& wi,
                                const glm::vec3& reflected) const;
    bool go_on(const Vertex& vertex, Walk& walk, PathSample& out, const PathPoints& points) const;

    RenderSettings settings_;
    int reflections_;
    bool layers_;
    TracedScene scene_;
    Lamps lamps_;
    Sky sky_;
    std::optional<GroundShadow> ground_;
    CameraBasis camera_;
    bool orthographic_ = false;
    float pixel_ = 1.0f;  // its side, on the plane at distance 1 or in meters
    glm::vec3 step_right_{0.0f}, step_up_{0.0f};  // from pixel to pixel, likewise
    glm::vec3 forward_{0.0f}, eye_{0.0f};
};

}  // namespace burnish
