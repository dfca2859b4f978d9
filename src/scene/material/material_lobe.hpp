// The lobe that a material's numbers describe, without regard to its textures.
#pragma once

#include <glm/vec2.hpp>

#include "burnish/f32.hpp"
#include "burnish/scene.hpp"

namespace burnish {

// The lobe of a material; that of cloth is widened by its fuzz.
f32::Lobe lobe_of(const Material& material);

// The roughness pair (alpha_x, alpha_y) of a material, at least 0.001 as in the shaders.
glm::vec2 alpha_of(const Material& material);

}  // namespace burnish
