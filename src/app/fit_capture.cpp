#include "app/fit_capture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/version.hpp"
#include "burnish/error.hpp"
#include "capture/coverage.hpp"
#include "core/files.hpp"

namespace burnish {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 3> kStages = {"pictures", "exemplars", "texels"};
// A share of clipped samples from which highlights miss their tops.
constexpr double kMuchClipped = 0.001;

// What the pictures themselves cannot support, said before hours are spent on them.
void judge_stack(const ImageStack& stack, const std::string& name,
                 std::vector<std::string>& warnings) {
    const StackCensus& census = stack.census();
    if (census.black_share >= 1.0)
        throw Error(name, "pictures", "light on the sample", "every picture is black");
    if (census.clipped_share >= 1.0)
        throw Error(name, "pictures", "samples that are not clipped", "every picture is white");
    if (stack.lights() < 3)
        throw Error(name, "lights", "at least 3 lights to fit anything",
                    fmt::to_string(stack.lights()));
    if (census.clipped_share > kMuchClipped)
        warnings.push_back(
            fmt::format("{}: {:.2g} % of the samples are clipped and left out: the tops of "
                        "highlights may be missing",
                        name, 100.0 * census.clipped_share));
}

std::string describe(const CaptureFit& fit, const FitCaptureRequest& request) {
    const CaptureFitReport& r = fit.report();
    std::string text = fmt::format(
        "{} x {} pixels, {} lights, half vectors {:.1f} degrees apart, {:.2g} % clipped, {:.2g} % "
        "black\n",
        fit.stack().width(), fit.stack().height(), fit.stack().lights(), r.spacing_deg,
        100.0 * r.census.clipped_share, 100.0 * r.census.black_share);
    if (r.exemplars == 0) return text;
    text += fmt::format(
        "{} exemplar{} from {} points, eta {:.3g}{}, {:.2g} % of the light unexplained\n",
        r.exemplars, r.exemplars == 1 ? "" : "s", r.training_points, r.eta,
        request.settings.eta ? "" : " (estimated)", 100.0 * r.training_error);
    text += fmt::format(
        "of the hemisphere {:.0f} % is measured, {:.0f} % completed from other exemplars, {:.0f} % "
        "extrapolated\n",
        100.0 * r.completion.measured, 100.0 * r.completion.completed_share,
        100.0 * r.completion.extrapolated);
    return text;
}

}  // namespace

std::span<const std::string_view> capture_stage_names() {
    return kStages;
}

FitCaptureReport fit_capture(const FitCaptureRequest& request, const Progress& progress) {
    FitCaptureReport report;
    require_writable(request.output);
    const Rig rig = read_rig(request.stack, true, request.overrides);
    report.warnings = rig.warnings;
    const fs::path stages = request.output.string() + ".stages";
    CaptureFit fit(rig, request.settings, stages, progress);
    judge_stack(fit.stack(), request.stack.string(), report.warnings);
    const bool all = !request.until;
    if (all || *request.until != CaptureStage::pictures) fit.find_exemplars();
    if (all || *request.until == CaptureStage::texels) fit.fit_texels();
    report.text = describe(fit, request);
    for (const std::string& warning : fit.report().warnings) report.warnings.push_back(warning);
    if (!all) return report;

    TabulatedMaterial material = fit.material();
    material.metadata["burnish:version"] = version();
    material.metadata["burnish:command"] = request.command;
    write_tabulated_material(request.output, material);
    report.written.push_back(request.output);
    if (!request.keep_stages) {
        std::error_code ignored;  // the material is written; leftovers harm nobody
        fs::remove_all(stages, ignored);
    }
    return report;
}

}  // namespace burnish
