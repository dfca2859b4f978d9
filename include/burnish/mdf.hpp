// The C++ face of the distributions: values by name, in float and in double. Both precisions run
// the same text (shading/*.glsl); everything here is in the unperturbed tangent space.
//
// Threads: any number may call these functions at a time. Lifetime: what they return refers to
// nothing else.
#pragma once

#include <span>
#include <string_view>

#include "burnish/api.hpp"
#include "burnish/shading_names.hpp"
#include "shading/prelude.hpp"

namespace BURNISH_API burnish {

template <typename Float>
using Direction = dialect::Vec3<Float>;

// What a number of a distribution or model means and which values it may have, both ends included.
struct ShapeParameter {
    std::string_view name;
    double low;
    double high;
};

// Below an alpha of 0.001 (an exponent of 1e6 is 0.0014) a lobe is narrower than single precision
// resolves; 1.5 is wider than any surface that has been measured.
inline constexpr double kMostExponent = 1e6;
inline constexpr double kLeastAlpha = 0.001;
inline constexpr double kMostAlpha = 1.5;

// p0 and p1: exponents e_x, e_y of ashikhmin-shirley, alpha_x, alpha_y of the others.
std::span<const ShapeParameter> mdf_parameters(Mdf mdf);

template <typename Float>
struct MdfValues {
    Float D{};             // as the papers normalise it (docs/theory/papers.md)
    Float D_proj{};        // the unperturbed lobe normalised to Int D (n.h) dw = 1
    Float D_conserving{};  // D_proj, times the conserving factor of deform-smooth
};

// `n` is the perturbed normal, n.z > 0; `h` any half vector; both unit.
MdfValues<float> mdf_values(Mdf mdf, float p0, float p1, Method method, Direction<float> n,
                            Direction<float> h);
MdfValues<double> mdf_values(Mdf mdf, double p0, double p1, Method method, Direction<double> n,
                             Direction<double> h);

// Makes `v` unit whatever its length, without overflow. False, and `v` untouched, when it is zero.
// The components must be finite.
bool make_unit(Direction<float>& v);
bool make_unit(Direction<double>& v);

}  // namespace burnish
