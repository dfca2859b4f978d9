// Tabulated materials for the frame bench, made of analytic lobes. They measure the cost of drawing
// measured materials without a file.
#pragma once

#include "burnish/tabulated_material.hpp"

namespace burnish {

// Four exemplars on the default grid and 64 x 64 texels: neighbors differ in exemplar, the grain
// rotates smoothly, normals tilt slightly.
TabulatedMaterial bench_material_of_texels();

// The first of those exemplars, on one texel.
TabulatedMaterial bench_material_of_one();

}  // namespace burnish
