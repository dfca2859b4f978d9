// `burnish brdf fit`: fits reflection models to measured materials and reports the errors of each.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/fit_brdf.hpp"
#include "burnish/progress.hpp"
#include "formats/bsdf/rgl_brdf.hpp"
#include "jobs/models/plot.hpp"

namespace burnish {

struct MeasuredFitOptions {
    FitSettings fit;       // anisotropic is set by the file
    int samples = 6000;    // directions wi over all incident directions, 200 to 200000
    double most_deg = 80;  // directions closer to the horizon are omitted, as in Ngan et al.:
                           // measurements are unreliable there
};

// f cos(theta_i) in the plane of incidence.
struct PlaneCurve {
    double theta_o_deg = 0;                   // of the file's incident direction
    std::vector<double> theta_deg;            // of wi, increasing; above 0 on the mirror side
    std::vector<FitRgb> measured;             // f, without the cosine
    std::vector<std::vector<FitRgb>> fitted;  // [model][angle], models in the order of the fits
};

struct MeasuredFit {
    std::string file, description;
    bool isotropic = true;
    FitMetric metric = FitMetric::rms;
    std::size_t samples = 0;
    double most_deg = 0;
    FitErrors of_black;         // errors of f = 0: the root mean square of the measured values
    std::vector<BrdfFit> fits;  // best first, by `metric`
    std::vector<PlaneCurve> curves;
};

// `models`: some of fit_model_names(); empty: all of them. Curves are for the file's incident
// directions nearest to 30, 50 and 70 degrees. Throws Error for files that cannot be read,
// UsageError for unknown models.
MeasuredFit fit_measured(const std::filesystem::path& path, std::span<const std::string> models,
                         const Progress& progress, const MeasuredFitOptions& options = {});

// The directions and values that are fitted. For every incident direction of the file within
// most_deg, half of the directions follow the material's own density and half the cosine (balance
// heuristic), so that narrow peaks and wide bases both count by solid angle.
std::vector<BrdfSample> measured_samples(const RglBrdf& brdf, const MeasuredFitOptions& options);

// "all" or names separated by commas; throws UsageError naming `where`.
std::vector<std::string> parse_fit_models(std::string_view text, std::string_view where);

struct MeasuredFitRequest {
    std::vector<std::string> inputs;
    std::vector<std::string> models;  // none: all
    std::string output;               // .csv or .json; "": none
    PlotOutput plot;                  // path "": none
    std::string command;              // for metadata
    MeasuredFitOptions options;
};

// Fits every input; writes `output` and `plot` if they are named. Returns the tables as text lines.
std::string fit_measured_files(const MeasuredFitRequest& request, const Progress& progress);

}  // namespace burnish
