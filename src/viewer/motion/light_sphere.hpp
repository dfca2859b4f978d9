// Lights on the sphere of directions: dragging, and the light that puts a highlight at a point.
// scene/camera/angles.hpp has azimuth and elevation, as parse_light reads them.
//
// Directions are unit, in world space, from the surface to the light: the negative of Light::direction.
//
// Threads: functions of their arguments.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "burnish/scene.hpp"
#include "viewer/inspect/pick.hpp"

namespace burnish::viewer {

// Direction of a light as seen from `point`.
glm::dvec3 towards_light(const Light& light, glm::dvec3 point);

// The direction after a drag (pixels, y down), as if it were fixed to a ball that the camera sees from
// in front: the side of the ball that faces the camera follows the cursor. A drag as long as the window
// is high is half a turn: from the middle of the front to the middle of the back.
glm::dvec3 dragged_direction(const Camera& camera, glm::dvec3 to_light, glm::dvec2 drag_px,
                             int height_px);
// The light after the same drag about `pivot`. A point or spot light keeps its distance from the pivot,
// and a spot light turns with it.
Light dragged_light(const Camera& camera, const Light& light, glm::dvec3 pivot, glm::dvec2 drag_px,
                    int height_px);

// Where a ball that the camera sees shows a direction, for a picture of the ball to drag on.
struct BallPlace {
    glm::dvec2 at{0.0};  // within the unit disk, x to the right, y upwards
    bool front = true;   // on the half of the ball that faces the camera
};
BallPlace place_on_ball(const Camera& camera, glm::dvec3 direction);
// The direction at a place; outside the disk: of its nearest point.
glm::dvec3 direction_on_ball(const Camera& camera, const BallPlace& place);

// The direction of the light whose highlight is at the hit: the eye mirrored about the half vector at which
// the material's lobe (PointLobe::peak) is highest. `to_eye`: unit, world. None: the light would be
// below the horizon of the surface or of its perturbed normal, the hit shows a hole of a cloth or a
// texel without measurement, or the model has no meaning under the method.
std::optional<glm::dvec3> direction_for_highlight(const Scene& scene, const Hit& hit,
                                                  glm::dvec3 to_eye);
std::optional<glm::dvec3> direction_for_highlight(const Scene& scene, const Hit& hit,
                                                  glm::dvec3 to_eye, Method method);

// `light` so placed. A directional light turns. A point or spot light keeps its distance from the hit,
// and a spot light points at it.
std::optional<Light> light_for_highlight(const Scene& scene, const Hit& hit, glm::dvec3 to_eye,
                                         const Light& light);

}  // namespace burnish::viewer
