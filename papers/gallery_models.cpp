// The reflection models of B12's slide: lobes at matched widths, and fits of measured materials.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>

#include "burnish/error.hpp"
#include "burnish/plot/brdf_plot.hpp"
#include "jobs/models/brdf_fit.hpp"
#include "papers/gallery_figures.hpp"
#include "papers/gallery_measures.hpp"

namespace burnish {
namespace {

using plot::BrdfSubject;
using plot::Rgb;

constexpr double kMatchedAt = 30;  // degrees of incidence

const BrdfModel& model_named(std::string_view name) {
    for (const BrdfModel& model : brdf_models())
        if (model.name == name) return model;
    throw Error("gallery", std::string(name), "a reflection model", "none of that name");
}

double f_at(const BrdfSubject& subject, double theta) {
    return subject.f(plot::incident(kMatchedAt, 180), {std::sin(theta), 0, std::cos(theta)});
}

// Full width at half maximum of the lobe in the plane of incidence, degrees.
double width_deg(const BrdfSubject& subject) {
    double peak = 0, at = 0;
    for (double theta = -1.5; theta < 1.5; theta += 0.002) {
        const double f = f_at(subject, theta);
        if (f > peak) peak = f, at = theta;
    }
    const auto edge = [&](double step) {
        double theta = at;
        while (std::abs(theta) < 1.57 && f_at(subject, theta) > peak / 2) theta += step;
        return theta;
    };
    return kDegreesPerRadian * (edge(0.001) - edge(-0.001));
}

// Sets the parameter `index`, between `narrow` and `wide`, so that the lobe has the given width.
void match(BrdfSubject& subject, std::size_t index, double narrow, double wide, double width) {
    double a = std::log(narrow), b = std::log(wide);
    for (int step = 0; step < 40; ++step) {
        const double middle = (a + b) / 2;
        subject.p[index] = std::exp(middle);
        (width_deg(subject) < width ? a : b) = middle;
    }
}

double peak_f(const BrdfSubject& subject) {
    return plot::peak_of(subject, plot::incident(kMatchedAt, 180)).f;
}

std::vector<BrdfSubject> matched_models() {
    std::vector<BrdfSubject> list;
    const auto add = [&](const char* name, std::initializer_list<double> p) -> BrdfSubject& {
        BrdfSubject subject;
        subject.model = &model_named(name);
        std::copy(p.begin(), p.end(), subject.p.begin());
        subject.label = name;
        list.push_back(subject);
        return list.back();
    };
    const double width = width_deg(add("ward", {1, 0.15, 0.15}));
    match(add("phong", {1, 50}), 1, 5000, 2, width);
    match(add("lafortune", {1, -1, -1, 1, 50}), 4, 5000, 2, width);
    match(add("cook-torrance", {1, 0.15, 1}), 1, 0.02, 0.6, width);
    match(add("he", {0.6, 6, 1}), 1, 60, 1.2, width);
    // Scales all lobes to the peak of the dimmest, each by its own scale parameter.
    double least = peak_f(list.front());
    for (const BrdfSubject& s : list) least = std::min(least, peak_f(s));
    for (BrdfSubject& s : list) {
        const std::size_t scale = s.label == "he" ? 2 : 0;
        s.p[scale] *= least / peak_f(s);
        // Repeated for F0, which scales the lobe only approximately: the Fresnel term rises from
        // it.
        if (scale == 2) s.p[2] *= least / peak_f(s);
    }
    return list;
}

std::string command_of(const std::vector<BrdfSubject>& subjects, const char* kind) {
    std::string models;
    for (const BrdfSubject& s : subjects) {
        models += (models.empty() ? "" : ",") + std::string(s.model->name);
        for (std::size_t i = 0; i < s.model->parameters.size(); ++i)
            models += fmt::format(":{}={:.4g}", s.model->parameters[i].name, s.p[i]);
    }
    return fmt::format("burnish brdf plot --brdf {} --kind {} --incidence 30,60,75 -o OUT.png",
                       models, kind);
}

std::vector<std::filesystem::path> materials_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code failed;
    for (const auto& entry : std::filesystem::directory_iterator(folder, failed))
        if (entry.path().extension() == ".bsdf") files.push_back(entry.path());
    if (failed) throw Error(folder.string(), "", "a folder that can be read", failed.message());
    std::sort(files.begin(), files.end());
    return files;
}

constexpr std::array<std::string_view, 6> kFitted = {"phong",         "ward", "lafortune",
                                                     "cook-torrance", "he",   "ggx"};

// A model has the same color for all materials.
Rgb color_of(std::string_view model) {
    constexpr std::array<std::size_t, 6> kSeries = {0, 1, 2, 3, 5, 6};  // 4, black, is measured
    const auto place = std::find(kFitted.begin(), kFitted.end(), model) - kFitted.begin();
    return plot::series_color(kSeries.at(static_cast<std::size_t>(place)));
}

std::vector<plot::LegendEntry> legend_of_fits() {
    std::vector<plot::LegendEntry> legend = {{"measured", plot::kInk, {}}};
    for (const std::string_view model : kFitted)
        legend.push_back({std::string(model), color_of(model), {}});
    return legend;
}

// f cos in the plane of incidence, green channel: the material and its three best models.
plot::Panel curves_panel(const MeasuredFit& fit, const PlaneCurve& curve) {
    std::vector<plot::Series> lines;
    double top = 0;
    const auto add = [&](const Rgb& color, double width, const std::vector<FitRgb>& f) {
        std::vector<plot::Point> points;
        for (std::size_t i = 0; i < curve.theta_deg.size(); ++i) {
            const double y = f[i][1] * std::cos(curve.theta_deg[i] / kDegreesPerRadian);
            points.push_back({curve.theta_deg[i], y});
            top = std::max(top, y);
        }
        lines.push_back({"", std::move(points), color, {}, width});
    };
    for (std::size_t m = 0; m < std::min<std::size_t>(3, fit.fits.size()); ++m)
        add(color_of(fit.fits[m].model), 1.5, curve.fitted[m]);
    add(plot::kInk, 2.2, curve.measured);
    const double low = std::max(top * 1e-3, 1e-6);
    plot::LinePlot plot{{"θ_{i} [deg]", {plot::ScaleKind::linear, -90, 90}},
                        {"f cos θ_{i} [1/sr], green", {plot::ScaleKind::log, low, top * 1.2}},
                        lines};
    return plot::line_panel(std::move(plot), fmt::format("seen from {:.0f}°", curve.theta_o_deg),
                            330, 250);
}

double error_over_black(const MeasuredFit& fit, const BrdfFit& of) {
    return of.error(fit.metric) /
           (fit.metric == FitMetric::rms ? fit.of_black.rms : fit.of_black.log_rms);
}

// Is the error of a model with a microfacet distribution below those of both Phong and Ward?
bool microfacets_win(const MeasuredFit& fit) {
    double facets = std::numeric_limits<double>::infinity(), others = facets;
    for (const BrdfFit& of : fit.fits) {
        if (of.model == "cook-torrance" || of.model == "he" || of.model == "ggx")
            facets = std::min(facets, of.error(fit.metric));
        if (of.model == "phong" || of.model == "ward")
            others = std::min(others, of.error(fit.metric));
    }
    return facets < others;
}

}  // namespace

