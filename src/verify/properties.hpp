// What a method keeps of a reflection model, measured: where the highlight lies, energy, reciprocity, whether the
// sampler follows its density, whether every value is a number. `burnish verify` prints it.
#pragma once

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "verify/hostile.hpp"
#include "verify/process_plate.hpp"

namespace burnish::verify {

// A reflection model under a perturbed normal, as functions: Fresnel 1, directions unit in the unperturbed tangent
// space.
struct Reflection {
    vec3 n{0, 0, 1};     // the normal of cosines
    vec3 peak{0, 0, 1};  // about where half vectors crowd: the pole of quadratures
    std::function<double(vec3 h)> D;
    std::function<double(vec3 wi, vec3 wo)> f;    // per steradian, without the cosine
    std::function<double(vec3 wi, vec3 wo)> pdf;  // of `sample`, per steradian
    // wi by three uniform numbers; `pdf` 0: throw it away.
    std::function<vec3(vec3 wo, double xi0, double xi1, double select, double& pdf)> sample;
};

// The reflection of `subject` as shading/ has it.
Reflection reflection_of(const Subject& subject, vec3 n);
using MakeReflection = std::function<Reflection(const Subject&, vec3 n)>;

// Whether a value has no meaning (a cosine lobe has no D): NaN.
inline constexpr double kNoFigure = std::numeric_limits<double>::quiet_NaN();

struct Figures {
    double highlight_deg = kNoFigure;  // largest angle to the highlight of the process
    double energy_least = kNoFigure;   // Int D (n~.h) dw
    double energy_most = kNoFigure;
    double albedo_least = kNoFigure;  // white furnace, single scattering
    double albedo_most = kNoFigure;
    double reciprocity = kNoFigure;  // largest |f(i,o) - f(o,i)| over the larger of the two
    double sampler_p = kNoFigure;    // of chi-square
    HostileCounts hostile;
};

// Over tilts of 15, 30 and 45 degrees along x, along y and between them.
Figures measure(const Subject& subject, const MakeReflection& make = reflection_of);

// What methods promise. Highlight, energy, furnace and reciprocity: `microfacet` and `microfacet-separable` under
// `none`, the rotations but rotate-approx, slope-shift and stretch. The sampler and values that are numbers:
// everything.
bool is_judged(const Subject& subject);
inline constexpr double kMostHighlightDeg = 1.0;
inline constexpr double kMostAlbedo = 1.001;
// Quadrature misses 1 by less than this for alphas from kLeastAlphaMeasured on.
inline constexpr double kMostEnergyError = 0.002;
inline constexpr double kMostAsymmetry = 1e-6;  // rounding alone is near 1e-12
// Of 400 rows of a true sampler one fails with a chance of 0.04 %; the draws are the same in every run.
inline constexpr double kLeastSamplerP = 1e-6;

// The quadratures resolve no narrower lobe.
inline constexpr double kLeastAlphaMeasured = 0.05;

// A line for each bound that is broken: "highlight 28.4 degrees off, at most 1".
std::vector<std::string> broken_bounds(const Subject& subject, const Figures& figures);

}  // namespace burnish::verify
