// Material parameters laid over one material.
#pragma once

#include "burnish/material_assets.hpp"
#include "burnish/parameters.hpp"
#include "burnish/scene.hpp"

namespace burnish {

// The material that `base` becomes under the material parameters set in `values`. A pure function:
// equal arguments give equal results, and without values the result is `base`. MaterialAssets::load
// has been given `values` before. The result keeps what its kind of lobe does not read
// (drawn_material). Throws UsageError for values that contradict each other.
Material apply_parameters(const Material& base, const ParameterValues& values,
                          const MaterialAssets& assets);

// The pair (alpha_x, alpha_y) that `values` state as alphas, exponents or a cosine exponent; none
// when they state none. One alone states both, but the other one is that of `base` if it has one.
std::optional<glm::vec2> roughness_pair(const ParameterValues& values,
                                        const std::optional<glm::vec2>& base);

// Throws UsageError when `method` has nothing to act on: a deformation for a model without half
// vectors.
void require_drawable(const Material& material, Method method);

}  // namespace burnish