std::optional<GalleryPage> b12_models(GalleryTools&) {
    GalleryPage page;
    page.drawn = true;
    page.figure.title = "B12: lobes of the reflection models at matched widths";
    const std::vector<BrdfSubject> subjects = matched_models();
    for (const plot::ScaleKind kind : {plot::ScaleKind::linear, plot::ScaleKind::log}) {
        plot::PanelRow row{kind == plot::ScaleKind::linear ? "linear" : "logarithmic", {}, {}};
        for (const double incidence : {kMatchedAt, 60.0, 75.0}) {
            plot::PolarPlot polar;
            polar.subjects = subjects;
            polar.incidence_deg = incidence;
            polar.kind = kind;
            row.panels.push_back(
                plot::polar_panel(polar, fmt::format("light at {:.0f}°", incidence), 340));
        }
        page.figure.rows.push_back(std::move(row));
    }
    page.figure.legend = plot::legend_of(std::span<const BrdfSubject>(subjects));
    page.commands = {command_of(subjects, "polar")};
    std::string widths, peaks;
    double low = std::numeric_limits<double>::infinity(), high = 0;
    for (const BrdfSubject& s : subjects) {
        widths += fmt::format("{}{} {:.1f}°", widths.empty() ? "" : ", ", s.label, width_deg(s));
        const double rise = plot::peak_of(s, plot::incident(75, 180)).f / peak_f(s);
        low = std::min(low, rise);
        high = std::max(high, rise);
        peaks += fmt::format("{}{} {:.1f}", peaks.empty() ? "" : ", ", s.label, rise);
    }
    page.measured = {
        "width at half the peak, light at 30°: " + widths,
        "peak with light at 75° over that at 30°, the models' own idea of grazing light: " + peaks};
    page.verdict = high > 2 * low ? Verdict::borne_out : Verdict::contradicted;
    page.remark =
        "He's model on the slide is called anisotropic; it has one correlation length and is "
        "isotropic. Lafortune's bracket is clamped at 0.";
    return page;
}

