// Material parameters put onto the materials of a scene.
#pragma once

#include <cstddef>

#include "burnish/parameters.hpp"
#include "burnish/scene.hpp"

namespace burnish {

// Puts the material parameters that are set in `values` onto every material of the scene, or onto
// the materials [first, first + count).
void apply_material_parameters(Scene& scene, const ParameterValues& values);
void apply_material_parameters(Scene& scene, std::size_t first, std::size_t count,
                               const ParameterValues& values);

// Throws UsageError when `values` says the roughness pair in two ways, named as keys or as flags.
void require_one_roughness(const ParameterValues& values, bool as_flags);

// Throws UsageError when `method` has nothing to act on: a deformation for a model without half
// vectors.
void require_drawable(Brdf brdf, Method method);

}  // namespace burnish
