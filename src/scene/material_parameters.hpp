// Putting material parameters onto some of a scene's materials.
#pragma once

#include <cstddef>

#include "burnish/parameters.hpp"
#include "burnish/scene.hpp"

namespace burnish {

// As apply_material_parameters of load.hpp, for the materials [first, first + count).
void apply_material_parameters(Scene& scene, std::size_t first, std::size_t count,
                               const ParameterValues& values);

}  // namespace burnish
