// An environment as a number of directional lights, for the shadow on a plane.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "burnish/scene.hpp"

namespace burnish {

struct SkyLight {
    glm::vec3 direction{0.0f, 1.0f, 0.0f};  // towards it: unit, y > 0, before any rotation
    glm::vec3 irradiance{0.0f};             // on the plane y = 0
};

// `count` lights of equal luminance that together give a horizontal plane the irradiance of the
// environment's upper half. Their density follows the irradiance. Stratified; the same at every
// call. Empty for an environment that is black above the horizon. Values below 0 or not finite
// count as 0.
std::vector<SkyLight> sky_lights(const Environment& environment, int count);

}  // namespace burnish
