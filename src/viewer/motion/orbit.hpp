// Moves of a camera by hand: turntable, pan, zoom and frame.
//
// Positions and drags are pixels of the picture: x runs to the right, y down, and (0, 0) is the outer
// corner of the first pixel, as window systems count. A window of several device pixels a unit may
// use either, as long as sizes and drags use the same. Distances are meters, angles radians.
//
// Every function returns the moved camera and leaves near and far planes as they are. A camera whose
// position is its target cannot be moved: Error, as make_view throws.
//
// Threads: functions of their arguments.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "burnish/mesh.hpp"
#include "burnish/scene.hpp"
#include "viewer/inspect/ray.hpp"

namespace burnish::viewer {

// The highest elevation of a turntable: short of the pole, where +y is no longer up.
inline constexpr double kHighestElevationDeg = 89.9;

// Turntable about +y through `pivot`: the camera keeps its distance from it. A drag to the right turns the
// model to the right, a drag down tips its top towards the eye. A drag as long as the window is high
// is a full turn. The horizon becomes level: a camera that a file has tilted loses its tilt.
Camera orbited(const Camera& camera, glm::dvec3 pivot, glm::dvec2 drag_px, int height_px);
// About the camera's target.
Camera orbited(const Camera& camera, glm::dvec2 drag_px, int height_px);
// By angles: the camera moves counter-clockwise as seen from above, and upwards.
Camera orbited_by(const Camera& camera, glm::dvec3 pivot, double azimuth_rad, double elevation_rad);

// Distance of a point from the camera along the direction of view.
double depth_of(const Camera& camera, glm::dvec3 point);

// Moves camera and target along the picture, so that points at `depth` follow the cursor. `depth` is
// without meaning for an orthographic camera.
Camera panned(const Camera& camera, glm::dvec2 drag_px, int height_px, double depth);
// Points at the depth of the target follow.
Camera panned(const Camera& camera, glm::dvec2 drag_px, int height_px);

// The point at the depth of the target that the cursor shows.
glm::dvec3 under_cursor(const Camera& camera, glm::dvec2 cursor_px, WindowSize window);

// Scales the distance to `fixed` by `factor` (> 0; below 1: nearer) without turning the camera, so that
// the place of `fixed` in the picture stays. An orthographic camera scales its height of view.
// zoomed(1/f) undoes zoomed(f). Returns the camera as it is for a distance that single precision
// cannot hold: below 1e-4 of the distance of `fixed` from the origin, or above 1e9.
Camera zoomed(const Camera& camera, double factor, glm::dvec3 fixed);
// Towards the cursor: about under_cursor.
Camera zoomed(const Camera& camera, double factor, glm::dvec2 cursor_px, WindowSize window);
// The factor for steps of a wheel, positive steps towards the model: 10 % a step.
double wheel_factor(double steps);

// The camera from its present direction, so that `bounds` fill the picture with the margin that
// place_camera has. `aspect`: width over height.
Camera framed(const Camera& camera, const Bounds& bounds, double aspect);

}  // namespace burnish::viewer
