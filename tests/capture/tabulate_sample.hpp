// Converts a simulated sample to the material of a perfect fit.
#pragma once

#include "burnish/tabulated_material.hpp"
#include "burnish/virtual_sample.hpp"

namespace burnish::test {

// Each distribution of the sample is an exemplar, tabulated at the cells of `grid` and scaled to a
// mass of 1; all other values are the sample's.
TabulatedMaterial tabulated(const VirtualSample& sample, const NdfGrid& grid);

}  // namespace burnish::test
