// burnish capture fit: from a stack of pictures to a material file (docs/guide/capture.md).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "burnish/progress.hpp"
#include "capture/solve/capture_fit.hpp"

namespace burnish {

enum class CaptureStage { pictures, exemplars, texels };
std::span<const std::string_view> capture_stage_names();

struct FitCaptureRequest {
    std::filesystem::path stack;  // a rig file
    RigOverrides overrides;
    CaptureFitSettings settings;
    std::optional<CaptureStage> until;  // stop after this stage; none: write the material
    bool keep_stages = false;           // leave what the stages made, for a later run
    std::filesystem::path output;
    std::string command;
};

struct FitCaptureReport {
    std::string text;  // what was found, for people
    std::vector<std::string> warnings;
    std::vector<std::filesystem::path> written;
};

// Stages lie in the folder "<output>.stages" and are removed when the material is written, unless
// kept. Throws Error; what is done by then is found again by the next run.
FitCaptureReport fit_capture(const FitCaptureRequest& request, const Progress& progress);

}  // namespace burnish
