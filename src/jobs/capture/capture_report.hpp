// burnish capture report: an HTML page with a stack, the fit to it and the errors of the predicted
// pictures (docs/guide/capture.md).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "burnish/progress.hpp"
#include "burnish/rig.hpp"

namespace burnish {

struct CaptureReportRequest {
    std::filesystem::path material, stack;  // stack: a rig whose lights name pictures
    RigOverrides overrides;
    std::optional<int> hold_out;  // as in the fit; none: as recorded in the material
    std::string model;            // to render; empty: builtin:sphere and builtin:drape
    int gl_device = -1;
    std::filesystem::path output;  // a folder, created if it is missing
    std::string command;
};

struct CaptureReportResult {
    std::vector<std::filesystem::path> written;  // index.html first
    std::vector<std::string> warnings;
};

// Writes index.html and its pictures, or none if anything fails. Throws Error if the sizes of the
// pictures and the material differ, or if no light can judge. The page lists the material's missing
// parts and a failure to render.
CaptureReportResult capture_report(const CaptureReportRequest& request, const Progress& progress);

}  // namespace burnish
