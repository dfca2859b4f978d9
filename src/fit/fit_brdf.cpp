#include "burnish/fit_brdf.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "burnish/error.hpp"
#include "burnish/progress.hpp"
#include "core/constants.hpp"
#include "core/parallel.hpp"
#include "fit/least_squares.hpp"

namespace burnish {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::array<std::string_view, 2> kMetricNames = {"rms", "log"};

// Lobes may reach 1e300 at the horizon; products of such numbers would not be finite.
constexpr double kMostLobe = 1e12;
// Number of samples, about, on which starts are compared.
constexpr std::size_t kStartSamples = 800;
// Share of its range within which a number is at a bound. Steps are cut at the bounds, so that a
// number that is held there is at it exactly or by rounding.
constexpr double kAtBound = 1e-9;
// Of central differences: numbers of a search are logarithms or shares, of order 1.
constexpr double kDifference = 1e-6;

double metric_of(FitMetric metric, double x) {
    return metric == FitMetric::rms ? x : std::log1p(x);
}
double slope_of(FitMetric metric, double x) {
    return metric == FitMetric::rms ? 1 : 1 / (1 + x);
}

// Least squares of y = a kd + b ks for one color, from its sums.
struct TwoSums {
    double aa = 0, ab = 0, bb = 0, ay = 0, by = 0;

    double cost(double kd, double ks) const {  // but for the sum of y^2
        return kd * kd * aa + ks * ks * bb + 2 * (kd * ks * ab - kd * ay - ks * by);
    }
    // Within [0, 1] x [0, most]: inside, or on one of the four edges.
    std::array<double, 2> solve(double most) const {
        const double determinant = aa * bb - ab * ab;
        std::array<double, 2> best{0, 0};
        const auto consider = [&](double kd, double ks) {
            const std::array<double, 2> point{std::clamp(kd, 0.0, 1.0), std::clamp(ks, 0.0, most)};
            if (cost(point[0], point[1]) < cost(best[0], best[1])) best = point;
        };
        if (determinant > 1e-12 * aa * bb) {
            const double kd = (ay * bb - by * ab) / determinant;
            const double ks = (by * aa - ay * ab) / determinant;
            if (kd >= 0 && kd <= 1 && ks >= 0 && ks <= most) return {kd, ks};
        }
        for (const double kd : {0.0, 1.0})
            if (bb > 0) consider(kd, (by - kd * ab) / bb);
        for (const double ks : {0.0, most})
            if (aa > 0) consider((ay - ks * ab) / aa, ks);
        return best;
    }
};

bool at_bound(double x, double low, double high) {
    return std::min(x - low, high - x) <= kAtBound * (high - low);
}

// Which parameters of the lobe depend on a number of the search that is at a bound.
std::array<bool, kMostBrdfParameters> lobe_at_bound(const FitVariant& variant,
                                                    std::span<const double> q) {
    std::array<bool, kMostBrdfParameters> marked{};
    const LobeParameters lobe = variant.lobe(q);
    for (std::size_t j = 0; j < variant.free.size(); ++j) {
        const FreeParameter& range = variant.free[j];
        if (!at_bound(q[j], range.low, range.high)) continue;
        std::vector<double> inside(q.begin(), q.end());
        inside[j] = 0.5 * (range.low + range.high);
        const LobeParameters other = variant.lobe(inside);
        for (std::size_t i = 0; i < lobe.size(); ++i) marked[i] |= other[i] != lobe[i];
    }
    return marked;
}

// One variant of a model over the samples.
class Search {
  public:
    Search(const FitModel& model, const FitVariant& variant, std::span<const BrdfSample> samples,
           FitMetric metric, const Progress& progress);

    // Numbers of the search: the shape, kd, ks.
    Index shape_size() const { return static_cast<Index>(variant_.free.size()); }
    struct Start {
        std::vector<double> q;
        std::array<FitRgb, 2> colors{};  // kd, ks
        double sum = std::numeric_limits<double>::infinity();
    };
    Start start_at(const std::vector<double>& q) const;
    LeastSquaresResult run(const Start& start, int most_iterations) const;
    BrdfFit fit_of(const LeastSquaresResult& result) const;