std::optional<GalleryPage> b12_measured(GalleryTools& tools) {
    const std::filesystem::path& folder = tools.request.measured;
    const std::vector<std::filesystem::path> files =
        folder.empty() ? std::vector<std::filesystem::path>{} : materials_in(folder);
    if (files.empty()) {
        tools.warnings.push_back(
            folder.empty()
                ? "b12-measured is left out: --measured names no folder of .bsdf files"
                : fmt::format("b12-measured is left out: no .bsdf file in {}", folder.string()));
        return std::nullopt;
    }
    GalleryPage page;
    page.drawn = true;
    page.figure.title = "Measured materials (RGL) and their best fits";
    const std::vector<std::string> names(kFitted.begin(), kFitted.end());
    std::size_t won = 0;
    for (const std::filesystem::path& file : files) {
        MeasuredFitOptions options;
        if (tools.quick()) options.samples = 1500;
        const MeasuredFit fit = fit_measured(file, names, tools.progress, options);
        plot::PanelRow row{file.stem().string(), {}, {}};
        for (const PlaneCurve& curve : fit.curves) row.panels.push_back(curves_panel(fit, curve));
        std::string ranking;
        for (const BrdfFit& f : fit.fits)
            ranking += fmt::format("{}{} {:.3f}", ranking.empty() ? "" : ", ", f.model,
                                   error_over_black(fit, f));
        page.measured.push_back(
            fmt::format("{}: error over that of black: {}", file.stem().string(), ranking));
        page.commands.push_back(fmt::format("burnish brdf fit {} --model {} -o OUT.csv",
                                            file.filename().string(), fmt::join(names, ",")));
        if (!row.panels.empty()) row.panels.front().note = "best: " + fit.fits.front().model;
        page.figure.rows.push_back(std::move(row));
        won += microfacets_win(fit);
    }
    page.figure.legend = legend_of_fits();
    page.measured.push_back(fmt::format(
        "a model with a microfacet distribution (cook-torrance, he, ggx) comes closer than Phong's "
        "and Ward's both on {} of {} materials",
        won, files.size()));
    page.verdict = won == files.size() ? Verdict::borne_out
                   : won > 0           ? Verdict::partly
                                       : Verdict::contradicted;
    page.remark =
        "Drawn are the three models that fit each material best. Materials: "
        "Dupuy & Jakob, RGL EPFL material database, CC0.";
    return page;
}

}  // namespace burnish
