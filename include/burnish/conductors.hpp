// Measured metals: complex indices of refraction at R, G and B for exact conductor Fresnel.
//
// Threads: any number may call these functions at a time. Lifetime: what they return is static.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <string_view>

#include "burnish/api.hpp"
#include "burnish/conductor.hpp"

namespace BURNISH_API burnish {

// gold silver copper aluminium steel brass titanium
std::span<const std::string_view> conductor_names();

// Index of refraction n + ik at 650, 550 and 450 nm. Throws UsageError, with the nearest name, for
// a metal that is not in the list.
Conductor conductor_preset(std::string_view name);

// The name of the preset with these numbers; empty when there is none.
std::string_view conductor_name(const Conductor& conductor);

// Reflectance at normal incidence, ((n-1)^2 + k^2) / ((n+1)^2 + k^2) per channel.
glm::vec3 normal_reflectance(const Conductor& conductor);

}  // namespace burnish
