// Turntables: what stands and what turns in every frame.
//
// Threads: functions of their arguments. Lifetime: what they return refers to nothing else.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/scene.hpp"

namespace BURNISH_API burnish {

// What turns about the vertical axis through the camera's target, counter-clockwise as seen from
// above. The rest stands:
// - object: camera, lights and environment stand. The frame turns them all the other way about the
//   scene, which is the same picture.
// - light: lights and environment turn, camera and objects stand.
// - camera: the camera goes around, lights, environment and objects stand.
enum class Turn { object, light, camera };
std::span<const std::string_view> turn_names();  // in the order of the enumeration

// What a renderer is given for one frame, in place of the scene's.
struct TurntableFrame {
    Camera camera;
    std::vector<Light> lights;
    float environment_rotation = 0.0f;  // radians about +y
};

// Frame `index` of `count` (> 0) of a full turn. Frame 0 is the arguments as they are, and frame `count`
// would be frame 0 again. Only directions and places change: a picture of the frame has the framing,
// seed and size of every other.
TurntableFrame turntable_frame(const Camera& camera, std::span<const Light> lights,
                               float environment_rotation, Turn turn, int index, int count);

}  // namespace burnish
