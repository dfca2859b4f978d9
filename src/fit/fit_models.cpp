#include "burnish/fit_models.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "burnish/error.hpp"

namespace burnish {
namespace {

using Q = std::span<const double>;
using Starts = std::vector<std::vector<double>>;

constexpr double kMostF0 = 1;
// A lobe of this width or exponent is what the eye calls from mirror to matt.
constexpr std::array<double, 9> kAlphas = {0.02, 0.04, 0.07, 0.11, 0.17, 0.26, 0.4, 0.65, 1.0};
constexpr std::array<double, 3> kF0s = {0.04, 0.3, 0.9};

const BrdfModel& brdf_named(std::string_view name) {
    for (const BrdfModel& model : brdf_models())
        if (model.name == name) return model;
    throw Error("no reflection model is called " + std::string(name));
}

const ShapeParameter& parameter_of(const BrdfModel& brdf, std::string_view name) {
    for (const ShapeParameter& parameter : brdf.parameters)
        if (parameter.name == name) return parameter;
    throw Error(std::string(brdf.name) + " has no parameter " + std::string(name));
}

// Bounds of a parameter, searched in its logarithm or in that of 1 + it.
FreeParameter logarithmic(const ShapeParameter& p) {
    return {std::log(p.low), std::log(p.high)};
}
FreeParameter logarithmic_from_0(const ShapeParameter& p) {
    return {std::log1p(p.low), std::log1p(p.high)};
}
FreeParameter as_it_is(const ShapeParameter& p) {
    return {p.low, p.high};
}

double exponent_of_alpha(double alpha) {
    return std::max(2 / (alpha * alpha) - 2, 0.0);
}

FitModel model_of(std::string_view name) {
    FitModel model;
    model.name = name;
    model.brdf = &brdf_named(name);
    for (const ShapeParameter& parameter : model.brdf->parameters)
        if (parameter.name == "ks") model.most_scale = parameter.high;
    return model;
}

// q: ln alpha (and ln alpha_y) of a lobe whose parameters are ks, alpha_x, alpha_y.
FitModel ward_family(std::string_view name) {
    FitModel model = model_of(name);
    const FreeParameter alpha = logarithmic(parameter_of(*model.brdf, "alpha_x"));
    Starts starts;
    for (const double a : kAlphas) starts.push_back({std::log(a)});
    model.isotropic = {{{alpha},
                        [](Q q) {
                            return LobeParameters{1, std::exp(q[0]), std::exp(q[0])};
                        },
                        starts}};
    model.anisotropic = {{{alpha, alpha},
                          [](Q q) {
                              return LobeParameters{1, std::exp(q[0]), std::exp(q[1])};
                          },
                          {}}};
    model.widen = [](Q q) { return std::vector{q[0], q[0]}; };
    model.stretch = 0.5;
    return model;
}

// q: the width of the lobe (twice when anisotropic), F0.
using Width = double (*)(double q);
FitModel lobe_and_f0(std::string_view name, const FreeParameter& width, Width of_q,
                     double (*to_q)(double alpha)) {
    FitModel model = model_of(name);
    const FreeParameter f0 = as_it_is(parameter_of(*model.brdf, "F0"));
    Starts starts;
    for (const double a : kAlphas)
        for (const double f : kF0s) starts.push_back({to_q(a), f});
    model.isotropic = {{{width, f0},
                        [of_q](Q q) {
                            return LobeParameters{of_q(q[0]), of_q(q[0]), q[1]};
                        },
                        starts}};
    model.anisotropic = {{{width, width, f0},
                          [of_q](Q q) {
                              return LobeParameters{of_q(q[0]), of_q(q[1]), q[2]};
                          },
                          {}}};
    model.widen = [](Q q) { return std::vector{q[0], q[0], q[1]}; };
    model.stretch = 0.5;
    return model;
}

FitModel alphas_and_f0(std::string_view name) {
    const FreeParameter alpha = logarithmic(parameter_of(brdf_named(name), "alpha_x"));
    return lobe_and_f0(
        name, alpha, [](double q) { return std::exp(q); }, [](double a) { return std::log(a); });
}

FitModel ashikhmin_shirley() {
    const FreeParameter e =
        logarithmic_from_0(parameter_of(brdf_named("ashikhmin-shirley"), "e_x"));
    return lobe_and_f0(
        "ashikhmin-shirley", e, [](double q) { return std::expm1(q); },
        [](double a) { return std::log1p(exponent_of_alpha(a)); });
}

FitModel cook_torrance() {
    FitModel model = model_of("cook-torrance");
    Starts starts;
    for (const double m : kAlphas)
        for (const double f : kF0s) starts.push_back({std::log(m), f});
    model.isotropic = {
        {{logarithmic(parameter_of(*model.brdf, "m")), as_it_is(parameter_of(*model.brdf, "F0"))},
         [](Q q) {
             return LobeParameters{1, std::exp(q[0]), q[1]};
         },
         starts}};
    return model;
}

// cos^n about the mirror direction is about four times as narrow as cos^e about the normal.
FitModel phong() {
    FitModel model = model_of("phong");
    Starts starts;
    for (const double a : kAlphas) starts.push_back({std::log1p(exponent_of_alpha(a) / 4)});
    model.isotropic = {{{logarithmic_from_0(parameter_of(*model.brdf, "n"))},
                        [](Q q) {
                            return LobeParameters{1, std::expm1(q[0])};
                        },
                        starts}};
    return model;
}

// A scale of C is one of ks as well, so |Cx| + Cz = 2: the bracket is 1 where the lobe peaks at 45
// degrees, and d leans it, 0 being the mirror direction (or, for a lobe that faces the light, the
// way back). q: d, ln(1 + n); anisotropic: d of y between them.
FitVariant lafortune_variant(double sign, bool anisotropic) {
    const BrdfModel& brdf = brdf_named("lafortune");
    const FreeParameter lean{-0.95, 1};
    const FreeParameter n = logarithmic_from_0(parameter_of(brdf, "n"));
    Starts starts;
    for (const double a : kAlphas)
        for (const double d : {-0.03, 0.0, 0.15})
            starts.push_back({d, std::log1p(exponent_of_alpha(a) / 4)});
    if (!anisotropic) {
        return {{lean, n},
                [sign](Q q) {
                    const double c = sign * (1 - q[0]);
                    return LobeParameters{1, c, c, 1 + q[0], std::expm1(q[1])};
                },
                starts};
    }
    const ShapeParameter& cy = parameter_of(brdf, "Cy");
    return {{lean, {1 - cy.high, 1 - cy.low}, n},
            [sign](Q q) {
                return LobeParameters{1, sign * (1 - q[0]), sign * (1 - q[1]), 1 + q[0],
                                      std::expm1(q[2])};
            },
            {}};
}

FitModel lafortune() {
    FitModel model = model_of("lafortune");
    model.isotropic = {lafortune_variant(-1, false), lafortune_variant(1, false)};
    model.anisotropic = {lafortune_variant(-1, true), lafortune_variant(1, true)};
    model.widen = [](Q q) { return std::vector{q[0], q[0], q[1]}; };
    model.stretch = 0.1;
    return model;
}

// q: ln sigma, ln tau, F0. Starts by slope, 2 sigma / tau, and height.
FitModel he() {
    FitModel model = model_of("he");
    const ShapeParameter& sigma = parameter_of(*model.brdf, "sigma");
    const ShapeParameter& tau = parameter_of(*model.brdf, "tau");
    Starts starts;
    for (const double s : {0.05, 0.15, 0.4, 1.0, 2.5})
        for (const double slope : {0.04, 0.1, 0.2, 0.4, 0.8})
            for (const double f : {0.05, 0.5})
                if (2 * s / slope >= tau.low && 2 * s / slope <= tau.high)
                    starts.push_back({std::log(s), std::log(2 * s / slope), f});
    // Below a thousandth of a wavelength a surface is a mirror: the lobe vanishes as sigma^2.
    model.isotropic = {{{{std::log(1e-3), std::log(sigma.high)}, logarithmic(tau), {0, kMostF0}},
                        [](Q q) {
                            return LobeParameters{std::exp(q[0]), std::exp(q[1]), q[2]};
                        },
                        starts}};
    return model;
}

}  // namespace

std::span<const FitModel> fit_models() {
    static const std::vector<FitModel> models = {
        phong(),
        ward_family("ward"),
        lafortune(),
        ward_family("ward-duer"),
        ward_family("ward-gmd"),
        cook_torrance(),
        ashikhmin_shirley(),
        alphas_and_f0("ggx"),
        alphas_and_f0("beckmann"),
        he(),
    };
    return models;
}

std::span<const std::string_view> fit_model_names() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> all;
        for (const FitModel& model : fit_models()) all.push_back(model.name);
        return all;
    }();
    return names;
}

}  // namespace burnish
