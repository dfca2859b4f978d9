// Fits a reflection model to samples of a BRDF by non-linear least squares:
//
//   f = kd / pi + ks lobe(shape)      kd, ks for each color, one shape for all
//
// kd is within [0, 1], ks within the range of the model's own ks ([0, 1] where it has none), the
// shape within the ranges of shading/brdf_models.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/fit_models.hpp"
#include "burnish/mdf.hpp"
#include "burnish/progress.hpp"

namespace BURNISH_API burnish {

using FitRgb = std::array<double, 3>;

struct BrdfSample {
    Direction<double> wi, wo;  // unit, above the horizon
    FitRgb f;                  // per steradian, without the cosine
    double weight;             // solid angle it stands for; only ratios matter
};

// What is squared and averaged over solid angle and colors, x being f cos(theta_i).
//  rms  x: the metric of Ngan, Durand & Matusik, "Experimental Analysis of BRDF Models", EGSR 2005
//  log  ln(1 + x): Low, Kronander, Ynnerman & Unger, "BRDF Models for Accurate and Efficient
//       Rendering of Glossy Surfaces", ACM TOG 31(1), 2012. Peaks do not drown everything else
enum class FitMetric { rms = 0, log = 1 };
std::span<const std::string_view> fit_metric_names();

struct FitSettings {
    FitMetric metric = FitMetric::rms;
    bool anisotropic = false;  // let models that can be wider one way than the other
    int most_iterations = 80;  // of each search
    int searches = 3;          // from the best of the starts
};

struct BrdfFit {
    std::string model;
    LobeParameters lobe{};  // in the order of its BrdfModel, own ks at 1
    std::size_t lobe_size = 0;
    FitRgb kd{}, ks{};
    // Which numbers ended at an end of the range that was searched: the best value may lie beyond
    // it, or the number does not matter. Parameters that the fit holds fixed are never marked.
    std::array<bool, kMostBrdfParameters> lobe_at_bound{};
    std::array<bool, 3> kd_at_bound{}, ks_at_bound{};
    double rms = 0, log_rms = 0;  // by either metric, whichever was fitted
    double start = 0;             // error by the fitted metric where the best search began
    int iterations = 0;
    bool converged = false;

    double error(FitMetric metric) const { return metric == FitMetric::rms ? rms : log_rms; }
};

// Throws Error when there are no samples or their weights do not add up to something, and
// Interrupted when `progress` is cancelled; nothing is reported to it. Numbers do not depend on the
// number of threads.
BrdfFit fit_brdf(const FitModel& model, std::span<const BrdfSample> samples,
                 const FitSettings& settings, const Progress& progress = {});

// f of a fit; 0 below the horizon.
FitRgb fitted_value(const BrdfFit& fit, Direction<double> wi, Direction<double> wo);

// The same two errors of any other answer for the samples, and those of answering 0: what relative
// errors are relative to.
struct FitErrors {
    double rms = 0, log_rms = 0;
};
FitErrors errors_of(std::span<const BrdfSample> samples, std::span<const FitRgb> answers);

}  // namespace burnish
