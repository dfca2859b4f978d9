// The built-in photo studio: soft boxes in a dim room, computed.
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "burnish/scene.hpp"

namespace burnish {

// A rectangular soft box that faces the origin.
struct SoftBox {
    glm::vec3 towards;  // from the origin to its middle; any length
    float width_deg;    // angle it subtends, 1..170
    float height_deg;
    float roll_deg;  // rotation about the line of sight, counter-clockwise seen from the origin
    float corner;    // 0 square .. 1 round, fraction of the shorter half side
    float softness;  // 0 sharp .. 1, fraction of the shorter half side over which the edge fades
    glm::vec3 radiance;  // in its middle; at the edge `rim` times this
    float rim;
};

// Lat-long map (Environment's convention) of the room and the boxes. Every edge fades over at least
// two texels, so that filtering the map causes no aliasing.
Image render_studio(int width, int height, std::span<const SoftBox> boxes, bool room);

// The direction at the texture coordinates (u, v) in [0,1]^2 of a lat-long map.
glm::vec3 direction_of(double u, double v);

Environment make_studio();

}  // namespace burnish