  private:
    void lobes(const LobeParameters& p, std::size_t stride, std::vector<double>& values) const;
    LobeParameters lobe_at(const VectorXd& x) const {
        return variant_.lobe(std::span(x.data(), static_cast<std::size_t>(shape_size())));
    }
    void evaluate(const VectorXd& x, VectorXd& residuals, MatrixXd* derivatives) const;
    void add_shape_derivatives(const VectorXd& x, const MatrixXd& slopes,
                               MatrixXd& derivatives) const;

    const FitModel& model_;
    const FitVariant& variant_;
    std::span<const BrdfSample> samples_;
    FitMetric metric_;
    const Progress& progress_;
    std::vector<double> root_weights_;  // their squares add up to 1 / 3 over the samples
};

Search::Search(const FitModel& model, const FitVariant& variant,
               std::span<const BrdfSample> samples, FitMetric metric, const Progress& progress)
    : model_(model), variant_(variant), samples_(samples), metric_(metric), progress_(progress) {
    double sum = 0;
    for (const BrdfSample& sample : samples) sum += sample.weight;
    if (!(sum > 0 && std::isfinite(sum)))
        throw Error("", "samples of a BRDF", "some with a weight", "none");
    for (const BrdfSample& sample : samples)
        root_weights_.push_back(std::sqrt(sample.weight / (3 * sum)));
}

void Search::lobes(const LobeParameters& p, std::size_t stride, std::vector<double>& values) const {
    progress_.throw_if_cancelled();
    values.resize((samples_.size() + stride - 1) / stride);
    parallel_for(values.size(), 128, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const BrdfSample& sample = samples_[i * stride];
            values[i] = std::min(model_.brdf->value_f64(p, sample.wi, sample.wo), kMostLobe);
        }
    });
}

// kd and ks that fit best for a given shape: linear, so solved at once. For the logarithms, errors
// are weighed by the slope at the measured value.
Search::Start Search::start_at(const std::vector<double>& q) const {
    Start start{q, {}, 0};
    const std::size_t stride = std::max<std::size_t>(samples_.size() / kStartSamples, 1);
    std::vector<double> lobe;
    lobes(variant_.lobe(q), stride, lobe);
    for (std::size_t c = 0; c < 3; ++c) {
        TwoSums sums;
        for (std::size_t i = 0; i < lobe.size(); ++i) {
            const BrdfSample& sample = samples_[i * stride];
            const double y = sample.f[c] * sample.wi.z;
            const double w = root_weights_[i * stride] * slope_of(metric_, y);
            const double a = w * sample.wi.z / kPi, b = w * lobe[i] * sample.wi.z;
            sums.aa += a * a;
            sums.ab += a * b;
            sums.bb += b * b;
            sums.ay += a * w * y;
            sums.by += b * w * y;
        }
        const auto [kd, ks] = sums.solve(model_.most_scale);
        start.colors[0][c] = kd;
        start.colors[1][c] = ks;
        for (std::size_t i = 0; i < lobe.size(); ++i) {
            const BrdfSample& sample = samples_[i * stride];
            const double error = metric_of(metric_, sample.f[c] * sample.wi.z) -
                                 metric_of(metric_, (kd / kPi + ks * lobe[i]) * sample.wi.z);
            start.sum += std::pow(root_weights_[i * stride] * error, 2);
        }
    }
    return start;
}

void Search::evaluate(const VectorXd& x, VectorXd& residuals, MatrixXd* derivatives) const {
    const Index n = shape_size(), count = static_cast<Index>(samples_.size());
    std::vector<double> lobe;
    lobes(lobe_at(x), 1, lobe);
    residuals.resize(3 * count);
    MatrixXd slopes;  // of the residual by f cos: a row a sample
    if (derivatives) {
        slopes.resize(count, 3);
        derivatives->setZero(3 * count, x.size());
    }
    for (Index i = 0; i < count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const BrdfSample& sample = samples_[k];
        for (Index c = 0; c < 3; ++c) {
            const double cosine = sample.wi.z;
            const double value = (x[n + c] / kPi + x[n + 3 + c] * lobe[k]) * cosine;
            const double measured = sample.f[static_cast<std::size_t>(c)] * cosine;
            residuals[3 * i + c] =
                root_weights_[k] * (metric_of(metric_, value) - metric_of(metric_, measured));
            if (!derivatives) continue;
            slopes(i, c) = root_weights_[k] * slope_of(metric_, value) * cosine;
            (*derivatives)(3 * i + c, n + c) = slopes(i, c) / kPi;
            (*derivatives)(3 * i + c, n + 3 + c) = slopes(i, c) * lobe[k];
        }
    }
    if (derivatives) add_shape_derivatives(x, slopes, *derivatives);
}

