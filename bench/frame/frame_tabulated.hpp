// Measured materials for the frame bench, made of analytic lobes: what a measured one costs to
// draw, without a file.
#pragma once

#include "burnish/tabulated_material.hpp"

namespace burnish {

// Four exemplars on the default grid and 64 x 64 texels: neighbours differ in exemplar, the grain
// turns smoothly, normals are tilted a little.
TabulatedMaterial bench_material_of_texels();

// The first of those exemplars, on one texel.
TabulatedMaterial bench_material_of_one();

}  // namespace burnish
