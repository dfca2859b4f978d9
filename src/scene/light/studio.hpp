// The built-in photo studio: soft boxes in a dim room, computed, not photographed.
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "burnish/scene.hpp"

namespace burnish {

// A rectangular soft box that faces the origin.
struct SoftBox {
    glm::vec3 towards;  // from the origin to its middle; any length
    float width_deg;    // angles it fills, 1..170
    float height_deg;
    float roll_deg;      // turn about the line of sight, counter-clockwise seen from the origin
    float corner;        // 0 square .. 1 round, share of the shorter half side
    float softness;      // 0 sharp .. 1, share of the shorter half side over which the rim fades
    glm::vec3 radiance;  // in its middle; it falls to `rim` of that at the edge
    float rim;
};

// Lat-long map (Environment's convention) of the room and the boxes, every edge at least two texels
// soft so that it stays smooth when the map is filtered.
Image render_studio(int width, int height, std::span<const SoftBox> boxes, bool room);

// The direction at which texel coordinates (u, v) in [0,1]^2 of a lat-long map look.
glm::vec3 direction_of(double u, double v);

Environment make_studio();

}  // namespace burnish
