#include "scene/light/punctual_lights.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "burnish/f32.hpp"

namespace burnish {

glm::vec3 unit_or(const glm::vec3& v, const glm::vec3& other) {
    const float length = glm::length(v);
    return length > 0.0f && std::isfinite(length) ? v / length : other;
}

glm::vec3 travel_of(const Light& light) {
    return unit_or(light.direction, glm::vec3(0, 0, -1));
}

PunctualValues punctual_values(const Light& light) {
    PunctualValues values;
    values.axis = travel_of(light);
    const bool directional = light.type == LightType::directional;
    values.place = directional ? glm::vec4(-values.axis, 0.0f) : glm::vec4(light.position, 1.0f);
    const bool bounded = !directional && light.range > 0.0f;
    values.inverse_range2 = bounded ? 1.0f / (light.range * light.range) : 0.0f;
    values.cone = {0.0f, 1.0f};
    if (light.type == LightType::spot) {
        const f32::vec2 cone =
            f32::spot_cone(std::cos(light.inner_cone), std::cos(light.outer_cone));
        values.cone = {cone.x, cone.y};
    }
    return values;
}

}  // namespace burnish
