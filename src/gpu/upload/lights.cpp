#include "gpu/upload/lights.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <string>

#include "burnish/error.hpp"
#include "burnish/f32.hpp"

namespace burnish::gpu {
namespace {

glm::vec3 unit_or(const glm::vec3& v, const glm::vec3& fallback) {
    const float l = glm::length(v);
    return l > 0.0f && std::isfinite(l) ? v / l : fallback;
}

glm::vec2 cone_of(const Light& light) {
    if (light.type != LightType::spot) return {0.0f, 1.0f};
    const f32::vec2 cone = f32::spot_cone(std::cos(light.inner_cone), std::cos(light.outer_cone));
    return {cone.x, cone.y};
}

}  // namespace

LightUniforms::LightUniforms(std::span<const Light> lights) {
    const auto punctual = static_cast<std::size_t>(
        std::count_if(lights.begin(), lights.end(), std::not_fn(has_area)));
    if (punctual > kMostLights) {
        throw Error("scene", "lights", "at most " + std::to_string(kMostLights),
                    std::to_string(punctual));
    }
    for (const Light& light : lights) {
        if (has_area(light)) continue;
        const glm::vec3 travel = unit_or(light.direction, glm::vec3(0, 0, -1));
        const bool directional = light.type == LightType::directional;
        any_positional_ = any_positional_ || !directional;
        const bool bounded = !directional && light.range > 0.0f;
        place_.push_back(directional ? glm::vec4(-travel, 0.0f) : glm::vec4(light.position, 1.0f));
        radiance_.emplace_back(light.color * light.intensity,
                               bounded ? 1.0f / (light.range * light.range) : 0.0f);
        direction_.emplace_back(travel, 0.0f);
        cone_.push_back(cone_of(light));
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
