// Where a light stood, from the picture of a mirror ball: the highlight's place on the ball tells
// the normal there, which lies halfway between the view and the light.
//
// The view is orthographic along -z: the camera is far away, or the ball is near the optical axis.
// Directions are those of the picture: +x right, +y up, +z towards the camera. They are those of
// sample space where the camera is on the normal; else from_picture takes them there.
#pragma once

#include <string>

#include "burnish/image.hpp"
#include "burnish/rig.hpp"

namespace burnish {

// Outline of the ball in pixels: (0, 0) is the top left corner of the top left pixel, whose centre
// is (0.5, 0.5); y points down. Programs that count pixel centres from 1 say 0.5 more.
struct ProbeCircle {
    double x = 0.0, y = 0.0, radius = 0.0;
};

struct ProbeLight {
    Vec3d direction{};        // unit, z > 0
    double x = 0.0, y = 0.0;  // centroid of the highlight, in the pixels of ProbeCircle
    double spread_deg = 0.0;  // root mean square angle between the highlight's directions and
                              // `direction`: half the lamp's size, roughly
    double second = 0.0;      // weight of the second brightest spot by that of the first, 0..1:
                              // near 1 the ball shows two lamps
};

// The direction that a ball reflects towards the camera at (x, y), inside the outline.
Vec3d probe_reflection(const ProbeCircle& circle, double x, double y);

// A direction of the picture in sample space, for a camera in the direction `camera` (unit, z > 0)
// that is held so that the sample's y axis points straight up in the picture.
Vec3d from_picture(const Vec3d& direction, const Vec3d& camera);

// `image` holds linear values, 1, 3 or 4 channels. The brightest spot is looked for where the ball
// shows directions with z > 0. Throws Error naming `name` for a circle that misses the picture or
// is less than 4 pixels in radius, and where nothing on the ball stands out.
ProbeLight light_from_probe(const Image& image, const ProbeCircle& circle, const std::string& name);

}  // namespace burnish
