// burnish capture directions: a rig from pictures of mirror balls (docs/guide/capture.md).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "burnish/progress.hpp"
#include "burnish/rig.hpp"
#include "capture/rig/light_probe.hpp"

namespace burnish {

struct CaptureDirectionsRequest {
    std::vector<std::filesystem::path> balls;  // pictures of the balls, a light each
    std::vector<ProbeCircle> circles;          // the balls in every one of them; at least one
    // Of the sample, in the same order; empty: the balls lie beside the sample.
    std::vector<std::filesystem::path> pictures;
    // `response`: of the sample's pictures. `camera`: a direction. None: what the pictures usually
    // are, a camera on the normal, a sample of 1 mm a pixel.
    RigOverrides rig;
    std::filesystem::path output;  // .json or .lp
};

// What the balls of one picture say of its light.
struct FoundDirection {
    std::filesystem::path picture;
    Vec3d direction{};        // unit, in the sample's coordinates
    double spread_deg = 0.0;  // of the highlight about its direction; the largest of the balls
    double apart_deg = 0.0;   // largest angle between the directions of two balls; 0 for one ball
};

struct CaptureDirectionsResult {
    std::vector<FoundDirection> lights;
    std::vector<std::string> warnings;
    std::vector<std::filesystem::path> written;
};

// Writes the rig, whole or not at all. Throws UsageError for another ending of `output`, for a
// size, response or camera that an .lp file cannot say, and where there are not as many pictures as
// lights; Error naming the picture for what cannot be read or shows no lamp.
CaptureDirectionsResult capture_directions(const CaptureDirectionsRequest& request,
                                           const Progress& progress);

}  // namespace burnish
