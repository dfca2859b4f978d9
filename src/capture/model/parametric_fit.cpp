#include "capture/model/parametric_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "burnish/f32.hpp"
#include "capture/model/strengths.hpp"
#include "fit/levenberg_marquardt.hpp"

namespace burnish {

namespace {

constexpr std::array<std::string_view, 4> kNames = {"ward-isotropic", "ward", "ggx",
                                                    "ashikhmin-shirley"};
// Bounds of both alphas. Lights a few degrees apart do not resolve a lobe narrower than the lower
// bound. A lobe wider than the upper bound cannot be distinguished from diffuse light.
constexpr float kLeastAlpha = 0.01f, kMostAlpha = 1.2f;

// ln alpha along the groove, ln alpha across it, the groove in radians.
using Parameters = std::array<float, 3>;

bool is_ward(ParametricModel model) {
    return model == ParametricModel::ward || model == ParametricModel::ward_isotropic;
}

struct Lobe {
    int brdf;
    f32::Lobe lobe;
    float cosine, sine;  // of the groove's angle
    float eta;
};

Lobe lobe_of(ParametricModel model, const Parameters& p, float eta) {
    const float along = std::exp(p[0]), across = std::exp(p[1]);
    switch (model) {
        case ParametricModel::ggx:
            return {f32::kBrdfMicrofacetSeparable,
                    f32::lobe_from_alpha(f32::kMdfGgx, along, across), std::cos(p[2]),
                    std::sin(p[2]), eta};
        case ParametricModel::ashikhmin_shirley:
            return {f32::kBrdfAshikhminShirley,
                    f32::lobe_from_alpha(f32::kMdfAshikhminShirley, along, across), std::cos(p[2]),
                    std::sin(p[2]), eta};
        default:
            return {f32::kBrdfWard, f32::lobe_from_alpha(f32::kMdfBeckmann, along, across),
                    std::cos(p[2]), std::sin(p[2]), 0.0f};
    }
}

float shape(const Lobe& l, const f32::Perturbation& flat, const Vec3f& i, const Vec3f& o) {
    const f32::vec3 wi(l.cosine * i[0] + l.sine * i[1], l.cosine * i[1] - l.sine * i[0], i[2]);
    const f32::vec3 wo(l.cosine * o[0] + l.sine * o[1], l.cosine * o[1] - l.sine * o[0], o[2]);
    return f32::brdf_eval(l.brdf, l.lobe, flat, wi, wo);
}

// The luminance samples of one point and the model's prediction of them for given alphas and
// groove.
class Problem {
  public:
    Problem(ParametricModel model, const PointSamples& samples, float eta)
        : model_(model),
          samples_(samples),
          eta_(eta),
          flat_(f32::perturb_make(f32::kMethodNone, f32::vec3(0.0f, 0.0f, 1.0f), true, false)),
          shape_(samples.size()),
          fresnel_(samples.size()) {
        const RelativeFresnel fresnel(eta);
        for (std::size_t q = 0; q < samples.size(); ++q)
            fresnel_[q] = is_ward(model) ? 1.0f : fresnel(samples.cosine_ih[q]);
        for (const float v : samples.value)
            square_ += static_cast<double>(v) * static_cast<double>(v);
    }

    double square() const { return square_; }  // sum of the squared samples

    void shapes(const Parameters& p) {
        const Lobe lobe = lobe_of(model_, p, eta_);
        for (std::size_t q = 0; q < samples_.size(); ++q)
            shape_[q] = fresnel_[q] * shape(lobe, flat_, samples_.to_light[q], samples_.to_eye);
    }

    // Samples minus the model's values, with the strengths that minimize the sum of their squares.
    void residuals(const Parameters& p, Eigen::VectorXd& out) {
        shapes(p);
        float diffuse = 0.0f, specular = 0.0f;
        strengths(samples_.received, samples_.value, diffuse, specular);
        out.resize(static_cast<Eigen::Index>(samples_.size()));
        for (std::size_t q = 0; q < samples_.size(); ++q)
            out[static_cast<Eigen::Index>(q)] = static_cast<double>(
                samples_.value[q] - samples_.received[q] * (diffuse / std::numbers::pi_v<float> +
                                                            specular * shape_[q]));
    }

    // Finds d, s >= 0 that minimize sum (value - received (d/pi + s b))^2, b from the last
    // shapes().
    void strengths(const std::vector<float>& received, const std::vector<float>& value,
                   float& diffuse, float& specular) const {
        double uu = 0.0, uv = 0.0, vv = 0.0, uy = 0.0, vy = 0.0;
        for (std::size_t q = 0; q < value.size(); ++q) {
            const auto u = static_cast<double>(received[q] / std::numbers::pi_v<float>),
                       v = static_cast<double>(received[q] * shape_[q]);
            const auto y = static_cast<double>(value[q]);
            uu += u * u;
            uv += u * v;
            vv += v * v;
            uy += u * y;
            vy += v * y;
        }
        const Strengths best = solve_strengths(uu, uv, vv, uy, vy);
        diffuse = static_cast<float>(best.diffuse);
        specular = static_cast<float>(best.specular);
    }

  private:
    ParametricModel model_;
    const PointSamples& samples_;
    float eta_;
    f32::Perturbation flat_;
    std::vector<float> shape_, fresnel_;
    double square_ = 0.0;
};

// The function that Descent minimizes. N is 3 (ln alpha along, ln alpha across, groove) or 1 (ln
// alpha of an isotropic lobe).
template <int N>
class Residuals {
  public:
    using Vector = Eigen::Matrix<double, N, 1>;

