#include "burnish/plot/brdf_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/constants.hpp"
#include "core/even_points.hpp"
#include "core/parallel.hpp"
#include "models/albedo.hpp"
#include "plot/curve.hpp"

namespace burnish::plot {
namespace {

Direction<double> direction(double theta, double phi) {
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

Direction<double> drawn(const BrdfSubject& subject, Direction<double> wi, std::array<double, 3> xi,
                        double& density) {
    return subject.model ? subject.model->sampler_f64.sample(subject.p, wi, xi, density)
                         : subject.measured.sample(wi, xi, density);
}

double albedo_of(const BrdfSubject& subject, Direction<double> wi) {
    if (subject.model) return directional_albedo(*subject.model, subject.p, wi);
    // The samples follow the measurement, so that the terms of the mean are nearly equal.
    constexpr int kPoints = 4096;
    double sum = 0;
    for (int i = 0; i < kPoints; ++i) {
        double density = 0;
        const Direction<double> wo = drawn(subject, wi, even_point(i), density);
        if (density > 0 && wo.z > 0) sum += subject.measured.f(wi, wo) * wo.z / density;
    }
    return sum / kPoints;
}

}  // namespace

std::string parameters_text(const BrdfSubject& subject) {
    if (!subject.model) return "measured";
    std::string text;
    for (std::size_t i = 0; i < subject.model->parameters.size(); ++i)
        text += fmt::format("{}{} {}", i == 0 ? "" : ", ", subject.model->parameters[i].name,
                            number_text(subject.p[i]));
    return text;
}

Direction<double> incident(double incidence_deg, double azimuth_deg) {
    return direction(incidence_deg * kDegree, azimuth_deg * kDegree);
}

std::vector<Point> polar_cut(const BrdfSubject& subject, Direction<double> wi, double cut_deg) {
    const double x = std::cos(cut_deg * kDegree), y = std::sin(cut_deg * kDegree);
    const auto f = [&](double theta) {
        const double s = std::sin(theta);
        return subject.f(wi, {-s * x, -s * y, std::cos(theta)});
    };
    // The mirror direction seen in the cut, the direction back to the light, and the normal.
    const double mirror = std::atan2(wi.x * x + wi.y * y, wi.z);
    const double hints[] = {mirror, -mirror, 0.0};
    // The samples end just above the horizon, on which every model is 0 by definition.
    const double horizon = std::numbers::pi / 2 - 1e-4;
    const double end = subject.model
                           ? horizon
                           : std::min(horizon, std::acos(subject.measured.least_cosine) - 1e-9);
    return sampled_curve(f, -end, end, hints);
}

BrdfPeak peak_of(const BrdfSubject& subject, Direction<double> wi) {
    BrdfPeak best{{-wi.x, -wi.y, wi.z}, 0};
    best.f = subject.f(wi, best.wo);
    const auto consider = [&](Direction<double> wo) {
        if (!(wo.z > 0)) return false;
        const double value = subject.f(wi, wo);
        if (!(value > best.f)) return false;
        best = {wo, value};
        return true;
    };
    constexpr int kSamples = 2048, kRings = 45, kSectors = 90;
    for (int i = 0; i < kSamples; ++i) {
        double density = 0;
        consider(drawn(subject, wi, even_point(i), density));
    }
    for (int i = 0; i < kRings * kSectors; ++i)
        consider(direction((i / kSectors + 0.5) / kRings * std::numbers::pi / 2,
                           2 * std::numbers::pi * (i % kSectors) / kSectors));
    // Climbs in angle, by ever smaller steps. The last, 1e-6, is a thousandth of the narrowest
    // lobe.
    for (double step = 0.02; step > 1e-6;) {
        const double theta = std::acos(std::clamp(best.wo.z, -1.0, 1.0));
        const double phi = std::atan2(best.wo.y, best.wo.x);
        const double turn = step / std::max(std::sin(theta), step);
        bool moved = false;
        for (const auto& [dt, dp] : {std::pair{step, 0.0}, {-step, 0.0}, {0.0, turn}, {0.0, -turn}})
            moved = consider(direction(theta + dt, phi + dp)) || moved;
        if (!moved) step /= 2;
    }
    return best;
}

std::vector<Point> albedo_curve(const BrdfSubject& subject, double azimuth_deg) {
    std::vector<Point> curve;
    curve.reserve(32 + 19);
    for (int i = 0; i < 32; ++i) curve.push_back({2.5 * i, 0});
    for (int i = 0; i <= 18; ++i) curve.push_back({80 + 0.5 * i, 0});
    parallel_for(curve.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            curve[i].y = albedo_of(subject, incident(curve[i].x, azimuth_deg));
    });
    return curve;
}

Panel albedo_panel(std::span<const BrdfSubject> subjects, double azimuth_deg, std::string title) {
    LinePlot plot;
    plot.x = {"angle of incidence [deg]", {ScaleKind::linear, 0, 90}};
    double most = 0;
    for (std::size_t i = 0; i < subjects.size(); ++i) {
        plot.lines.push_back(series(i, subjects[i].label, albedo_curve(subjects[i], azimuth_deg)));
        for (const Point& p : plot.lines.back().points) most = std::max(most, p.y);
    }
    // An unbounded model leaves the axes at the top, so that the other models stay readable.
    plot.y = {"albedo", {ScaleKind::linear, 0, std::clamp(1.1 * most, 1.1, 1.6)}};
    plot.level = {1.0, "1: all light leaves"};
    return line_panel(std::move(plot), std::move(title));
}

std::vector<LegendEntry> legend_of(std::span<const BrdfSubject> subjects) {
    std::vector<LegendEntry> legend;
    for (std::size_t i = 0; i < subjects.size(); ++i)
        legend.push_back({subjects[i].label, series_color(i), series_dash(i)});
    return legend;
}

}  // namespace burnish::plot
