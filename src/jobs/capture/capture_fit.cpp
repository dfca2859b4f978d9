#include "jobs/capture/capture_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "burnish/error.hpp"
#include "capture/judge/held_out.hpp"
#include "capture/rig/coverage.hpp"
#include "core/files.hpp"
#include "core/text.hpp"
#include "core/version.hpp"
#include "fit/lobe_fit.hpp"
#include "jobs/info/info_scene.hpp"
#include "jobs/map_folder.hpp"
#include "formats/tabulated/tabulated_file.hpp"

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
    if (census.clipped_share > kMuchClipped)
        warnings.push_back(
            fmt::format("{}: {:.2g} % of the samples are clipped and left out: the tops of "
                        "highlights may be missing",
                        name, 100.0 * census.clipped_share));
}

// Spread of the turns of an exemplar's texels about their mean, as lines, in degrees (of a wrapped
// normal distribution with the same mean resultant).
double spread_deg(const TabulatedMaterial& m, int exemplar, std::size_t& texels) {
    double x = 0.0, y = 0.0;
    texels = 0;
    for (std::size_t t = 0; t < m.texels(); ++t) {
        if (m.exemplar[t] != exemplar) continue;
        x += std::cos(2.0 * static_cast<double>(m.angle[t]));
        y += std::sin(2.0 * static_cast<double>(m.angle[t]));
        ++texels;
    }
    const double resultant =
        std::min(std::hypot(x, y) / std::max<double>(1.0, static_cast<double>(texels)), 1.0);
    return 0.5 * std::sqrt(-2.0 * std::log(std::max(resultant, 1e-12))) * 180.0 / std::numbers::pi;
}

// What the distributions that were found cannot be, given what they were found from.
void judge_exemplars(const CaptureFit& fit, const TabulatedMaterial& m, const std::string& name,
                     std::vector<std::string>& warnings) {
    constexpr double kOneDirection = 15.0;     // degrees
    constexpr double kMuchUnexplained = 0.15;  // of the light
    const double narrowest = narrowest_ggx_alpha(fit.report().spacing_deg);
    int one_direction = 0, narrow = 0, dark = 0, used = 0;
    for (int e = 0; e < m.exemplars; ++e) {
        std::size_t texels = 0;
        const double spread = spread_deg(m, e, texels);
        if (texels == 0) continue;
        ++used;
        const auto first = m.origin.begin() + static_cast<std::ptrdiff_t>(e) * m.grid.cells();
        if (std::all_of(first, first + m.grid.cells(),
                        [](NdfOrigin o) { return o == NdfOrigin::extrapolated; })) {
            ++dark;
            continue;
        }
        one_direction += spread < kOneDirection;
        narrow += fit_lobe(m.grid, m.table(e), Mdf::ggx).alpha_along < narrowest;
    }
    if (one_direction > 0)
        warnings.push_back(
            fmt::format("{}: {} of {} exemplars have one grain direction (within {:.0f} degrees): "
                        "nothing turns, so nothing "
                        "beyond what the lights reach could be completed",
                        name, one_direction, used, kOneDirection));
    if (narrow > 0)
        warnings.push_back(
            fmt::format("{}: {} of {} exemplars are narrower than lights {:.1f} degrees apart "
                        "resolve (alpha {:.3f}): their "
                        "peaks are a guess",
                        name, narrow, used, fit.report().spacing_deg, narrowest));
    if (dark > 0)
        warnings.push_back(
            fmt::format("{}: {} of {} exemplars show no highlight under any light: there is none, "
                        "or it falls between the lights",
                        name, dark, used));
    if (fit.unexplained() > kMuchUnexplained)
        warnings.push_back(fmt::format(
            "{}: {:.0f} % of the light is unexplained: {}, or shadows and light between "
            "its parts are no reflectance of a surface",
            name, 100.0 * fit.unexplained(),
            fit.settings().normals ? "the lights may be too few for its highlights"
                                   : "the sample may not be flat (--normals)"));
}

