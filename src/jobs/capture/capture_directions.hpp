// burnish capture directions: makes a rig from pictures of mirror balls (docs/guide/capture.md).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "burnish/progress.hpp"
#include "burnish/rig.hpp"
#include "capture/rig/light_probe.hpp"

namespace burnish {

struct CaptureDirectionsRequest {
    std::vector<std::filesystem::path> balls;  // pictures of the balls, one for each light
    std::vector<ProbeCircle> circles;          // of the balls in every picture; one or more
    // Pictures of the sample, in the same order; empty: the pictures of the balls show the sample
    // too.
    std::vector<std::filesystem::path> pictures;
    // Of the pictures of the balls. None: that of the sample's pictures, where those of the balls
    // show it or are of its kind of file; else the usual one of their ending.
    std::optional<RigResponse> ball_response;
    // `response`: of the sample's pictures. `camera`: a direction. Defaults: the usual response of
    // the pictures, a camera on the normal, 1 mm per pixel.
    RigOverrides rig;
    std::filesystem::path output;  // .json or .lp
};

// The direction of one light from all balls of its picture.
struct FoundDirection {
    std::filesystem::path picture;
    Vec3d direction{};        // unit, in the sample's coordinates
    double spread_deg = 0.0;  // spread of the highlight about its direction, largest of the balls
    double apart_deg = 0.0;   // largest angle between the directions of two balls; 0 for one ball
};

struct CaptureDirectionsResult {
    std::vector<FoundDirection> lights;
    std::vector<std::string> warnings;
    std::vector<std::filesystem::path> written;
};

// Pictures that are missing are looked for in other letter case and with other endings, with a
// warning. Pixels are taken as they are stored: a warning says how an Exif orientation turns them for
// viewers, and where the balls are then. Writes the rig completely or not at all. Throws UsageError
// for an unknown extension of `output`, for a size or camera that an .lp file cannot hold, and for unequal numbers of pictures
// and lights; Error naming the picture if it cannot be read or shows no lamp.
CaptureDirectionsResult capture_directions(const CaptureDirectionsRequest& request,
                                           const Progress& progress);

}  // namespace burnish
