// The reflection models by name: what their parameters mean, which values they may have, and their
// value in float and in double. A new model is one more row of the table in brdf_models.cpp.
//
// Threads: any number may call these functions at a time. Lifetime: what they return is static.
#pragma once

#include <span>
#include <string_view>

#include "burnish/api.hpp"
#include "burnish/mdf.hpp"

namespace BURNISH_API burnish {

inline constexpr std::size_t kMostBrdfParameters = 5;

// Specular reflectance per steradian without the cosine, Fresnel included; 0 when `wi` or `wo`
// (both unit, away from the surface) is below the horizon.
template <typename Float>
using BrdfFunction = Float (*)(std::span<const Float, kMostBrdfParameters> p, Direction<Float> wi,
                               Direction<Float> wo);

// Directions `wi` for a given `wo`. The density is per solid angle; its integral is below 1 where
// draws are thrown away (density 0), and a drawn `wi` may lie below the horizon.
template <typename Float>
struct BrdfSampler {
    // xi: uniform in [0, 1).
    Direction<Float> (*sample)(std::span<const Float, kMostBrdfParameters> p, Direction<Float> wo,
                               std::span<const Float, 3> xi, Float& density);
    BrdfFunction<Float> density;
};

struct BrdfModel {
    std::string_view name;
    std::span<const ShapeParameter> parameters;  // p0, p1, ...
    BrdfFunction<float> value_f32;
    BrdfFunction<double> value_f64;
    BrdfSampler<float> sampler_f32;
    BrdfSampler<double> sampler_f64;
};

// Every model that a name alone tells, in the order of help texts.
std::span<const BrdfModel> brdf_models();

// How the Smith terms of the two directions are combined.
enum class Smith { correlated = 0, separable = 1 };
std::span<const std::string_view> smith_names();

// `microfacet`: any distribution with its own Smith term. Parameters: those of the distribution,
// F0.
const BrdfModel& microfacet_model(Mdf mdf, Smith smith);

}  // namespace burnish
