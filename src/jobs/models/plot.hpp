// burnish mdf plot and burnish brdf plot: figures of distributions and reflection models.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/parameters.hpp"
#include "burnish/plot/brdf_plot.hpp"
#include "burnish/plot/figure.hpp"
#include "burnish/plot/mdf_plot.hpp"
#include "burnish/progress.hpp"
#include "burnish/shading_names.hpp"

namespace burnish {

// Path of a figure and size of its parts.
struct PlotOutput {
    std::filesystem::path path;  // .png or .svg
    std::string command;         // for metadata
    double panel_px = 0;         // width of a panel; 0: the default of its kind
    double pixel_ratio = 2;      // of .png: pixels per px
};

enum class MdfPlotKind { disk = 0, grid = 1, profile = 2 };
std::span<const std::string_view> mdf_plot_kind_names();

// Parameters that apply: e_x and e_y, or alpha_x and alpha_y. One pair sets every distribution (e =
// 2/alpha^2 - 2); without a pair, e = 200, 10.
struct MdfPlotRequest {
    ParameterValues values;
    std::vector<Mdf> mdfs;
    std::vector<Method> methods;
    std::vector<Direction<double>> normals;  // unit, n.z > 0
    MdfPlotKind kind = MdfPlotKind::disk;
    plot::Normalization normalization = plot::Normalization::paper;
    plot::ScaleKind scale = plot::ScaleKind::linear;
    std::optional<double> high;      // top of the scale
    plot::Point point{-0.25, 0.45};  // p of the grid
    PlotOutput output;
};

// disk: a row for every distribution and normal, a column for every method (with one method: a
// column for every normal). grid: a row for every distribution, normal and method, three columns.
// profile: a row for every normal. Throws UsageError for empty lists, too many panels, and a grid
// of normal-map.
plot::Figure mdf_figure(const MdfPlotRequest& request);
void plot_mdf(const MdfPlotRequest& request, const Progress& progress);

enum class BrdfPlotKind { polar = 0, surface = 1, albedo = 2 };
std::span<const std::string_view> brdf_plot_kind_names();

struct BrdfPlotRequest {
    // Parameters that apply: the roughness pair as above, f0 (default 1), mdf (of `microfacet`).
    ParameterValues values;
    // Names of models, with optional parameters of their own: "ggx", "phong:n=50:ks=2". Other
    // parameters follow from the roughness pair: m = sqrt(alpha_x alpha_y), exponents 2/m^2 - 2,
    // tau = 2 sigma/m; ks = 1, or (n+2)/(2 pi) for a model that scales a power of a cosine. Or
    // measured materials (FILE.bsdf), of which the luminance is drawn.
    std::vector<std::string> brdfs;
    BrdfPlotKind kind = BrdfPlotKind::polar;
    std::vector<plot::ScaleKind> scales{plot::ScaleKind::linear};
    std::vector<double> incidences_deg{45};  // 0 to 89.9
    double azimuth_deg = 0;                  // of the incident direction
    std::optional<double> cut_deg;           // of the polar cut; default: the plane of incidence
    std::optional<double> high;              // value at radius 1 of the polar cut
    plot::SurfaceView view;
    PlotOutput output;
};

// The models with all their parameters. Throws UsageError naming the model, the parameter and its
// range; for unknown names it suggests the nearest. Throws Error for measured materials that cannot
// be read.
std::vector<plot::BrdfSubject> brdf_subjects(const BrdfPlotRequest& request);

// polar: a row for every scale, a column for every incidence, a line for every model. surface: rows
// of models for every scale and incidence. albedo: light along the tangent and along the bitangent.
plot::Figure brdf_figure(const BrdfPlotRequest& request);
void plot_brdf(const BrdfPlotRequest& request, const Progress& progress);

}  // namespace burnish
