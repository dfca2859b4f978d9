// burnish capture fit: fits a material file to a stack of pictures (docs/guide/capture.md).
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
    bool keep_stages = false;           // keep the files of the stages for a later run
    std::filesystem::path output;
    std::string command;
};

// An exemplar whose peak lies beside the normal.
struct HollowLobe {
    double at_normal = 0.0, at_peak = 0.0;  // D
    double peak_deg = 0.0;                  // from the normal
};

// Numbers of exemplars with limited reliability, among those that texels use.
struct ExemplarJudgement {
    int used = 0;           // by some texel
    int one_direction = 0;  // all grain within kOneDirectionDeg: completion is impossible
    int narrow = 0;         // narrower than the lights resolve (narrowest_alpha)
    int dark = 0;           // without a highlight under any light
    int hollow = 0;         // their peak lies beside the normal
    HollowLobe first_hollow;
    double dark_unexplained = 0.0;  // of the light of the dark ones' texels, 0 to 1
    double narrowest_alpha = 0.0;
};
inline constexpr double kOneDirectionDeg = 15.0;

struct CaptureFitResult {
    int width = 0, height = 0;
    std::size_t lights = 0;
    bool raw = false;          // some of the pictures are cameras' raw files
    CaptureFitReport fit;      // exemplars 0: stopped before them
    double unexplained = 0.0;  // of the light, 0 to 1; requires exemplars
    std::filesystem::path stages;
    // The members below are set after all stages.
    std::size_t held_out_lights = 0;
    // Errors of the material and its analytic models; empty without held-out lights.
    std::vector<HeldOutError> held_out;
    ExemplarJudgement exemplars;
    std::size_t beyond_range = 0;  // texels whose colors are cut at the end of the file's range
    std::vector<std::string> warnings;
    std::vector<std::filesystem::path> written;  // empty if the fit stopped after a stage
};

// The stages' files are in the folder "<output>.stages" and are removed once the material is
// written, unless kept. Throws Error; the next run continues from the finished stages.
CaptureFitResult capture_fit(const CaptureFitRequest& request, const Progress& progress);

}  // namespace burnish
