// The maths of shading/ in float precision: namespace burnish::f32.
#pragma once

#include "shading/prelude.hpp"

namespace burnish::f32 {

using namespace dialect;  // NOLINT: the dialect's words are meant to be here
using Float = float;
using Bool = bool;
using vec2 = Vec2<Float>;
using vec3 = Vec3<Float>;

// Enough for the Ward normaliser and the root of K11 Eq 5 to reach rounding error.
inline constexpr int kWardNodes = 8;
inline constexpr int kDeformRootSteps = 14;
// Cosines that BRDFs divide by are held above the one, and values and densities below the other:
// nothing becomes infinite at the horizon.
inline constexpr Float kLeastCosine = 1e-12f;
inline constexpr Float kMostValue = 1e30f;

// In this order.
// clang-format off
#include "shading/prelude_begin.hpp"
#include "shading/all.hpp"
#include "shading/prelude_end.hpp"
// clang-format on

}  // namespace burnish::f32
