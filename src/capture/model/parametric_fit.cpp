#include "capture/model/parametric_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "burnish/f32.hpp"
#include "capture/model/strengths.hpp"

namespace burnish {

namespace {

constexpr std::array<std::string_view, 4> kNames = {"ward-isotropic", "ward", "ggx",
                                                    "ashikhmin-shirley"};
constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kLeast = 0.01f, kMost = 1.2f;  // alphas
// Relative gain of a step below which the search ends.
constexpr double kLeastGain = 1e-4;

// log alpha along, log alpha across, groove.
using Parameters = std::array<float, 3>;

int free_parameters(ParametricModel model) {
    return model == ParametricModel::ward_isotropic ? 1 : 3;
}

Parameters bounded(ParametricModel model, Parameters p) {
    for (std::size_t k = 0; k < 2; ++k) p[k] = std::clamp(p[k], std::log(kLeast), std::log(kMost));
    if (model == ParametricModel::ward_isotropic) {
        p[1] = p[0];
        p[2] = 0.0f;
    }
    return p;
}

struct Lobe {
    int brdf;
    f32::Lobe lobe;
    float cosine, sine;  // of the groove
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

// Residuals of the luminance with the best strengths, for one set of parameters.
struct Trial {
    std::vector<float> residuals;
    double error = 0.0;  // sum of squares
};

class Problem {
  public:
    Problem(ParametricModel model, const PointSamples& samples, float eta)
        : model_(model),
          samples_(samples),
          eta_(eta),
          flat_(f32::perturb_make(f32::kMethodNone, f32::vec3(0.0f, 0.0f, 1.0f), true, false)),
          shape_(samples.size()),
          fresnel_(samples.size()) {
        const bool plain =
            model == ParametricModel::ward || model == ParametricModel::ward_isotropic;
        const RelativeFresnel fresnel(eta);
        for (std::size_t q = 0; q < samples.size(); ++q)
            fresnel_[q] = plain ? 1.0f : fresnel(samples.cosine_ih[q]);
        for (const float v : samples.value)
            square_ += static_cast<double>(v) * static_cast<double>(v);
    }

    double square() const { return square_; }

    void shapes(const Parameters& p) {
        const Lobe lobe = lobe_of(model_, p, eta_);
        for (std::size_t q = 0; q < samples_.size(); ++q)
            shape_[q] = fresnel_[q] * shape(lobe, flat_, samples_.to_light[q], samples_.to_eye);
    }

    void evaluate(const Parameters& p, Trial& trial) {
        shapes(p);
        float diffuse = 0.0f, specular = 0.0f;
        strengths(samples_.received, samples_.value, diffuse, specular);
        trial.residuals.resize(samples_.size());
        trial.error = 0.0;
        for (std::size_t q = 0; q < samples_.size(); ++q) {
            const float r =
                samples_.value[q] - samples_.received[q] * (diffuse / kPi + specular * shape_[q]);
            trial.residuals[q] = r;
            trial.error += static_cast<double>(r) * static_cast<double>(r);
        }
    }

