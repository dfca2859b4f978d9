// Lights with an area: where they lie and how much they emit.
#pragma once

#include <glm/vec3.hpp>

#include "burnish/scene.hpp"

namespace burnish {

// Half the sides of a rectangle or of the rectangle around an ellipse: x cross y points the way `direction`
// does. Of a tube: x is half its axis, y any radius perpendicular to it. An `up` along `direction`, or 0,
// counts as any other.
struct AreaAxes {
    glm::vec3 x, y;
};
AreaAxes area_axes(const Light& light);

// Square meters that emit, both sides of a light with two. Of a tube its side without the ends.
double emitting_area(const Light& light);

// How the power of a light with an area is stated.
enum class PowerUnit { radiance, lumens, watts };

// The radiance, in candela per square meter, that a light of this area emits at this power: the flux in
// lumens over pi and the area, as a surface that emits the same in all directions has it. Watts are radiant
// watts of light that the eye sees best, 683 lumens each, as the lumen is defined.
double radiance_of_power(const Light& light, PowerUnit unit, double power);

}  // namespace burnish
