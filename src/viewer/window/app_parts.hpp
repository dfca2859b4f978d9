// Functions that the sources of the window share.
//
// Threads: functions of their arguments.
#pragma once

#include <chrono>

#include "burnish/scene.hpp"

namespace burnish::viewer {

inline double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Degrees, 1 to 170. An orthographic camera that is moved becomes a perspective one that sees the same height at its
// target.
double fov_deg_of(const Camera& camera);

}  // namespace burnish::viewer
