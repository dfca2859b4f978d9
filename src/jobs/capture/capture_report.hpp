// burnish capture report: a page of HTML that shows a stack, the fit to it and how well the fit
// predicts pictures (docs/guide/capture.md).
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
    std::optional<int> hold_out;  // as the fit had it; none: what the material says of itself
    std::string model;            // to render; empty: builtin:sphere and builtin:drape
    int gl_device = -1;
    std::filesystem::path output;  // a folder, made when it is not there
    std::string command;
};

struct CaptureReportResult {
    std::vector<std::filesystem::path> written;  // index.html first
    std::vector<std::string> warnings;
};

// Writes index.html and its pictures, all or, when anything fails, none. Throws Error when the
// pictures are of another size than the material, or no light can judge. What the material lacks
// and a machine that cannot render is said on the page.
CaptureReportResult capture_report(const CaptureReportRequest& request, const Progress& progress);

}  // namespace burnish
