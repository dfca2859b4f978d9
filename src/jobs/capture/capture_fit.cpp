#include "jobs/capture/capture_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "burnish/coverage.hpp"
#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "burnish/tabulated_file.hpp"
#include "burnish/version.hpp"
#include "core/files.hpp"
#include "core/text.hpp"
#include "formats/tabulated/tabulated_parts.hpp"
#include "jobs/capture/capture_fit_judge.hpp"
#include "jobs/capture/capture_relight.hpp"
#include "jobs/map_folder.hpp"

namespace burnish {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 3> kStages = {"pictures", "exemplars", "texels"};
// Least share of clipped samples for a warning: the few samples of highlights lack their peaks.
constexpr double kMuchClipped = 0.001;
// Warns of defects of the pictures before the long fit; throws if nothing can be fitted.
void judge_stack(const ImageStack& stack, const std::string& name,
                 std::vector<std::string>& warnings) {
    const StackCensus& census = stack.census();
    if (census.black_share >= 1.0)
        throw Error(name, "pictures", "light on the sample", "every picture is black");
    if (census.clipped_share >= 1.0)
        throw Error(name, "pictures", "samples that are not clipped", "every picture is white");
    if (census.clipped_share > kMuchClipped)
        warnings.push_back(
            fmt::format("{}: {:.2g} % of the samples are clipped, or repeat the largest value of "
                        "pictures of floats, and are left out: the tops of highlights may be "
                        "missing",
                        name, 100.0 * census.clipped_share));
}

// Says which unit of intensities was chosen, where the rig states none.
void warn_of_level(const LightLevel& level, const std::string& name,
                   std::vector<std::string>& warnings) {
    if (!level.chosen()) return;
    warnings.push_back(fmt::format(
        "{}: no intensity of the lights is stated, and with 1 the sample would be {:.3g} times as "
        "bright as a white diffuser: all are multiplied by {:.4g}, with which its brightest parts "
        "are as bright as white paper ({:g}); --intensity, or \"intensity\" in a JSON rig, states "
        "them",
        name, level.brightness, level.intensity, kChosenBrightness));
}

class InterruptedFit : public Interrupted {
  public:
    explicit InterruptedFit(const fs::path& stages)
        : text_(fmt::format("interrupted: the same command goes on from what is in {}",
                            one_line(stages.string()))) {}
    const char* what() const noexcept override { return text_.c_str(); }

  private:
    std::string text_;
};

// Runs the stages, then makes the material from them.
void fit_into(const CaptureFitRequest& request, const Rig& rig, const Progress& progress,
              CaptureFitResult& result) {
    CaptureFit fit(rig, request.settings, result.stages, progress);
    judge_stack(fit.stack(), request.stack.string(), result.warnings);
    warn_of_level(fit.report().level, request.stack.string(), result.warnings);
    const bool all = !request.until;
    if (all || *request.until != CaptureStage::pictures) fit.find_exemplars();
    if (all || *request.until == CaptureStage::texels) fit.fit_texels();
    result.width = fit.stack().width();
    result.height = fit.stack().height();
    result.lights = fit.stack().lights();
    result.fit = fit.report();
    result.unexplained = fit.unexplained();
    if (!all) return;

    TabulatedMaterial material = fit.material();
    const std::vector<std::uint8_t> keep = fitted_lights(result.lights, request.settings.hold_out);
    result.held_out_lights = static_cast<std::size_t>(std::count(keep.begin(), keep.end(), 0));
    result.held_out = held_out_errors(fit.stack(), fit.rig(), material, keep, progress);
    result.exemplars = judge_exemplars(material, fit.report().spacing_deg);
    result.beyond_range = texels_beyond_range(material);
    warn_of_fit(result, request, result.warnings);
    material.metadata["burnish:version"] = version();
    material.metadata["burnish:command"] = request.command;
    write_tabulated_material(request.output, material);
    result.written.push_back(request.output);
    if (!request.keep_stages) {
        std::error_code ignored;  // the material is written: remaining files are harmless
        fs::remove_all(result.stages, ignored);
    }
}

}  // namespace

std::span<const std::string_view> capture_stage_names() {
    return kStages;
}

CaptureFitResult capture_fit(const CaptureFitRequest& request, const Progress& progress) {
    CaptureFitResult result;
    require_writable(request.output);
    const Rig rig = read_rig(request.stack, true, request.overrides);
    result.warnings = warnings_of(rig);
    for (const RigLight& light : rig.lights)
        for (const RigExposure& exposure : light.images)
            result.raw = result.raw || is_raw_camera_name(exposure.image);
    if (rig.lights.size() < 3)  // before reading many pictures
        throw Error(request.stack.string(), "lights", "at least 3 lights to fit anything",
                    fmt::to_string(rig.lights.size()));
    for (const std::string& line : rig_coverage(rig).diagnosis)
        result.warnings.push_back(fmt::format("{}: {}", request.stack.string(), line));
    result.stages = request.output.string() + ".stages";
    const OutputFolder folder(result.stages);  // removed if no stage finished
    try {
        fit_into(request, rig, progress, result);
    } catch (const Interrupted&) {
        if (fs::is_empty(result.stages)) throw;
        throw InterruptedFit(result.stages);
    }
    return result;
}

}  // namespace burnish
