// Finds the direction of a light from the picture of a mirror ball. The highlight's position gives
// the normal there, which bisects the view and light directions.
//
// The view is orthographic along -z: the camera is far away, or the ball is near the optical axis.
// Directions are those of the picture: +x right, +y up, +z towards the camera. If the camera is on
// the sample's normal they equal those of sample space; otherwise from_picture converts them.
#pragma once

#include <string>

#include "burnish/image.hpp"
#include "burnish/rig.hpp"

namespace burnish {

// Outline of the ball in pixels: (0, 0) is the top left corner of the top left pixel, whose center
// is (0.5, 0.5); y points down. Programs that number pixel centers from 1 give values larger by
// 0.5.
struct ProbeCircle {
    double x = 0.0, y = 0.0, radius = 0.0;
};

struct ProbeLight {
    Vec3d direction{};        // unit, z > 0
    double x = 0.0, y = 0.0;  // centroid of the highlight, in the pixels of ProbeCircle
    double spread_deg = 0.0;  // root mean square angle between the highlight's directions and
                              // `direction`: about half the lamp's angular size
    double second = 0.0;      // ratio of the weights of the second brightest and the brightest
                              // spot, 0..1: near 1 the ball shows two lamps
};

// The direction that a ball reflects towards the camera at (x, y), inside the outline.
Vec3d probe_reflection(const ProbeCircle& circle, double x, double y);

// Transforms a direction of the picture to sample space, for a camera in the direction `camera`
// (unit, z > 0) whose picture shows the sample's y axis pointing straight up.
Vec3d from_picture(const Vec3d& direction, const Vec3d& camera);

// `image` holds linear values, 1, 3 or 4 channels. Searches for the brightest spot where the ball
// reflects directions with z > 0. Throws Error naming `name` for a circle that misses the picture
// or is less than 4 pixels in radius, and for a ball without a highlight.
ProbeLight light_from_probe(const Image& image, const ProbeCircle& circle, const std::string& name);

}  // namespace burnish
