// Applies material parameters to one material.
#pragma once

#include "burnish/material_assets.hpp"
#include "burnish/parameters.hpp"
#include "burnish/scene.hpp"

namespace burnish {

// Applies the material parameters set in `values` to `base`. A pure function: equal arguments give
// equal results, and without values the result is `base`. MaterialAssets::load must have received
// `values` before. The result keeps properties that its kind of lobe does not read
// (drawn_material). Throws UsageError for contradictory values.
Material apply_parameters(const Material& base, const ParameterValues& values,
                          const MaterialAssets& assets);

// The pair (alpha_x, alpha_y) that `values` contain as alphas, exponents or a cosine exponent; none
// without these. A single half sets both, unless `base` supplies the other half.
std::optional<glm::vec2> roughness_pair(const ParameterValues& values,
                                        const std::optional<glm::vec2>& base);

// Whether scratch_direction turns the grooves of the lobe along the scratches.
bool follows_scratches(const ParameterValues& values);

// Throws UsageError when `method` does not apply: a deformation with a model without half vectors.
void require_drawable(const Material& material, Method method);

}  // namespace burnish