// Of the lobe by differences, central ones but at the bounds.
void Search::add_shape_derivatives(const VectorXd& x, const MatrixXd& slopes,
                                   MatrixXd& derivatives) const {
    const Index n = shape_size();
    std::vector<double> above, below;
    for (Index j = 0; j < n; ++j) {
        const FreeParameter& bounds = variant_.free[static_cast<std::size_t>(j)];
        VectorXd up = x, down = x;
        up[j] = std::min(x[j] + kDifference, bounds.high);
        down[j] = std::max(x[j] - kDifference, bounds.low);
        lobes(lobe_at(up), 1, above);
        lobes(lobe_at(down), 1, below);
        const double width = up[j] - down[j];
        for (Index i = 0; i < slopes.rows(); ++i) {
            const auto k = static_cast<std::size_t>(i);
            const double slope = (above[k] - below[k]) / width;
            for (Index c = 0; c < 3; ++c)
                derivatives(3 * i + c, j) = slopes(i, c) * x[n + 3 + c] * slope;
        }
    }
}

LeastSquaresResult Search::run(const Start& start, int most_iterations) const {
    const Index n = shape_size();
    LeastSquaresProblem problem;
    VectorXd x(n + 6);
    problem.low.setZero(n + 6);
    problem.high.resize(n + 6);
    for (Index j = 0; j < n; ++j) {
        const auto k = static_cast<std::size_t>(j);
        problem.low[j] = variant_.free[k].low;
        problem.high[j] = variant_.free[k].high;
        x[j] = start.q[k];
    }
    for (Index c = 0; c < 3; ++c) {
        problem.high[n + c] = 1;
        problem.high[n + 3 + c] = model_.most_scale;
        x[n + c] = start.colors[0][static_cast<std::size_t>(c)];
        x[n + 3 + c] = start.colors[1][static_cast<std::size_t>(c)];
    }
    problem.evaluate = [this](const VectorXd& at, VectorXd& residuals, MatrixXd* derivatives) {
        evaluate(at, residuals, derivatives);
    };
    return minimize(problem, x, most_iterations);
}

BrdfFit Search::fit_of(const LeastSquaresResult& result) const {
    const Index n = shape_size();
    BrdfFit fit;
    fit.model = model_.name;
    fit.lobe = lobe_at(result.x);
    fit.lobe_size = model_.brdf->parameters.size();
    // exp(ln high) may be above high by a rounding.
    for (std::size_t i = 0; i < fit.lobe_size; ++i) {
        const ShapeParameter& p = model_.brdf->parameters[i];
        fit.lobe[i] = std::clamp(fit.lobe[i], p.low, p.high);
    }
    fit.lobe_at_bound =
        lobe_at_bound(variant_, std::span(result.x.data(), static_cast<std::size_t>(n)));
    for (Index c = 0; c < 3; ++c) {
        const auto k = static_cast<std::size_t>(c);
        fit.kd[k] = result.x[n + c];
        fit.ks[k] = result.x[n + 3 + c];
        fit.kd_at_bound[k] = at_bound(fit.kd[k], 0, 1);
        fit.ks_at_bound[k] = at_bound(fit.ks[k], 0, model_.most_scale);
    }
    fit.start = std::sqrt(result.start_sum);
    fit.iterations = result.iterations;
    fit.converged = result.converged;
    return fit;
}

// From the best few of the variant's starts.
LeastSquaresResult best_of(const Search& search, const FitVariant& variant,
                           const FitSettings& settings) {
    std::vector<Search::Start> starts;
    for (const auto& q : variant.starts) starts.push_back(search.start_at(q));
    std::stable_sort(starts.begin(), starts.end(),
                     [](const auto& a, const auto& b) { return a.sum < b.sum; });
    const auto count =
        std::min(starts.size(), static_cast<std::size_t>(std::max(settings.searches, 1)));
    LeastSquaresResult best = search.run(starts[0], settings.most_iterations);
    for (std::size_t i = 1; i < count; ++i) {
        LeastSquaresResult next = search.run(starts[i], settings.most_iterations);
        if (next.sum < best.sum) best = std::move(next);
    }
    return best;
}

