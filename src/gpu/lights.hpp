// Punctual lights as uniforms of shaders/lib/lights.glsl.
#pragma once

#include <vector>

#include "burnish/scene.hpp"
#include "gpu/program.hpp"

namespace burnish::gpu {

inline constexpr std::size_t kMostLights = 16;

class LightUniforms {
  public:
    // Throws Error for more than kMostLights lights.
    explicit LightUniforms(const std::vector<Light>& lights);

    int count() const { return static_cast<int>(place_.size()); }
    bool any_positional() const { return any_positional_; }
    void set(Program& program) const;

  private:
    std::vector<glm::vec4> place_, radiance_, direction_;
    std::vector<glm::vec2> cone_;
    bool any_positional_ = false;
};

}  // namespace burnish::gpu
