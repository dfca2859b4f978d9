// Rays of pixels: the inverse of the projection of scene/camera/view.hpp.
//
// Pixels: x to the right, y down, (0, 0) the outer corner of the upper left pixel; its middle is (0.5,
// 0.5).
//
// Threads: functions of their arguments.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "burnish/scene.hpp"

namespace burnish::viewer {

struct WindowSize {
    int width = 0;   // pixels, at least 1
    int height = 0;  // pixels, at least 1
};

// Points origin + t direction, t from `from` to `to` meters.
struct Ray {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0, 0.0, -1.0};  // unit
    double from = 0;  // at the near plane; -infinity for an orthographic camera without one
    double to = 0;    // at the far plane; infinity without one

    glm::dvec3 at(double t) const { return origin + t * direction; }
};

// Throws Error for a camera without a view, as make_view does.
Ray ray_of(const Camera& camera, glm::dvec2 pixel, WindowSize window);

// Where the picture shows a point, inside or outside its frame; none behind the eye.
std::optional<glm::dvec2> pixel_of(const Camera& camera, glm::dvec3 point, WindowSize window);

}  // namespace burnish::viewer