// The isotropic optimum with one number more, and stretched either way; never worse than it.
LeastSquaresResult widened(const FitModel& model, const Search& search,
                           const LeastSquaresResult& isotropic, std::size_t isotropic_size,
                           int most_iterations) {
    const std::vector<double> q = model.widen(std::span(isotropic.x.data(), isotropic_size));
    std::optional<LeastSquaresResult> best;
    for (const double stretch : {0.0, model.stretch, -model.stretch}) {
        std::vector<double> from = q;
        from[0] -= stretch;
        from[1] += stretch;
        Search::Start start = search.start_at(from);
        if (stretch == 0) {
            const auto n = static_cast<Index>(isotropic_size);
            for (Index c = 0; c < 3; ++c) {
                start.colors[0][static_cast<std::size_t>(c)] = isotropic.x[n + c];
                start.colors[1][static_cast<std::size_t>(c)] = isotropic.x[n + 3 + c];
            }
        }
        LeastSquaresResult next = search.run(start, most_iterations);
        if (!best || next.sum < best->sum) best = std::move(next);
    }
    return *best;
}

}  // namespace

std::span<const std::string_view> fit_metric_names() {
    return kMetricNames;
}

BrdfFit fit_brdf(const FitModel& model, std::span<const BrdfSample> samples,
                 const FitSettings& settings, const Progress& progress) {
    std::optional<BrdfFit> best;
    double best_sum = 0;
    const auto consider = [&](const Search& search, const LeastSquaresResult& result) {
        if (best && result.sum >= best_sum) return;
        best = search.fit_of(result);
        best_sum = result.sum;
    };
    for (std::size_t i = 0; i < model.isotropic.size(); ++i) {
        const Search search(model, model.isotropic[i], samples, settings.metric, progress);
        const LeastSquaresResult result = best_of(search, model.isotropic[i], settings);
        consider(search, result);
        if (!settings.anisotropic || model.anisotropic.empty()) continue;
        const Search wider(model, model.anisotropic[i], samples, settings.metric, progress);
        consider(wider, widened(model, wider, result, model.isotropic[i].free.size(),
                                settings.most_iterations));
    }
    std::vector<FitRgb> answers(samples.size());
    parallel_for(samples.size(), 128, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            answers[k] = fitted_value(*best, samples[k].wi, samples[k].wo);
    });
    const FitErrors errors = errors_of(samples, answers);
    best->rms = errors.rms;
    best->log_rms = errors.log_rms;
    return *best;
}

FitRgb fitted_value(const BrdfFit& fit, Direction<double> wi, Direction<double> wo) {
    if (!(wi.z > 0 && wo.z > 0)) return {};
    const auto models = fit_models();
    const auto model = std::find_if(models.begin(), models.end(), [&](const FitModel& candidate) {
        return candidate.name == fit.model;
    });
    if (model == models.end()) throw Error("", "model of a fit", "a known one", shown(fit.model));
    const double lobe = std::min(model->brdf->value_f64(fit.lobe, wi, wo), kMostLobe);
    FitRgb f{};
    for (std::size_t c = 0; c < 3; ++c) f[c] = fit.kd[c] / kPi + fit.ks[c] * lobe;
    return f;
}

FitErrors errors_of(std::span<const BrdfSample> samples, std::span<const FitRgb> answers) {
    double weights = 0, plain = 0, logarithmic = 0;
    for (std::size_t k = 0; k < samples.size(); ++k) {
        const BrdfSample& sample = samples[k];
        weights += 3 * sample.weight;
        for (std::size_t c = 0; c < 3; ++c) {
            const double x = sample.f[c] * sample.wi.z, y = answers[k][c] * sample.wi.z;
            plain += sample.weight * (y - x) * (y - x);
            logarithmic += sample.weight * std::pow(std::log1p(y) - std::log1p(x), 2);
        }
    }
    return {std::sqrt(plain / weights), std::sqrt(logarithmic / weights)};
}

}  // namespace burnish
