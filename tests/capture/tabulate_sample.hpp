// A simulated sample as the material that a perfect fit would find.
#pragma once

#include "burnish/tabulated_material.hpp"
#include "burnish/virtual_sample.hpp"

namespace burnish::test {

// Each distribution of the sample is an exemplar, tabulated at the cells of `grid` and scaled to a
// mass of 1; the rest is the sample's.
TabulatedMaterial tabulated(const VirtualSample& sample, const NdfGrid& grid);

}  // namespace burnish::test
