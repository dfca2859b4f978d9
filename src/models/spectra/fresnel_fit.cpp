#include "models/spectra/fresnel_fit.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "burnish/f64.hpp"

namespace burnish {
namespace {

// The midpoint rule over the cosine.
constexpr std::size_t kAngles = 48;

constexpr double cosine_of(std::size_t i) {
    return (static_cast<double>(i) + 0.5) / static_cast<double>(kAngles);
}

struct SampledColors {
    std::array<glm::dvec3, kAngles> at;
    glm::dvec3 normal;
};

template <typename Color>
SampledColors sampled_colors(Color color) {
    SampledColors s{{}, color(1.0)};
    for (std::size_t i = 0; i < kAngles; ++i) s.at[i] = color(cosine_of(i));
    return s;
}

// --- an index of refraction -----------------------------------------------------------------------

// k of the conductors with this eta whose reflectance at normal incidence is `normal`.
double k_of(double eta, double normal) {
    const double above = eta + 1.0, below = eta - 1.0;
    return std::sqrt(std::max(normal * above * above - below * below, 0.0) / (1.0 - normal));
}

double squared_error(double eta, const SampledColors& colors, int channel) {
    const double k = k_of(eta, colors.normal[channel]);
    double sum = 0.0;
    for (std::size_t i = 0; i < kAngles; ++i) {
        const double c = cosine_of(i);
        const double error = f64::fresnel_conductor(eta, k, c) - colors.at[i][channel];
        sum += c * error * error;
    }
    return sum;
}

// The best eta between its ends, where k is 0: the best of a scan, then by golden sections.
double fitted_eta(const SampledColors& colors, int channel) {
    constexpr int kScan = 64;
    constexpr double kGolden = 0.6180339887498949;
    const double root = std::sqrt(colors.normal[channel]);
    const double end = std::log((1.0 + root) / (1.0 - root));  // ln eta lies in [-end, end]
    const auto error = [&](double log_eta) {
        return squared_error(std::exp(log_eta), colors, channel);
    };
    const double step = 2.0 * end / kScan;
    double best = -end;
    for (int i = 1; i <= kScan; ++i)
        if (const double x = -end + i * step; error(x) < error(best)) best = x;
    double low = std::max(best - step, -end), high = std::min(best + step, end);
    while (high - low > 1e-9) {  // far below the digits of a float
        const double width = kGolden * (high - low);
        const double a = high - width, b = low + width;
        (error(a) < error(b) ? high : low) = error(a) < error(b) ? b : a;
    }
    return std::exp(0.5 * (low + high));
}

// --- a curve --------------------------------------------------------------------------------------

constexpr int kFree =
    static_cast<int>(kFresnelTerms) - 1;  // the first is the reflectance at normal

// The functions that the free terms of fresnel_curve multiply.
Eigen::Vector<double, kFree> basis_at(double c) {
    const double pole = 1.0 / (c + f64::kFresnelCurvePole), between = c * (1.0 - c);
    return {between * pole, between * pole * pole, between, between * (1.0 - c),
            between * (1.0 - c) * (1.0 - c)};
}

// Of an angle: the square root of its weight in the sum of squares. 0.15: without it the steep rise
// toward grazing incidence, of which a hemisphere has little, is missed by up to twice as much.
double root_weight(std::size_t i) {
    return std::sqrt(cosine_of(i) + 0.15);
}

using Rows = Eigen::Matrix<double, static_cast<int>(kAngles), kFree>;
using Colors = Eigen::Matrix<double, static_cast<int>(kAngles), 3>;

Rows weighted_basis() {
    Rows rows;
    for (std::size_t i = 0; i < kAngles; ++i)
        rows.row(static_cast<int>(i)) = root_weight(i) * basis_at(cosine_of(i)).transpose();
    return rows;
}

}  // namespace

Conductor fitted_conductor(const MetalReflectance& metal) {
    const SampledColors colors =
        sampled_colors([&](double cosine) { return metal.held_color(cosine); });
    Conductor out;
    for (int c = 0; c < 3; ++c) {
        const bool whole = colors.normal[c] >= 1.0;
        const double eta = whole ? 0.0 : fitted_eta(colors, c);
        out.eta[c] = static_cast<float>(eta);
        out.k[c] = whole ? 1.0f : static_cast<float>(k_of(eta, colors.normal[c]));
    }
    return out;
}

FresnelTerms fitted_curve(const MetalReflectance& metal) {
    static const Eigen::HouseholderQR<Rows> fit(weighted_basis());
    // The curve is limited to [0, 1] where it is evaluated, so that it need not bend where the color
    // leaves that range.
    const SampledColors colors = sampled_colors([&](double cosine) { return metal.color(cosine); });
    Colors rest;  // beside the straight line from 1 to the color at normal incidence
    for (std::size_t i = 0; i < kAngles; ++i)
        for (int c = 0; c < 3; ++c)
            rest(static_cast<int>(i), c) =
                root_weight(i) * (colors.at[i][c] - std::lerp(1.0, colors.normal[c], cosine_of(i)));
    const Eigen::Matrix<double, kFree, 3> terms = fit.solve(rest);
    FresnelTerms out;
    out[0] = glm::vec3(colors.normal);
    for (int j = 0; j < kFree; ++j)
        for (int c = 0; c < 3; ++c)
            out[static_cast<std::size_t>(j) + 1][c] = static_cast<float>(terms(j, c));
    return out;
}

}  // namespace burnish