// The fit beside other people's models, where it was not told the answer.
std::string describe(const std::vector<HeldOutError>& errors, std::size_t lights) {
    if (errors.empty()) return "";
    std::string text = fmt::format("on the {} held out, PSNR by their brightest sample:\n",
                                   plural(lights, "light"));
    for (const HeldOutError& e : errors)
        text += fmt::format("  {:<18} {:5.1f} dB, RMSE {:.3g}\n", e.model, e.psnr, e.rmse);
    return text;
}

std::string describe(const CaptureFit& fit, const FitCaptureRequest& request) {
    const CaptureFitReport& r = fit.report();
    std::string text = fmt::format(
        "{} x {} pixels, {} lights, half vectors {:.1f} degrees apart, {:.2g} % clipped, {:.2g} % "
        "black\n",
        fit.stack().width(), fit.stack().height(), fit.stack().lights(), r.spacing_deg,
        100.0 * r.census.clipped_share, 100.0 * r.census.black_share);
    if (r.exemplars == 0) return text;
    text +=
        fmt::format("{} from {} points, eta {:.3g}{}, {:.2g} % of the light unexplained\n",
                    plural(static_cast<std::size_t>(r.exemplars), "exemplar"), r.training_points,
                    r.eta, request.settings.eta ? "" : " (estimated)", 100.0 * fit.unexplained());
    text += fmt::format(
        "of the hemisphere {:.0f} % is measured, {:.0f} % completed from other exemplars, {:.0f} % "
        "extrapolated\n",
        100.0 * r.completion.measured, 100.0 * r.completion.completed_share,
        100.0 * r.completion.extrapolated);
    return text;
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

// The stages, then the material from them.
void fit_into(const FitCaptureRequest& request, const Rig& rig, const fs::path& stages,
              const Progress& progress, FitCaptureReport& report) {
    CaptureFit fit(rig, request.settings, stages, progress);
    judge_stack(fit.stack(), request.stack.string(), report.warnings);
    const bool all = !request.until;
    if (all || *request.until != CaptureStage::pictures) fit.find_exemplars();
    if (all || *request.until == CaptureStage::texels) fit.fit_texels();
    report.text = describe(fit, request);
    if (!all) {
        report.text += fmt::format(
            "stopped after {}: no material yet; the same command without --until goes on from {}\n",
            kStages[static_cast<std::size_t>(*request.until)], stages.string());
        return;
    }

    TabulatedMaterial material = fit.material();
    const std::vector<std::uint8_t> keep =
        fitted_lights(fit.stack().lights(), request.settings.hold_out);
    report.text += describe(held_out_errors(fit.stack(), fit.rig(), material, keep, progress),
                            static_cast<std::size_t>(std::count(keep.begin(), keep.end(), 0)));
    judge_exemplars(fit, material, request.stack.string(), report.warnings);
    material.metadata["burnish:version"] = version();
    material.metadata["burnish:command"] = request.command;
    write_tabulated_material(request.output, material);
    report.written.push_back(request.output);
    if (!request.keep_stages) {
        std::error_code ignored;  // the material is written; leftovers harm nobody
        fs::remove_all(stages, ignored);
    }
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
    if (rig.lights.size() < 3)  // before many pictures are read
        throw Error(request.stack.string(), "lights", "at least 3 lights to fit anything",
                    fmt::to_string(rig.lights.size()));
    for (const std::string& line : rig_coverage(rig).diagnosis)
        report.warnings.push_back(fmt::format("{}: {}", request.stack.string(), line));
    const fs::path stages = request.output.string() + ".stages";
    const OutputFolder folder(stages);  // goes again when no stage came to an end
    try {
        fit_into(request, rig, stages, progress, report);
    } catch (const Interrupted&) {
        if (fs::is_empty(stages)) throw;
        throw InterruptedFit(stages);
    }
    return report;
}

}  // namespace burnish
