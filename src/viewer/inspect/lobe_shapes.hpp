// Shapes of a lobe to draw: D on the disk of half vectors, the lobe in space, polar cuts.
//
// Directions are unit, in the tangent frame of the point.
//
// Threads: functions of their arguments.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "burnish/image.hpp"
#include "viewer/inspect/point_lobe.hpp"

namespace burnish::viewer {

// D over the disk of (h_x, h_y), both -1 to 1: h_x to the right, row 0 at h_y = 1.
struct LobeDisk {
    Image D;          // side x side, one channel; NaN outside the disk
    double most = 0;  // the largest of these and of D at the peak
    // Of a table: how the nearest cell is known, side x side; empty for other lobes.
    std::vector<std::optional<NdfOrigin>> origin;
};
// `side`: texels, at least 1. A lobe that is narrower than a texel may fall between them: its peak is
// put into the texel that holds it.
LobeDisk lobe_disk(const PointLobe& lobe, glm::dvec3 to_eye, int side = 65);

// The lobe of a light: vertices at f (n~.wi) (luminance) times the direction to the eye, per unit of
// irradiance of a surface that faces the light. The rows of the mesh are circles about the direction in which
// the lobe is brightest, denser there, so that a narrow lobe is met; below the horizon the radius is 0.
struct LobeMesh {
    int rows = 0, columns = 0;
    std::vector<glm::vec3> vertices;       // rows x columns, row 0 on the axis
    std::vector<std::uint32_t> triangles;  // three indices each, counter-clockwise from outside
    double most = 0;                       // the largest radius
};
LobeMesh lobe_mesh(const PointLobe& lobe, glm::dvec3 to_light, glm::dvec3 to_eye, int rows = 64,
                   int columns = 128);

// Radii of f (n~.wi) (luminance) in a plane through the lobe, by angle.
struct PolarPoint {
    double angle_rad = 0;
    double radius = 0;
};
struct PolarCuts {
    // In the plane of the light and n~: angles from n~, positive on the side away from the light, -pi/2 to
    // pi/2.
    std::vector<PolarPoint> incidence;
    // In the plane across it through the mirror direction of the peak: angles from that direction.
    std::vector<PolarPoint> across;
    double light_angle_rad = 0;  // of the light in `incidence`, not positive
    double most = 0;             // the largest radius of both
};
PolarCuts polar_cuts(const PointLobe& lobe, glm::dvec3 to_light, glm::dvec3 to_eye);

}  // namespace burnish::viewer
