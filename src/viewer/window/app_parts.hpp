// Functions that the sources of App share.
//
// Threads: functions of their arguments.
#pragma once

#include "viewer/document/document.hpp"

namespace burnish::viewer {

// Degrees, 1 to 170. An orthographic camera that is moved becomes a perspective one that sees the same height at its
// target.
double fov_deg_of(const Camera& camera);

// `held` under the camera, the lights, the environment and the settings of `now`.
Document seen_as(const Document& held, const Document& now);

}  // namespace burnish::viewer
