// burnish capture fit: from a stack of pictures to a material file (docs/guide/capture.md).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "burnish/progress.hpp"
#include "capture/judge/held_out.hpp"
#include "capture/solve/capture_fit.hpp"

namespace burnish {

enum class CaptureStage { pictures, exemplars, texels };
std::span<const std::string_view> capture_stage_names();

struct CaptureFitRequest {
    std::filesystem::path stack;  // a rig file
    RigOverrides overrides;
    CaptureFitSettings settings;
    std::optional<CaptureStage> until;  // stop after this stage; none: write the material
    bool keep_stages = false;           // leave what the stages made, for a later run
    std::filesystem::path output;
    std::string command;
};

// How many exemplars of a material are not what they may seem, of those that texels have.
struct ExemplarJudgement {
    int used = 0;           // by some texel
    int one_direction = 0;  // all grain within kOneDirectionDeg: nothing could be completed
    int narrow = 0;         // narrower than the lights resolve (narrowest_alpha)
    int dark = 0;           // without a highlight under any light
    double narrowest_alpha = 0.0;
};
inline constexpr double kOneDirectionDeg = 15.0;

struct CaptureFitResult {
    int width = 0, height = 0;
    std::size_t lights = 0;
    CaptureFitReport fit;      // exemplars 0: stopped before them
    double unexplained = 0.0;  // share of the light, 0 to 1; with exemplars
    std::filesystem::path stages;
    // The rest after all stages.
    std::size_t held_out_lights = 0;
    // Of the material and its analytic models; none without such lights.
    std::vector<HeldOutError> held_out;
    ExemplarJudgement exemplars;
    std::vector<std::string> warnings;
    std::vector<std::filesystem::path> written;  // empty when the fit stopped after a stage
};

// Stages lie in the folder "<output>.stages" and are removed when the material is written, unless
// kept. Throws Error; what is done by then is found again by the next run.
CaptureFitResult capture_fit(const CaptureFitRequest& request, const Progress& progress);

}  // namespace burnish
