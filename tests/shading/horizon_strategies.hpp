// The published answers to directions that a normal map makes invalid, side by side: for the study
// docs/theory/invalid-directions.md and for tests. Double precision; Fresnel is 1.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "lobes_under_test.hpp"
#include "two_facets.hpp"

namespace burnish::test {

enum class Strategy { perturbed_horizon, flip, bend_reflection, face_view, two_facets };

inline constexpr std::array<std::string_view, 5> kStrategyNames = {
    "horizon of n~ only", "flip + shadow term", "bend the reflection", "face the view",
    "two facets"};

// n~ mirrored in the plane across the view, where the view is below its horizon.
inline vec3 flipped(vec3 n, vec3 wo) {
    const double c = f64::dot(n, wo);
    return c < 0 ? f64::normalize(n - wo * (2 * c)) : n;
}

// Cycles' idea: n~ turned towards the surface's normal until the mirrored view is above the surface
// (there along a closed form; here by bisection on the arc between the two).
inline vec3 reflection_bent(vec3 n, vec3 wo) {
    const double least = std::min(0.9 * wo.z, 0.01);
    const auto valid = [&](vec3 m) {
        return f64::dot(m, wo) > 0 && f64::reflect_about(wo, m).z >= least;
    };
    if (valid(n)) return n;
    double good = 0, bad = 1;  // share of n~; at 0 the mirrored view is as high as the view
    vec3 best{0, 0, 1};
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (good + bad);
        const vec3 m = f64::normalize(n * middle + vec3{0, 0, 1} * (1 - middle));
        (valid(m) ? good : bad) = middle;
        if (valid(m)) best = m;
    }
    return best;
}

// Estevez, Lecocq & Stein, "A Microfacet-Based Shadowing Function to Solve the Bump Terminator
// Problem", Ray Tracing Gems, 2019: GGX shadowing whose width is the map's tilt, for the light.
inline double bump_shadow(vec3 n, vec3 wi) {
    const double tan2_tilt = (1 - n.z * n.z) / (n.z * n.z);
    const double alpha2 = std::min(0.125 * tan2_tilt, 1.0);
    if (wi.z <= 0) return 0;
    const double tan2_light = (1 - wi.z * wi.z) / (wi.z * wi.z);
    return 2 / (1 + std::sqrt(1 + alpha2 * tan2_light));
}

// A grid point of a square that no seed repeats: base-2 and base-3 radical inverses.
inline f64::vec2 low_discrepancy(std::uint32_t i, double shift_x, double shift_y) {
    const auto inverse = [](std::uint32_t n, std::uint32_t base) {
        double value = 0, digit = 1;
        for (; n > 0; n /= base) value += (n % base) * (digit /= base);
        return value;
    };
    const double x = inverse(i, 2) + shift_x, y = inverse(i, 3) + shift_y;
    return {x - std::floor(x), y - std::floor(y)};
}

// The walk of two_facets.hpp, cut after 24 facets, by which time next to nothing is left.
template <typename Radiance>
double two_facets_walk(const f64::Lobe& lobe, const f64::Perturbation& p, vec3 n, vec3 wo,
                       int samples, double shift_x, double shift_y, const Radiance& radiance) {
    const TwoFacets facets = two_facets_make(n);
    double sum = 0;
    for (int i = 0; i < samples; ++i) {
        double weight = 1;
        vec3 back = wo;  // against the direction of travel
        for (int step = 0; step < 24 && weight > 0; ++step) {
            // A new pair of dimensions for every step: shifted by multiples of irrational numbers.
            const auto index = static_cast<std::uint32_t>(i);
            const auto xi =
                low_discrepancy(index, shift_x + 0.754877 * step, shift_y + 0.569840 * step);
            const auto choice = low_discrepancy(index * 7 + 3, shift_y + 0.430159 * step,
                                                shift_x + 0.839286 * step);
            vec3 along = two_facets_mirrored(facets, back) * -1.0;
            if (choice.x < two_facets_share(facets, back)) {
                double pdf = 0;
                along = f64::brdf_sample(f64::kBrdfMicrofacet, lobe, p, back, xi, 0.5, pdf);
                if (pdf <= 0) break;
                weight *= f64::brdf_eval(f64::kBrdfMicrofacet, lobe, p, along, back) *
                          std::max(f64::dot(n, along), 0.0) / pdf;
            }
            const double leaves = two_facets_masking(facets, along);
            sum += weight * leaves * radiance(along);
            weight *= 1 - leaves;
            back = along * -1.0;
        }
    }
    return sum / samples;
}

// What the strategy answers: the mean over `samples` of radiance(wi), weighted by f cos; 1 in a
// white furnace would be a surface that keeps all light.
template <typename Radiance>
double reflected(Strategy strategy, const f64::Lobe& lobe, vec3 n, vec3 wo, int samples,
                 double shift_x, double shift_y, const Radiance& radiance) {
    const auto bent = [&] {
        switch (strategy) {
            case Strategy::flip:
                return flipped(n, wo);
            case Strategy::bend_reflection:
                return reflection_bent(n, wo);
            case Strategy::face_view:
                return f64::normal_facing(n, wo);
            default:
                return n;
        }
    }();
    const bool along_x = f64::lobe_grooves_along_x(lobe.mdf, lobe.p0, lobe.p1);
    const auto p = f64::perturb_make(f64::kMethodFollowGrain, bent, along_x, false);
    const auto f_cos = [&](vec3 wi, vec3 eye) {
        return f64::brdf_eval(f64::kBrdfMicrofacet, lobe, p, wi, eye) *
               std::max(f64::dot(p.n, wi), 0.0);
    };
    double sum = 0;
    if (strategy != Strategy::two_facets) {
        for (int i = 0; i < samples; ++i) {
            double pdf = 0;
            const vec3 wi = f64::brdf_sample(
                f64::kBrdfMicrofacet, lobe, p, wo,
                low_discrepancy(static_cast<std::uint32_t>(i), shift_x, shift_y), 0.5, pdf);
            if (pdf <= 0) continue;
            const double shadow = strategy == Strategy::flip ? bump_shadow(bent, wi) : 1.0;
            sum += shadow * f_cos(wi, wo) / pdf * radiance(wi);
        }
        return sum / samples;
    }
    return two_facets_walk(lobe, p, n, wo, samples, shift_x, shift_y, radiance);
}

}  // namespace burnish::test