    // d, s >= 0 that make sum (value - received (d/pi + s b))^2 least, for the last shapes.
    void strengths(const std::vector<float>& received, const std::vector<float>& value,
                   float& diffuse, float& specular) const {
        double uu = 0.0, uv = 0.0, vv = 0.0, uy = 0.0, vy = 0.0;
        for (std::size_t q = 0; q < value.size(); ++q) {
            const auto u = static_cast<double>(received[q] / kPi),
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

// Solves the 1 x 1 or 3 x 3 system by Cramer's rule; false when it is singular.
bool solve(const std::array<std::array<double, 3>, 3>& a, const std::array<double, 3>& b, int n,
           std::array<double, 3>& x) {
    if (n == 1) {
        if (!(a[0][0] > 0.0)) return false;
        x = {b[0] / a[0][0], 0.0, 0.0};
        return true;
    }
    const auto determinant = [](const std::array<std::array<double, 3>, 3>& m) {
        return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
               m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
               m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    };
    const double whole = determinant(a);
    if (!(std::abs(whole) > 0.0)) return false;
    for (std::size_t k = 0; k < 3; ++k) {
        auto m = a;
        for (std::size_t r = 0; r < 3; ++r) m[r][k] = b[r];
        x[k] = determinant(m) / whole;
    }
    return true;
}

// Levenberg and Marquardt's method with differences for derivatives.
double descend(ParametricModel model, Problem& problem, Parameters& p, int steps) {
    const int n = free_parameters(model);
    Trial now, moved;
    p = bounded(model, p);
    problem.evaluate(p, now);
    double damping = 1e-3;
    std::array<std::vector<float>, 3> slopes;
    for (int step = 0; step < steps; ++step) {
        constexpr float kDifference = 0.01f;
        for (int k = 0; k < n; ++k) {
            Parameters q = p;
            q[static_cast<std::size_t>(k)] += kDifference;
            if (model == ParametricModel::ward_isotropic) q[1] = q[0];
            problem.evaluate(q, moved);
            auto& slope = slopes[static_cast<std::size_t>(k)];
            slope.resize(now.residuals.size());
            for (std::size_t i = 0; i < slope.size(); ++i)
                slope[i] = (moved.residuals[i] - now.residuals[i]) / kDifference;
        }
        std::array<std::array<double, 3>, 3> normal{};
        std::array<double, 3> right{};
        for (std::size_t a = 0; a < static_cast<std::size_t>(n); ++a) {
            for (std::size_t i = 0; i < now.residuals.size(); ++i)
                right[a] -= static_cast<double>(slopes[a][i] * now.residuals[i]);
            for (std::size_t b = a; b < static_cast<std::size_t>(n); ++b) {
                for (std::size_t i = 0; i < now.residuals.size(); ++i)
                    normal[a][b] += static_cast<double>(slopes[a][i] * slopes[b][i]);
                normal[b][a] = normal[a][b];
            }
        }
        bool better = false;
        for (int attempt = 0; attempt < 5 && !better; ++attempt) {
            auto damped = normal;
            // Round lobes do not know their groove: a little of the trace keeps that step finite.
            const double trace = normal[0][0] + normal[1][1] + normal[2][2];
            for (std::size_t k = 0; k < 3; ++k)
                damped[k][k] += damping * (normal[k][k] + 1e-6 * trace);
            std::array<double, 3> move{};
            if (!solve(damped, right, n, move)) break;
            Parameters q = p;
            for (std::size_t k = 0; k < 3; ++k)
                q[k] += std::clamp(static_cast<float>(move[k]), -0.5f, 0.5f);
            q = bounded(model, q);
            problem.evaluate(q, moved);
            if (moved.error < now.error) {
                const double gain = (now.error - moved.error) / std::max(now.error, 1e-30);
                p = q;
                std::swap(now, moved);
                damping = std::max(damping * 0.2, 1e-9);
                if (gain < kLeastGain) return now.error;
                better = true;
            } else {
                damping *= 8.0;
            }
        }
        if (!better) break;
    }
    return now.error;
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
    // From the given lobe; from two round ones, should that lead nowhere.
    const float along = std::log(start.alpha_along), across = std::log(start.alpha_across);
    const float round = 0.5f * (along + across);
    const std::array<Parameters, 3> starts = {
        model == ParametricModel::ward_isotropic ? Parameters{round, round, start.groove}
                                                 : Parameters{along, across, start.groove},
        Parameters{std::log(0.25f), std::log(0.3f), start.groove},
        Parameters{std::log(0.25f), std::log(0.3f), start.groove + 0.5f * kPi}};
    Parameters best{};
    double least = 0.0;
    const std::size_t tried = !effort.elsewhere                          ? 1
                              : model == ParametricModel::ward_isotropic ? 2
                                                                         : 3;
    for (std::size_t k = 0; k < tried; ++k) {
        Parameters p = starts[k];
        const double error = descend(model, problem, p, effort.steps);
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
    if (fit.alpha_along > fit.alpha_across) {  // the groove is where the lobe is narrow
        std::swap(fit.alpha_along, fit.alpha_across);
        fit.groove += 0.5f * kPi;
    }
    fit.groove -= kPi * std::floor(fit.groove / kPi);
    fit.error = problem.square() > 0.0 ? static_cast<float>(least / problem.square()) : 0.0f;
    return fit;
}

float parametric_shape(ParametricModel model, const ParametricFit& fit, float eta,
                       const Vec3f& to_light, const Vec3f& to_eye) {
    const Parameters p = {std::log(fit.alpha_along), std::log(fit.alpha_across), fit.groove};
    const f32::Perturbation flat =
        f32::perturb_make(f32::kMethodNone, f32::vec3(0.0f, 0.0f, 1.0f), true, false);
    const float b = shape(lobe_of(model, p, eta), flat, to_light, to_eye);
    const bool plain = model == ParametricModel::ward || model == ParametricModel::ward_isotropic;
    if (plain) return b;
    const Vec3f sum = {to_light[0] + to_eye[0], to_light[1] + to_eye[1], to_light[2] + to_eye[2]};
    const float length = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    return RelativeFresnel(eta)(0.5f * length) * b;
}

}  // namespace burnish
