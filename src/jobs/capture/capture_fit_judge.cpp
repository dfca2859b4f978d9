#include "jobs/capture/capture_fit_judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "burnish/coverage.hpp"
#include "burnish/lobe_fit.hpp"
#include "core/constants.hpp"
#include "core/text.hpp"
#include "formats/tabulated/tabulated_parts.hpp"

namespace burnish {

namespace {

// Ratio of the alphas above which a lobe has a grain: the directions of rounder ones are noise.
constexpr double kGrainRatio = 1.2;
// Ratio of D at the normal to its largest value below which the peak lies beside the normal.
constexpr double kHollow = 1.0 / 3.0;
// Ratio of the unexplained light with and without normals of the pixels below which they explain
// it: their freedom alone, two numbers a pixel, lowers it by less under 5 lights and more.
constexpr double kExplainedByNormals = 0.5;

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

// Finds the peak of an exemplar; returns whether it lies beside the normal.
bool is_hollow(const TabulatedMaterial& m, int exemplar, HollowLobe& lobe) {
    const float* table = m.table(exemplar);
    const auto azimuths = static_cast<std::ptrdiff_t>(m.grid.azimuths);
    const float* peak = std::max_element(table, table + m.grid.cells());
    double center = 0.0;
    for (std::ptrdiff_t c = 0; c < azimuths; ++c)
        center += static_cast<double>(table[c]) / static_cast<double>(azimuths);
    lobe = {
        center, static_cast<double>(*peak),
        static_cast<double>(m.grid.theta(static_cast<float>((peak - table) / azimuths))) / kDegree};
    return lobe.at_normal < kHollow * lobe.at_peak;
}

void judge_exemplar(const TabulatedMaterial& m, int e, double spread, ExemplarJudgement& out) {
    const LobeFit lobe = fit_lobe(m.grid, m.table(e), Mdf::ggx);
    out.one_direction +=
        spread < kOneDirectionDeg && lobe.alpha_across > kGrainRatio * lobe.alpha_along;
    out.narrow += lobe.alpha_along < out.narrowest_alpha;
    HollowLobe hollow;
    if (is_hollow(m, e, hollow) && out.hollow++ == 0) out.first_hollow = hollow;
}

}  // namespace

ExemplarJudgement judge_exemplars(const TabulatedMaterial& m, double spacing_deg) {
    ExemplarJudgement out;
    out.narrowest_alpha = narrowest_ggx_alpha(spacing_deg);
    const std::vector<float>& errors = m.maps.at("fit.error");
    double sum = 0.0, count = 0.0;  // of the errors of texels without a highlight
    for (int e = 0; e < m.exemplars; ++e) {
        std::size_t texels = 0;
        const double spread = spread_deg(m, e, texels);
        if (texels == 0) continue;
        ++out.used;
        const auto first = m.origin.begin() + static_cast<std::ptrdiff_t>(e) * m.grid.cells();
        const bool unseen = std::all_of(first, first + m.grid.cells(),
                                        [](NdfOrigin o) { return o == NdfOrigin::extrapolated; });
        if (!unseen && shows_highlight(m, e)) {
            judge_exemplar(m, e, spread, out);
            continue;
        }
        ++out.dark;
        for (std::size_t t = 0; t < m.texels(); ++t) {
            if (m.exemplar[t] != e) continue;
            sum += static_cast<double>(errors[t]);
            ++count;
        }
    }
    out.dark_unexplained = std::sqrt(sum / std::max(count, 1.0));
    return out;
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

namespace {

std::string about_dark(const ExemplarJudgement& e) {
    if (e.dark_unexplained > kMuchUnexplained)
        return fmt::format(
            "no highlight was found for {} of {} exemplars, but diffuse light leaves {:.2g} % of "
            "their light unexplained: they are written as diffuse, which they are not",
            e.dark, e.used, 100.0 * e.dark_unexplained);
    return fmt::format(
        "{} of {} exemplars show no highlight under any light: there is none, or it falls between "
        "the lights{}",
        e.dark, e.used, e.dark == e.used ? "; the material is diffuse alone" : "");
}

std::string about_hollow(const ExemplarJudgement& e, bool normals) {
    return fmt::format(
        "{} of {} exemplars have their peak beside the normal (D {:.3g} at the normal, {:.3g} at "
        "{:.0f} degrees from it): a pile such as velvet reflects so; for a metal, a paint or a "
        "varnish the fit is wrong: {}",
        e.hollow, e.used, e.first_hollow.at_normal, e.first_hollow.at_peak, e.first_hollow.peak_deg,
        normals ? "try another --seed and compare what stays unexplained, or take more lights"
                : "try --normals, or take more lights");
}

bool explained_by_normals(const CaptureFitReport& fit) {
    return fit.tilted_error < kExplainedByNormals * fit.training_error;
}

std::string about_unexplained(const CaptureFitResult& result, bool normals) {
    const std::string share =
        fmt::format("{:.2g} % of the light is unexplained", 100.0 * result.unexplained);
    constexpr const char* kRelief =
        "shadows and light between the parts of a relief are no reflectance of a surface, or the "
        "lights are too few for its highlights";
    if (normals) return fmt::format("{}: {}; try another --seed", share, kRelief);
    const CaptureFitReport& fit = result.fit;
    if (fit.training_error <= kTriedUnexplained)  // no trial of normals
        return fmt::format("{}: the sample may not be flat (--normals), or {}", share, kRelief);
    const std::string trial =
        fmt::format("in a trial on some of the pixels with a normal of their own {:.2g} %",
                    100.0 * fit.tilted_error);
    if (explained_by_normals(fit))
        return fmt::format("{}, {}: the sample does not seem flat: fit it with --normals", share,
                           trial);
    return fmt::format("{}, {}: {}", share, trial, kRelief);
}

}  // namespace

void warn_of_fit(const CaptureFitResult& result, const CaptureFitRequest& request,
                 std::vector<std::string>& warnings) {
    const ExemplarJudgement& e = result.exemplars;
    const bool normals = request.settings.normals;
    const auto warn = [&](const std::string& text) {
        warnings.push_back(fmt::format("{}: {}", request.stack.string(), text));
    };
    if (e.one_direction > 0)
        warn(fmt::format(
            "{} of {} exemplars have one grain direction (within {:.0f} degrees): nothing turns, "
            "so nothing beyond what the lights reach could be completed",
            e.one_direction, e.used, kOneDirectionDeg));
    if (e.narrow > 0)
        warn(fmt::format(
            "{} of {} exemplars are narrower than lights {:.1f} degrees apart resolve (alpha "
            "{:.3f}): their peaks are a guess, unless pixels that differ in place, grain or normal "
            "fill the gaps",
            e.narrow, e.used, result.fit.spacing_deg, e.narrowest_alpha));
    if (e.dark > 0) warn(about_dark(e));
    if (e.hollow > 0 && (normals || result.unexplained > kMuchUnexplained))
        warn(about_hollow(e, normals));
    if (result.beyond_range > 0)
        warn(
            fmt::format("{} reflect more than {:g} times as much as a white diffuser and are cut "
                        "there: broken pixels, or a mask is missing",
                        plural(result.beyond_range, "texel"), kMostColor));
    if (result.unexplained > kMuchUnexplained || (!normals && explained_by_normals(result.fit)))
        warn(about_unexplained(result, normals));
}

}  // namespace burnish
