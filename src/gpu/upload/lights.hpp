// Punctual lights as uniforms of shaders/lib/lights.glsl.
#pragma once

#include <span>
#include <vector>

#include "burnish/scene.hpp"
#include "gpu/device/program.hpp"

namespace burnish::gpu {

inline constexpr std::size_t kMostLights = 16;

class LightUniforms {
  public:
    // Takes those of `lights` that have no area, in their order. Throws Error for more than kMostLights.
    explicit LightUniforms(std::span<const Light> lights);

    int count() const { return static_cast<int>(place_.size()); }
    bool any_positional() const { return any_positional_; }
    // Position and 1, or the direction towards a directional light and 0.
    const glm::vec4& place(int light) const { return place_[static_cast<std::size_t>(light)]; }
    // The irradiance on a surface at `position` that faces the light, without range and cone.
    glm::vec3 irradiance(int light, const glm::vec3& position) const;
    void set(Program& program) const;

  private:
    std::vector<glm::vec4> place_, radiance_, direction_;
    std::vector<glm::vec2> cone_;
    bool any_positional_ = false;
};

}  // namespace burnish::gpu
