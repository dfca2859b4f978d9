#include "gpu/upload/lights.hpp"

#include <algorithm>
#include <functional>
#include <glm/geometric.hpp>
#include <string>

#include "burnish/error.hpp"
#include "burnish/f32.hpp"
#include "scene/light/punctual_lights.hpp"

namespace burnish::gpu {
LightUniforms::LightUniforms(std::span<const Light> lights) {
    const auto punctual = static_cast<std::size_t>(
        std::count_if(lights.begin(), lights.end(), std::not_fn(has_area)));
    if (punctual > kMostLights) {
        throw Error("scene", "lights", "at most " + std::to_string(kMostLights),
                    std::to_string(punctual));
    }
    for (const Light& light : lights) {
        if (has_area(light)) continue;
        const PunctualValues values = punctual_values(light);
        any_positional_ = any_positional_ || values.place.w > 0.0f;
        place_.push_back(values.place);
        radiance_.emplace_back(light.color * light.intensity, values.inverse_range2);
        direction_.emplace_back(values.axis, 0.0f);
        cone_.push_back(values.cone);
    }
}

glm::vec3 LightUniforms::irradiance(int light, const glm::vec3& position) const {
    const auto i = static_cast<std::size_t>(light);
    const glm::vec3 away = glm::vec3(place_[i]) - place_[i].w * position;
    return glm::vec3(radiance_[i]) / std::max(glm::dot(away, away), f32::kLeastDistance2);
}

void LightUniforms::set(Program& program) const {
    program.set("u_light_count", count());
    program.set("u_light_place", std::span<const glm::vec4>(place_));
    program.set("u_light_radiance", std::span<const glm::vec4>(radiance_));
    program.set("u_light_direction", std::span<const glm::vec4>(direction_));
    program.set("u_light_cone", std::span<const glm::vec2>(cone_));
}

}  // namespace burnish::gpu
