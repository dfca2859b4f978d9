// The maths of shading/ in double precision: namespace burnish::f64.
#pragma once

#include "shading/prelude.hpp"

namespace burnish::f64 {

using namespace dialect;  // NOLINT: the dialect's words are meant to be here
using Float = double;
using Bool = bool;
using vec2 = Vec2<Float>;
using vec3 = Vec3<Float>;

// Enough for the Ward normaliser and the root of K11 Eq 5 to reach rounding error.
inline constexpr int kWardNodes = 48;
inline constexpr int kDeformRootSteps = 18;
// Cosines that BRDFs divide by are held above the one, and values and densities below the other:
// nothing becomes infinite at the horizon.
inline constexpr Float kLeastCosine = 1e-100;
inline constexpr Float kMostValue = 1e300;

// In this order.
// clang-format off
#include "shading/prelude_begin.hpp"
#include "shading/all.hpp"
#include "shading/prelude_end.hpp"
// clang-format on

}  // namespace burnish::f64
