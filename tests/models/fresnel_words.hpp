// What a shader evaluates of a metal, and how far it is from the metal's spectra.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/vec3.hpp>
#include <numbers>

#include "burnish/conductor.hpp"
#include "burnish/f64.hpp"
#include "models/spectra/metal_reflectance.hpp"

namespace burnish::test {

using ShaderFresnel = std::function<glm::dvec3(double cosine)>;

inline f64::vec3 vector_of_floats(glm::vec3 v) {
    return {double{v.x}, double{v.y}, double{v.z}};
}

inline ShaderFresnel values_of(const Conductor& bare) {
    return [eta = vector_of_floats(bare.eta), k = vector_of_floats(bare.k)](double cosine) {
        const f64::vec3 f = f64::fresnel_conductor(eta, k, cosine);
        return glm::dvec3(f.x, f.y, f.z);
    };
}

inline f64::FresnelCurve curve_of_terms(const FresnelTerms& terms) {
    f64::FresnelCurve curve;
    curve.normal = vector_of_floats(terms[0]);
    curve.pole = vector_of_floats(terms[1]);
    curve.pole2 = vector_of_floats(terms[2]);
    curve.c0 = vector_of_floats(terms[3]);
    curve.c1 = vector_of_floats(terms[4]);
    curve.c2 = vector_of_floats(terms[5]);
    return curve;
}

inline ShaderFresnel values_of(const FresnelTerms& terms) {
    return [curve = curve_of_terms(terms)](double cosine) {
        const f64::vec3 f = f64::fresnel_curve(curve, cosine);
        return glm::dvec3(f.x, f.y, f.z);
    };
}

// Of all angles and channels; rms with the weight cos theta sin theta. sRGB of 255.
struct FitError {
    double largest = 0, rms = 0, largest_srgb = 0, rms_srgb = 0;
};

// On a grid of angles that the fits do not use.
inline FitError error_of(const MetalReflectance& spectra, const ShaderFresnel& shader) {
    constexpr int kAngles = 91;
    FitError e;
    double sum = 0, sum_srgb = 0, weights = 0;
    for (int i = 0; i < kAngles; ++i) {
        const double theta = 0.5 * std::numbers::pi * i / (kAngles - 1);
        const double cosine = std::cos(theta), weight = cosine * std::sin(theta);
        const glm::dvec3 truth = spectra.held_color(cosine), fit = shader(cosine);
        for (int c = 0; c < 3; ++c) {
            const double d = std::abs(fit[c] - truth[c]);
            const double s =
                255 * std::abs(f64::srgb_from_linear(fit[c]) - f64::srgb_from_linear(truth[c]));
            e.largest = std::max(e.largest, d);
            e.largest_srgb = std::max(e.largest_srgb, s);
            sum += weight * d * d;
            sum_srgb += weight * s * s;
        }
        weights += 3 * weight;
    }
    e.rms = std::sqrt(sum / weights);
    e.rms_srgb = std::sqrt(sum_srgb / weights);
    return e;
}

}  // namespace burnish::test
