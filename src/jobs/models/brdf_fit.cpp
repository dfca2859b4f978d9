#include "jobs/models/brdf_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <set>

#include "burnish/error.hpp"
#include "burnish/shading_names.hpp"
#include "core/constants.hpp"
#include "core/parallel.hpp"
#include "core/text.hpp"

namespace burnish {
namespace {

constexpr std::array<double, 3> kCurvesNear = {30, 50, 70};
constexpr int kLeastSamples = 200, kMostSamples = 200000;

double theta_of(Direction<double> w) {
    return std::atan2(std::hypot(w.x, w.y), w.z);
}

Direction<double> direction_at(double theta, double phi) {
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

// Two numbers in [0, 1), evenly spread over every part of the sequence: Roberts' R2.
std::array<double, 2> even_point(std::size_t i) {
    constexpr double kRoot = 1.32471795724474602596;  // x^3 = x + 1
    const double n = static_cast<double>(i) + 1;
    const double x = 0.5 + n / kRoot, y = 0.5 + n / (kRoot * kRoot);
    return {x - std::floor(x), y - std::floor(y)};
}

Direction<double> cosine_direction(std::array<double, 2> xi) {
    return direction_at(std::asin(std::sqrt(xi[0])), 2 * kPi * xi[1]);
}

struct Incident {
    Direction<double> w;
    double weight;  // solid angle
};

// Shares of [from, to] that are nearest to each of `values`, measured by `edge`.
template <typename Edge>
std::vector<double> shares(std::span<const double> values, double from, double to,
                           const Edge& edge) {
    std::vector<double> result;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double low = i == 0 ? from : 0.5 * (values[i - 1] + values[i]);
        const double high = i + 1 == values.size() ? to : 0.5 * (values[i] + values[i + 1]);
        result.push_back(edge(high) - edge(low));
    }
    return result;
}

std::vector<Incident> incident_directions(const RglBrdf& brdf, double most) {
    std::vector<double> thetas;
    for (const double theta : brdf.theta_i())
        if (theta <= most) thetas.push_back(theta);
    const auto bands = shares(thetas, 0, most, [](double theta) { return -std::cos(theta); });
    const auto phis = brdf.isotropic() ? brdf.phi_i().first(1) : brdf.phi_i();
    const auto turns = shares(phis, phis.front(), phis.back(), [](double phi) { return phi; });
    std::vector<Incident> result;
    for (std::size_t t = 0; t < thetas.size(); ++t)
        for (std::size_t p = 0; p < phis.size(); ++p)
            result.push_back(
                {direction_at(thetas[t], phis[p]), bands[t] * (brdf.isotropic() ? 1 : turns[p])});
    return result;
}

void add_samples(const RglBrdf& brdf, const Incident& incident, std::size_t count, double most,
                 std::vector<BrdfSample>& samples) {
    const double half = static_cast<double>((count + 1) / 2);
    for (std::size_t i = 0; i < count; ++i) {
        const auto xi = even_point(i / 2);
        double density = 0;
        const Direction<double> wi =
            i % 2 == 0 ? brdf.sample(incident.w, xi, density) : cosine_direction(xi);
        if (!(wi.z > 0) || theta_of(wi) > most) continue;
        const double both = half * (brdf.pdf(wi, incident.w) + wi.z / kPi);
        samples.push_back({wi, incident.w, brdf.eval(wi, incident.w), incident.weight / both});
    }
}

std::vector<PlaneCurve> measured_curves(const RglBrdf& brdf) {
    std::set<double> thetas;
    for (const double near : kCurvesNear) {
        const auto all = brdf.theta_i();
        thetas.insert(*std::min_element(all.begin(), all.end(), [&](double a, double b) {
            return std::fabs(a - near * kDegree) < std::fabs(b - near * kDegree);
        }));
    }
    std::vector<PlaneCurve> curves;
    for (const double theta_o : thetas) {
        PlaneCurve curve;
        curve.theta_o_deg = theta_o / kDegree;
        const Direction<double> wo = direction_at(theta_o, brdf.phi_i().front());
        for (int half_degree = -170; half_degree <= 170; ++half_degree) {
            const double theta = 0.5 * half_degree * kDegree;
            curve.theta_deg.push_back(0.5 * half_degree);
            curve.measured.push_back(brdf.eval(direction_at(-theta, brdf.phi_i().front()), wo));
        }
        curves.push_back(std::move(curve));
    }
    return curves;
}

// Requires the fits in their final order.
void add_fitted_curves(double phi, MeasuredFit& result) {
    for (PlaneCurve& curve : result.curves) {
        const Direction<double> wo = direction_at(curve.theta_o_deg * kDegree, phi);
        for (const BrdfFit& fit : result.fits) {
            std::vector<FitRgb>& values = curve.fitted.emplace_back();
            for (const double theta : curve.theta_deg)
                values.push_back(fitted_value(fit, direction_at(-theta * kDegree, phi), wo));
        }
    }
}

std::vector<const FitModel*> chosen_models(std::span<const std::string> names) {
    std::vector<const FitModel*> chosen;
    if (names.empty())
        for (const FitModel& model : fit_models()) chosen.push_back(&model);
    for (const std::string& name : names) {
        const int index = index_of_name(fit_model_names(), name, "model", "--model");
        chosen.push_back(&fit_models()[static_cast<std::size_t>(index)]);
    }
    return chosen;
}

}  // namespace

std::vector<std::string> parse_fit_models(std::string_view text, std::string_view where) {
    if (text == "all") return {};
    std::vector<std::string> names;
    for (std::size_t start = 0; start <= text.size();) {
        const std::size_t comma = std::min(text.find(',', start), text.size());
        const std::string name(text.substr(start, comma - start));
        index_of_name(fit_model_names(), name, "model", where);
        if (std::find(names.begin(), names.end(), name) != names.end())
            throw UsageError(where, "", name + " once", "it twice");
        names.push_back(name);
        start = comma + 1;
    }
    return names;
}

std::vector<BrdfSample> measured_samples(const RglBrdf& brdf, const MeasuredFitOptions& options) {
    if (options.samples < kLeastSamples || options.samples > kMostSamples) {
        throw UsageError("--samples", "", fmt::format("{} to {}", kLeastSamples, kMostSamples),
                         std::to_string(options.samples));
    }
    if (!(options.most_deg > 0 && options.most_deg < 90)) {
        throw UsageError("--most-angle", "", "degrees above 0 and below 90",
                         fmt::format("{}", options.most_deg));
    }
    const double most = options.most_deg * kDegree;
    const std::vector<Incident> incidents = incident_directions(brdf, most);
    if (incidents.empty()) {
        throw Error("", "theta_i",
                    fmt::format("an incident direction within {} degrees", options.most_deg),
                    "none");
    }
    const auto each =
        std::max<std::size_t>(static_cast<std::size_t>(options.samples) / incidents.size(), 16);
    std::vector<BrdfSample> samples;
    for (const Incident& incident : incidents) add_samples(brdf, incident, each, most, samples);
    return samples;
}

MeasuredFit fit_measured(const std::filesystem::path& path, std::span<const std::string> models,
                         const Progress& progress, const MeasuredFitOptions& options) {
    const auto chosen = chosen_models(models);
    const RglBrdf brdf = RglBrdf::load(path);
    const std::vector<BrdfSample> samples = measured_samples(brdf, options);

    MeasuredFit result;
    result.file = path.string();
    result.description = brdf.description();
    result.isotropic = brdf.isotropic();
    result.metric = options.fit.metric;
    result.samples = samples.size();
    result.most_deg = options.most_deg;
    result.of_black = errors_of(samples, std::vector<FitRgb>(samples.size()));
    result.curves = measured_curves(brdf);

    FitSettings settings = options.fit;
    settings.anisotropic = !brdf.isotropic();
    result.fits.resize(chosen.size());
    const std::string stage = "fitting " + path.filename().string();
    std::mutex one_at_a_time;
    std::size_t done = 0;
    progress.step(stage, 0);
    parallel_for(chosen.size(), 1, [&](std::size_t begin, std::size_t) {
        // The last model of the list, he, takes the longest: it starts first.
        const std::size_t i = chosen.size() - 1 - begin;
        result.fits[i] = fit_brdf(*chosen[i], samples, settings, progress);
        const std::lock_guard lock(one_at_a_time);
        progress.step(stage, static_cast<double>(++done) / static_cast<double>(chosen.size()));
    });
    std::stable_sort(result.fits.begin(), result.fits.end(),
                     [&](const BrdfFit& a, const BrdfFit& b) {
                         return a.error(result.metric) < b.error(result.metric);
                     });
    add_fitted_curves(brdf.phi_i().front(), result);
    return result;
}

}  // namespace burnish
