// Compares pictures in tests. A failed comparison writes both pictures and their difference to the
// folder failed_pictures of the build, and the message names it.
#pragma once

#include <gtest/gtest.h>

#include "burnish/image.hpp"

namespace burnish::test {

// Largest difference of two linear pictures of one size, relative to the larger of the value and
// `floor`.
double largest_difference(const Image& a, const Image& b, double floor);

// Passes if largest_difference is below `tolerance`.
testing::AssertionResult close_pictures(const Image& found, const Image& wanted, double floor,
                                        double tolerance);

// Passes if no value differs by more than `tolerance` times the larger of 1 and the value. The
// default is four roundings of a float: drivers compile a shader for its first state, and two
// compilations may round differently.
testing::AssertionResult equal_pictures(const Image& found, const Image& wanted,
                                        double tolerance = 5e-7);

}  // namespace burnish::test
