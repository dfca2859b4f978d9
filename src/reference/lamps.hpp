// The lights of a scene for paths: punctual ones by shading/surface/light.glsl, those with an area by points of them.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "burnish/scene.hpp"
#include "scene/light/punctual_lights.hpp"

namespace burnish {

// A light without an area at a point.
struct PunctualLight {
    PunctualValues values;
    glm::vec3 color{0.0f};  // times intensity
    bool directional = false;

    struct AtPoint {
        glm::vec3 direction{0.0f};   // towards the light, unit
        glm::vec3 irradiance{0.0f};  // of a surface that faces it
        float distance = 0.0f;       // 0: infinitely far
    };
    AtPoint at(const glm::vec3& position) const;
};

// A light with an area.
class AreaLamp {
  public:
    explicit AreaLamp(const Light& light);

    struct Seen {
        glm::vec3 direction{0.0f};  // towards it, unit
        float distance = 0.0f;
        glm::vec3 radiance{0.0f};
        float pdf = 0.0f;  // of `sample`, per steradian
    };
    // A point of the light as seen from a position; none where it does not emit that way.
    std::optional<Seen> sample(const glm::vec3& position, const glm::vec2& xi) const;
    // Where a ray meets it on a side that emits.
    std::optional<Seen> met_by(const glm::vec3& origin, const glm::vec3& direction) const;
    bool is_visible() const { return visible_; }
    glm::vec3 plain_radiance() const { return radiance_; }  // without its texture
    // Irradiance over pi of a surface with this unit normal under a radiance of 1, without shadow.
    float cosine_share(const glm::vec3& position, const glm::vec3& normal) const;

  private:
    glm::vec3 radiance_at(const glm::vec2& place) const;  // in half sides from the middle
    std::optional<Seen> sample_flat(const glm::vec3& position, const glm::vec2& xi) const;
    std::optional<Seen> sample_tube(const glm::vec3& position, const glm::vec2& xi) const;
    std::optional<Seen> flat_met_by(const glm::vec3& origin, const glm::vec3& direction) const;
    std::optional<Seen> tube_met_by(const glm::vec3& origin, const glm::vec3& direction) const;

    Light light_;
    glm::vec3 x_{0.0f}, y_{0.0f};  // half the sides (area_axes)
    glm::vec3 radiance_{0.0f};
    bool visible_ = true;
};

struct Lamps {
    explicit Lamps(std::span<const Light> lights);
    std::vector<PunctualLight> punctual;
    std::vector<AreaLamp> areas;
};

}  // namespace burnish
