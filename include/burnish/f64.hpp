// The maths of shading/ in double precision: namespace burnish::f64.
#pragma once

#include "shading/precision.hpp"
#include "shading/prelude.hpp"

namespace burnish::f64 {

using namespace dialect;  // NOLINT: the dialect's words are meant to be here
using Float = double;
using Bool = bool;
using vec2 = Vec2<Float>;
using vec3 = Vec3<Float>;

inline constexpr int kWardNodes = dialect::Precision<Float>::ward_nodes;
inline constexpr int kDeformRootSteps = dialect::Precision<Float>::deform_root_steps;
inline constexpr Float kLeastCosine = dialect::Precision<Float>::least_cosine;
inline constexpr Float kMostValue = dialect::Precision<Float>::most_value;

// In this order.
// clang-format off
#include "shading/prelude_begin.hpp"
#include "shading/all.hpp"
#include "shading/prelude_end.hpp"
// clang-format on

}  // namespace burnish::f64
