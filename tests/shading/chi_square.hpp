// Chi-square of samples against their density, under the names that the tests use.
#pragma once

#include "lobes_under_test.hpp"
#include "verify/chi_square.hpp"

namespace burnish::test {

using verify::Density;
using verify::Draw;
using verify::sampler_p_value;

}  // namespace burnish::test
