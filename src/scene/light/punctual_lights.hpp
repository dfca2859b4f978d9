// Lights without an area as the values that shading/surface/light.glsl takes.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "burnish/scene.hpp"

namespace burnish {

// v at unit length; `other` where it has no finite length above 0.
glm::vec3 unit_or(const glm::vec3& v, const glm::vec3& other);

// The way the light travels, unit: along -z where its direction is none.
glm::vec3 travel_of(const Light& light);

// The arguments of light_at.
struct PunctualValues {
    glm::vec4 place{0.0f};  // position, 1; or towards a directional light, 0
    glm::vec3 axis{0.0f};   // travel_of
    glm::vec2 cone{0.0f};
    float inverse_range2 = 0.0f;
};
PunctualValues punctual_values(const Light& light);

}  // namespace burnish
