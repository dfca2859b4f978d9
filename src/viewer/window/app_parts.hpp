// Functions that the sources of App share.
//
// Threads: functions of their arguments.
#pragma once

#include "burnish/scene.hpp"

namespace burnish::viewer {

// Degrees, 1 to 170. An orthographic camera that is moved becomes a perspective one that sees the same height at its
// target.
double fov_deg_of(const Camera& camera);

}  // namespace burnish::viewer
