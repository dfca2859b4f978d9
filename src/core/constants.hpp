// Numbers that every layer uses.
#pragma once

#include <numbers>

namespace burnish {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kHalfPi = kPi / 2;
inline constexpr double kTwoPi = 2 * kPi;
inline constexpr double kDegree = kPi / 180;  // radians in a degree
inline constexpr double kDegreesPerRadian = 180 / kPi;

}  // namespace burnish
