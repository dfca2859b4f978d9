#include "jobs/capture/capture_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "burnish/coverage.hpp"
#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "burnish/lobe_fit.hpp"
#include "burnish/tabulated_file.hpp"
#include "burnish/version.hpp"
#include "core/files.hpp"
#include "core/text.hpp"
#include "formats/tabulated/tabulated_parts.hpp"
#include "jobs/capture/capture_relight.hpp"
#include "jobs/map_folder.hpp"

namespace burnish {

namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 3> kStages = {"pictures", "exemplars", "texels"};
// Least share of clipped samples for a warning: the few samples of highlights lack their peaks.
constexpr double kMuchClipped = 0.001;
// Least unexplained share of the light for a warning: 5 % of noise leaves less.
constexpr double kMuchUnexplained = 0.15;

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
            fmt::format("{}: {:.2g} % of the samples are clipped and left out: the tops of "
                        "highlights may be missing",
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

// Angular spread in degrees of the rotations of an exemplar's texels about their mean, modulo 180
// degrees (that of a wrapped normal distribution with the same mean resultant).
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

// Texels with a color at the end of the file's range, where CaptureFit::material cuts it.
std::size_t texels_beyond_range(const TabulatedMaterial& m) {
    std::size_t count = 0;
    for (std::size_t t = 0; t < m.texels(); ++t) {
        float most = 0.0f;
        for (std::size_t c = 0; c < 3; ++c)
            most = std::max({most, m.diffuse.pixels[3 * t + c], m.specular.pixels[3 * t + c]});
        count += most >= kMostColor;
    }
    return count;
}

// Is a texel of the exemplar brighter in its specular color than a thousandth of its diffuse one?
// Less is noise of the pictures: a card without a highlight still has a best exemplar.
bool shows_highlight(const TabulatedMaterial& m, int exemplar) {
    const auto brightest = [](const Image& image, std::size_t t) {
        const float* rgb = image.pixels.data() + 3 * t;
        return std::max({rgb[0], rgb[1], rgb[2]});
    };
    for (std::size_t t = 0; t < m.texels(); ++t)
        if (m.exemplar[t] == exemplar && brightest(m.specular, t) > 1e-3f * brightest(m.diffuse, t))
            return true;
    return false;
}

ExemplarJudgement judge_exemplars(const CaptureFit& fit, const TabulatedMaterial& m) {
    ExemplarJudgement out;
    out.narrowest_alpha = narrowest_ggx_alpha(fit.report().spacing_deg);
    for (int e = 0; e < m.exemplars; ++e) {
        std::size_t texels = 0;
        const double spread = spread_deg(m, e, texels);
        if (texels == 0) continue;
        ++out.used;
        const auto first = m.origin.begin() + static_cast<std::ptrdiff_t>(e) * m.grid.cells();
        if (std::all_of(first, first + m.grid.cells(),
                        [](NdfOrigin o) { return o == NdfOrigin::extrapolated; }) ||
            !shows_highlight(m, e)) {
            ++out.dark;
            continue;
        }
        out.one_direction += spread < kOneDirectionDeg;
        out.narrow += fit_lobe(m.grid, m.table(e), Mdf::ggx).alpha_along < out.narrowest_alpha;
    }
    return out;
}

// Warns of limits of the fit that follow from its inputs.
void warn_of_fit(const CaptureFitResult& result, const CaptureFitRequest& request,
                 std::vector<std::string>& warnings) {
    const std::string name = request.stack.string();
    const ExemplarJudgement& e = result.exemplars;
    if (e.one_direction > 0)
        warnings.push_back(
            fmt::format("{}: {} of {} exemplars have one grain direction (within {:.0f} degrees): "
                        "nothing turns, so nothing beyond what the lights reach could be completed",
                        name, e.one_direction, e.used, kOneDirectionDeg));
    if (e.narrow > 0)
        warnings.push_back(fmt::format(
            "{}: {} of {} exemplars are narrower than lights {:.1f} degrees apart resolve (alpha "
            "{:.3f}): their peaks are a guess",
            name, e.narrow, e.used, result.fit.spacing_deg, e.narrowest_alpha));
    if (e.dark > 0)
        warnings.push_back(fmt::format(
            "{}: {} of {} exemplars show no highlight under any light: there is none, "
            "or it falls between the lights{}",
            name, e.dark, e.used, e.dark == e.used ? "; the material is diffuse alone" : ""));
    if (result.beyond_range > 0)
        warnings.push_back(
            fmt::format("{}: {} reflect more than {:g} times as much as a white diffuser and are "
                        "cut there: broken pixels, or a mask is missing",
                        name, plural(result.beyond_range, "texel"), kMostColor));
    if (result.unexplained > kMuchUnexplained)
        warnings.push_back(fmt::format(
            "{}: {:.0f} % of the light is unexplained: {}, or shadows and light between "
            "its parts are no reflectance of a surface",
            name, 100.0 * result.unexplained,
            request.settings.normals ? "the lights may be too few for its highlights"
                                     : "the sample may not be flat (--normals)"));
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
    result.exemplars = judge_exemplars(fit, material);
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
