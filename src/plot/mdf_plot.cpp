#include "burnish/plot/mdf_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "burnish/error.hpp"
#include "core/constants.hpp"
#include "core/even_points.hpp"
#include "core/parallel.hpp"
#include "plot/curve.hpp"
#include "plot/mdf_evaluator.hpp"

namespace burnish::plot {
namespace {

constexpr std::array<std::string_view, 3> kNormalizations = {"paper", "projected", "conserving"};

bool deforms(Method method) {
    return method == Method::deform_linear || method == Method::deform_smooth;
}

bool above(const Peak& a, const Peak& b) {
    return a.D > b.D;
}

// Climbs on the disk from a good start, in ever smaller steps.
Peak climbed(const MdfEvaluator& lobe, Peak best, double step) {
    // 1e-9 of the disk is a thousandth of the narrowest lobe.
    while (step > 1e-9) {
        const double x = best.h.x, y = best.h.y;
        Peak found = best;
        for (const auto& [dx, dy] :
             {std::pair{step, 0.0}, {-step, 0.0}, {0.0, step}, {0.0, -step}}) {
            const Direction<double> h = lifted(x + dx, y + dy);
            found = std::max(found, Peak{lobe.D(h), h},
                             [](const Peak& a, const Peak& b) { return above(b, a); });
        }
        if (!(found.D > best.D)) step /= 2;
        best = found;
    }
    return best;
}

}  // namespace

std::span<const std::string_view> normalization_names() {
    return kNormalizations;
}

Direction<double> lifted(double x, double y) {
    const double r2 = x * x + y * y;
    if (r2 < 1) return {x, y, std::sqrt(1 - r2)};
    const double r = std::sqrt(r2);
    return {x / r, y / r, 0};
}

double MdfSubject::D(Direction<double> h) const {
    return MdfEvaluator(*this).D(h);
}

Direction<double> tilted_normal(double tilt_deg, double azimuth_deg) {
    const double s = std::sin(tilt_deg * kDegree);
    return {s * std::cos(azimuth_deg * kDegree), s * std::sin(azimuth_deg * kDegree),
            std::cos(tilt_deg * kDegree)};
}

std::string lobe_text(Mdf mdf, double p0, double p1) {
    const bool exponents = mdf == Mdf::ashikhmin_shirley;
    return fmt::format("{}, {} = {}, {}", name_of(mdf), exponents ? "e" : "\u03b1", number_text(p0),
                       number_text(p1));
}

std::string normal_text(Direction<double> n) {
    const double tilt = std::atan2(std::hypot(n.x, n.y), n.z) / kDegree;
    if (tilt < 0.005) return "\u00f1 = n";
    double azimuth = std::atan2(n.y, n.x) / kDegree;
    if (azimuth < -0.005) azimuth += 360;
    return fmt::format("\u00f1 tilted {}\u00b0 at {}\u00b0", number_text(tilt),
                       number_text(std::abs(azimuth) < 0.005 ? 0 : azimuth));
}

std::string value_text(Mdf mdf, Normalization normalization) {
    if (normalization == Normalization::projected) return "D, projected [1/sr]";
    if (normalization == Normalization::conserving) return "D, conserving [1/sr]";
    if (mdf == Mdf::ward) return "D, peak 1 (K12 Eq 3)";
    if (mdf == Mdf::ashikhmin_shirley) return "D [1/sr] (K11 Eq 1)";
    return "D [1/sr]";
}

Footprint footprint_of(const MdfSubject& subject) {
    const MdfEvaluator lobe(subject);
    const double alpha_x = f64::lobe_alpha_x(lobe.lobe()), alpha_y = f64::lobe_alpha_y(lobe.lobe());
    const double d = std::hypot(subject.n.x, subject.n.y);
    double squeeze = subject.n.z;
    if (subject.method == Method::none || subject.method == Method::normal_map) squeeze = 1;
    // 1 - |d| without cancellation.
    if (deforms(subject.method)) squeeze = subject.n.z * subject.n.z / (1 + d);
    return {std::min(alpha_x, alpha_y) * squeeze, std::max(alpha_x, alpha_y)};
}

Peak peak_of(const MdfSubject& subject) {
    const MdfEvaluator lobe(subject);
    Peak best{lobe.D(subject.n), subject.n};
    const auto consider = [&](Direction<double> h) {
        if (h.z < 0) return;
        const double value = lobe.D(h);
        if (value > best.D) best = {value, h};
    };
    consider({0, 0, 1});
    constexpr int kSamples = 4096, kSide = 96;
    for (int i = 0; i < kSamples; ++i) consider(lobe.sample(even_point(i)));
    for (int i = 0; i < kSide * kSide; ++i) {
        const double x = 2 * (i % kSide + 0.5) / kSide - 1, y = 2 * (i / kSide + 0.5) / kSide - 1;
        if (x * x + y * y < 1) consider(lifted(x, y));
    }
    return climbed(lobe, best, std::min(0.02, footprint_of(subject).narrow));
}

Image disk_values(const MdfSubject& subject, int side) {
    const MdfEvaluator lobe(subject);
    Image values(side, side, 1, std::nanf(""));
    const auto place = [&](int i) { return 2 * (i + 0.5) / side - 1; };
    parallel_for(static_cast<std::size_t>(side), 8, [&](std::size_t begin, std::size_t end) {
        for (int row = static_cast<int>(begin); row < static_cast<int>(end); ++row) {
            for (int column = 0; column < side; ++column) {
                const double x = place(column), y = -place(row);
                if (x * x + y * y > 1) continue;
                *values.at(column, row) = static_cast<float>(lobe.D(lifted(x, y)));
            }
        }
    });
    // Three texels per half width: the centers of texels then miss the peak by a few per cent.
    if (footprint_of(subject).narrow > 3 * 2.0 / side) return values;
    constexpr int kSamples = 1 << 18;
    const auto hold = [&](Direction<double> h) {
        if (!(h.z > 0)) return;
        const int column = std::clamp(static_cast<int>((h.x + 1) / 2 * side), 0, side - 1);
        const int row = std::clamp(static_cast<int>((1 - h.y) / 2 * side), 0, side - 1);
        float& value = *values.at(column, row);
        if (!std::isnan(value)) value = std::max(value, static_cast<float>(lobe.D(h)));
    };
    hold(peak_of(subject).h);
    for (int i = 0; i < kSamples; ++i) hold(lobe.sample(even_point(i)));
    return values;
}

ColorBar disk_bar(std::span<const MdfSubject> subjects, ScaleKind kind,
                  std::optional<double> high) {
    double most = 0, of_normal_map = 0;
    for (const MdfSubject& subject : subjects) {
        double& reached = subject.method == Method::normal_map ? of_normal_map : most;
        reached = std::max(reached, peak_of(subject).D);
    }
    const double all = std::max(most, of_normal_map);
    const double top = high.value_or(most > 0 ? most : all);
    ColorBar bar;
    bar.scale = scale_to(kind, top);
    if (!subjects.empty())
        bar.label = value_text(subjects.front().mdf, subjects.front().normalization);
    bar.label += kind == ScaleKind::linear  ? ", linear"
                 : kind == ScaleKind::gamma ? fmt::format(", gamma {}", kPlotGamma)
                                            : ", log";
    // 1.01: the search for a peak may end this much below it.
    if (all > 1.01 * top) bar.above = all;
    return bar;
}

Direction<double> forward(const MdfSubject& subject, Direction<double> m) {
    if (subject.method == Method::normal_map)
        throw UsageError("--method", "normal-map",
                         "a method that moves the distribution, to draw its grid",
                         "one that does not");
    return f64::perturb_forward(MdfEvaluator(subject).perturbation(), m);
}

std::vector<GridLine> warped_grid(const MdfSubject& subject, int rings, int rays) {
    constexpr int kSteps = 96;
    std::vector<GridLine> grid;
    const auto add = [&](GridLine& line, double radius, double angle) {
        // Just inside the rim: on it, the inverse of deform-smooth is not unique.
        radius = std::min(radius, 1 - 1e-6);
        line.from.push_back(lifted(radius * std::cos(angle), radius * std::sin(angle)));
        line.to.push_back(forward(subject, line.from.back()));
    };
    for (int ring = 1; ring <= rings; ++ring) {
        GridLine& line = grid.emplace_back();
        for (int i = 0; i <= kSteps; ++i)
            add(line, static_cast<double>(ring) / rings, 2 * std::numbers::pi * i / kSteps);
    }
    for (int ray = 0; ray < rays; ++ray) {
        GridLine& line = grid.emplace_back();
        for (int i = 0; i <= kSteps; ++i)
            add(line, static_cast<double>(i) / kSteps, 2 * std::numbers::pi * ray / rays);
    }
    return grid;
}

std::vector<Point> profile(const MdfSubject& subject, ProfileLine line) {
    const MdfEvaluator lobe(subject);
    const bool along_x = line == ProfileLine::along_x;
    const double across = along_x ? subject.n.y : subject.n.x;
    // 1e-9: the rim itself, where h_z = 0.
    const double rim = std::sqrt(std::max(1 - across * across, 0.0)) * (1 - 1e-9);
    const auto D = [&](double s) {
        return lobe.D(along_x ? lifted(s, across) : lifted(across, s));
    };
    const Peak peak = peak_of(subject);
    const double hints[] = {along_x ? subject.n.x : subject.n.y, 0.0,
                            along_x ? peak.h.x : peak.h.y};
    return sampled_curve(D, -rim, rim, hints);
}

Panel profile_panel(std::span<const MdfSubject> subjects, std::span<const std::string> labels,
                    ProfileLine line, const Scale& scale, std::string title) {
    LinePlot plot;
    const bool along_x = line == ProfileLine::along_x;
    plot.x = {along_x ? "h_{x}" : "h_{y}", {ScaleKind::linear, -1, 1}};
    plot.y = {"D", scale};
    for (std::size_t i = 0; i < subjects.size(); ++i)
        plot.lines.push_back(
            series(i, i < labels.size() ? labels[i] : "", profile(subjects[i], line)));
    if (!subjects.empty()) {
        const Direction<double> n = subjects.front().n;
        plot.y.label = value_text(subjects.front().mdf, subjects.front().normalization);
        plot.place = {along_x ? n.x : n.y, "\u00f1"};
    }
    return line_panel(std::move(plot), std::move(title));
}

}  // namespace burnish::plot