    explicit Residuals(Problem& problem) : problem_(problem) {}

    static Parameters parameters_of(const Vector& x) {
        const auto along = static_cast<float>(x[0]);
        if constexpr (N == 1)
            return {along, along, 0.0f};
        else
            return {along, static_cast<float>(x[1]), static_cast<float>(x[2])};
    }

    static Vector vector_of(const Parameters& p) {
        Vector x;
        for (int k = 0; k < N; ++k) x[k] = static_cast<double>(p[static_cast<std::size_t>(k)]);
        return x;
    }

    void residuals(const Vector& x, Eigen::VectorXd& out) {
        problem_.residuals(parameters_of(x), out);
    }

    void derivatives(const Vector& x, const Eigen::VectorXd& at_x,
                     Eigen::Matrix<double, Eigen::Dynamic, N>& out) {
        out.resize(at_x.size(), N);
        for (int k = 0; k < N; ++k) {
            Vector moved = x;
            moved[k] += kDifference;
            residuals(moved, moved_);
            out.col(k) = (moved_ - at_x) / kDifference;
        }
    }

  private:
    // Step of the forward differences, in ln alpha or in radians of the groove. The residuals are
    // single precision, and differences of this size keep five of their digits.
    static constexpr double kDifference = 0.01;

    Problem& problem_;
    Eigen::VectorXd moved_;
};

// Searches from `p`, which receives the minimum found; returns the sum of squares there.
template <int N>
double descend(Problem& problem, Parameters& p, int steps) {
    using Search = Residuals<N>;
    using Vector = typename Search::Vector;
    DescentRules rules;
    rules.most_iterations = steps;
    rules.most_attempts = 5;
    rules.stiffen = 8.0;
    rules.least_damping = 1e-9;
    rules.trace_share = 1e-6;
    rules.most_step = 0.5;  // alphas by a factor of 1.6
    // A gain of 1e-4 of the error is far below the error of the model itself.
    rules.least_gain = 1e-4;
    Vector low = Vector::Constant(-HUGE_VAL), high = Vector::Constant(HUGE_VAL);
    for (int k = 0; k < std::min(N, 2); ++k) {
        low[k] = std::log(static_cast<double>(kLeastAlpha));
        high[k] = std::log(static_cast<double>(kMostAlpha));
    }
    Search search(problem);
    const auto result = Descent<N>(low, high, rules).run(search, Search::vector_of(p));
    p = Search::parameters_of(result.x);
    return result.sum;
}

}  // namespace

std::span<const std::string_view> parametric_model_names() {
    return kNames;
}

ParametricFit fit_parametric(ParametricModel model, const PointSamples& samples, float eta,
                             const ParametricFit& start, const ParametricEffort& effort) {
    ParametricFit fit = start;
    if (samples.size() == 0) return fit;
    Problem problem(model, samples, eta);
    // Starts from the given lobe, then from two nearly isotropic lobes in case the first finds a
    // poor minimum.
    const float along = std::log(start.alpha_along), across = std::log(start.alpha_across);
    const float round = 0.5f * (along + across);
    const std::array<Parameters, 3> starts = {
        model == ParametricModel::ward_isotropic ? Parameters{round, round, start.groove}
                                                 : Parameters{along, across, start.groove},
        Parameters{std::log(0.25f), std::log(0.3f), start.groove},
        Parameters{std::log(0.25f), std::log(0.3f),
                   start.groove + 0.5f * std::numbers::pi_v<float>}};
    Parameters best{};
    double least = 0.0;
    const std::size_t tried = !effort.elsewhere                          ? 1
                              : model == ParametricModel::ward_isotropic ? 2
                                                                         : 3;
    for (std::size_t k = 0; k < tried; ++k) {
        Parameters p = starts[k];
        const double error = model == ParametricModel::ward_isotropic
                                 ? descend<1>(problem, p, effort.steps)
                                 : descend<3>(problem, p, effort.steps);
        if (k > 0 && error >= least) continue;
        least = error;
        best = p;
    }
    problem.shapes(best);
    for (std::size_t c = 0; c < 3; ++c)
        problem.strengths(samples.weight_rgb[c], samples.value_rgb[c], fit.diffuse[c],
                          fit.specular[c]);
    fit.alpha_along = std::exp(best[0]);
    fit.alpha_across = std::exp(best[1]);
    fit.groove = best[2];
    if (fit.alpha_along > fit.alpha_across) {  // the lobe is narrow along the groove
        std::swap(fit.alpha_along, fit.alpha_across);
        fit.groove += 0.5f * std::numbers::pi_v<float>;
    }
    fit.groove -= std::numbers::pi_v<float> * std::floor(fit.groove / std::numbers::pi_v<float>);
    fit.error = problem.square() > 0.0 ? static_cast<float>(least / problem.square()) : 0.0f;
    return fit;
}

float parametric_shape(ParametricModel model, const ParametricFit& fit, float eta,
                       const Vec3f& to_light, const Vec3f& to_eye) {
    const Parameters p = {std::log(fit.alpha_along), std::log(fit.alpha_across), fit.groove};
    const f32::Perturbation flat =
        f32::perturb_make(f32::kMethodNone, f32::vec3(0.0f, 0.0f, 1.0f), true, false);
    const float b = shape(lobe_of(model, p, eta), flat, to_light, to_eye);
    if (is_ward(model)) return b;
    const Vec3f sum = {to_light[0] + to_eye[0], to_light[1] + to_eye[1], to_light[2] + to_eye[2]};
    const float length = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    return RelativeFresnel(eta)(0.5f * length) * b;
}

}  // namespace burnish
