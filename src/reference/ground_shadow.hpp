// The shadow of a scene on a plane under it: what RenderSettings::ground asks for, as the renderer has it
// (src/gpu/draw/ground.hpp): what lies behind is multiplied by the share of its light that the plane keeps.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <optional>

#include "reference/lamps.hpp"
#include "reference/sky.hpp"
#include "reference/traced_scene.hpp"

namespace burnish {

// Threads: immutable. Lifetime: refers to the lights and the sky.
class GroundShadow {
  public:
    GroundShadow(const Bounds& model, const Lamps& lamps, const Sky& sky);

    // Four numbers in [0, 1) of group `number`.
    using Numbers = std::function<std::array<float, 4>(std::uint32_t number)>;
    // An estimate of the share of light that reaches the plane where the ray meets it, with every light sampled once;
    // none where it does not meet the part of the plane that is shown.
    std::optional<glm::vec3> left(const Ray& ray, const TracedScene& scene,
                                  const Numbers& numbers) const;

  private:
    glm::vec3 arriving(const glm::vec3& position) const;  // irradiance without the scene
    glm::vec3 blocked(const glm::vec3& position, const TracedScene& scene,
                      const Numbers& numbers) const;

    const Lamps& lamps_;
    const Sky& sky_;
    glm::vec3 center_{0.0f};
    float half_ = 1.0f;  // half the side of the square that is shown
};

}  // namespace burnish
