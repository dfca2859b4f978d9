// Estimates the normal of a point from its diffuse light: photometric stereo (Woodham 1980).
#pragma once

#include "capture/stack/light_geometry.hpp"

namespace burnish {

// The normal of the Lambertian surface that explains most of a point's samples, at most kMostTilt
// from +z. Samples that are brighter than that surface by more than usual, highlights, are left out
// round by round. `samples`: in the frame of +z, as gathered for a flat point. Returns +z with fewer
// than 4 samples, for a point without diffuse light, and where the directions of its lights do not
// determine a normal.
Vec3f shading_normal(const PointSamples& samples);

}  // namespace burnish
