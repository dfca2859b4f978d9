#include "jobs/models/brdf_fit_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "burnish/plot/brdf_plot.hpp"
#include "core/constants.hpp"
#include "jobs/models/measured_lobe.hpp"

namespace burnish {
namespace {

constexpr double kPanelWidth = 340;

// The models that a figure draws, in the order in which they appear: a model has the same color for
// all materials.
std::vector<std::string> models_of(std::span<const MeasuredFit> fits, std::size_t most_models) {
    std::vector<std::string> models;
    for (const MeasuredFit& fit : fits)
        for (std::size_t m = 0; m < std::min(most_models, fit.fits.size()); ++m)
            if (std::find(models.begin(), models.end(), fit.fits[m].model) == models.end())
                models.push_back(fit.fits[m].model);
    return models;
}

plot::Series series_of(const std::string& model, const std::vector<std::string>& models,
                       std::vector<plot::Point> points) {
    // Series 4 is black, as the measurement is, and 6 has the color of the light; with 7 the same
    // colors begin again, dashed.
    constexpr std::array<std::size_t, 10> kSeries = {0, 1, 2, 3, 5, 7, 8, 9, 10, 12};
    const auto place =
        static_cast<std::size_t>(std::find(models.begin(), models.end(), model) - models.begin());
    plot::Series series = plot::series(kSeries.at(place), model, std::move(points));
    series.width = 1.5;
    return series;
}

plot::Series series_of_measured(std::vector<plot::Point> points) {
    return {"measured", std::move(points), plot::kInk, {}, 2.6};
}

std::vector<plot::Point> points_of(const PlaneCurve& curve, const std::vector<FitRgb>& f) {
    std::vector<plot::Point> points;
    for (std::size_t i = 0; i < f.size(); ++i)
        points.push_back({curve.theta_deg[i] * kDegree, luminance_of(f[i])});
    return points;
}

plot::Panel panel_of(const MeasuredFit& fit, std::size_t index, plot::ScaleKind kind,
                     const std::vector<std::string>& models, std::size_t most_models,
                     double width) {
    const PlaneCurve& curve = fit.curves[index];
    plot::PolarCurves polar;
    polar.kind = kind;
    polar.light_deg = curve.theta_o_deg;
    // First, so that the fits lie on it.
    polar.curves.push_back(series_of_measured(points_of(curve, curve.measured)));
    for (std::size_t m = 0; m < std::min(most_models, fit.fits.size()); ++m)
        polar.curves.push_back(
            series_of(fit.fits[m].model, models, points_of(curve, curve.fitted[m])));
    return plot::polar_curves_panel(
        polar, fmt::format("light at {}\u00b0", plot::number_text(curve.theta_o_deg)),
        width > 0 ? width : kPanelWidth);
}

std::string ranking(const MeasuredFit& fit, std::size_t most_models) {
    const double black = fit.metric == FitMetric::rms ? fit.of_black.rms : fit.of_black.log_rms;
    std::string text;
    for (std::size_t m = 0; m < std::min(most_models, fit.fits.size()); ++m)
        text += fmt::format("{}{} {:.1f} %", m == 0 ? "" : ", ", fit.fits[m].model,
                            black > 0 ? 100 * fit.fits[m].error(fit.metric) / black : 0.0);
    return text;
}

}  // namespace

plot::Figure fit_figure(std::span<const MeasuredFit> fits, std::size_t most_models,
                        double panel_px) {
    plot::Figure figure;
    figure.title = "Measured materials and the models that fit them";
    const std::vector<std::string> models = models_of(fits, most_models);
    std::vector<plot::Series> drawn = {series_of_measured({})};
    for (const std::string& model : models) drawn.push_back(series_of(model, models, {}));
    for (const MeasuredFit& fit : fits) {
        for (const plot::ScaleKind kind : {plot::ScaleKind::linear, plot::ScaleKind::log}) {
            plot::PanelRow row{std::filesystem::path(fit.file).stem().string(), {}, {}};
            for (std::size_t i = 0; i < fit.curves.size(); ++i)
                row.panels.push_back(panel_of(fit, i, kind, models, most_models, panel_px));
            figure.rows.push_back(std::move(row));
        }
        figure.caption += fmt::format(
            "{}: {} over that of black, {}. ", std::filesystem::path(fit.file).stem().string(),
            fit.metric == FitMetric::rms ? "rms error" : "logarithmic error",
            ranking(fit, most_models));
    }
    figure.legend = plot::legend_of(drawn);
    figure.caption =
        "Luminance of f per steradian, without the cosine, in the plane of incidence. The light "
        "stands where the material was measured; angles above 85\u00b0 are not drawn. " +
        figure.caption;
    figure.caption.pop_back();
    return figure;
}

}  // namespace burnish
