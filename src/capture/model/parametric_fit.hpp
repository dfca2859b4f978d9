// Fits analytic models to the samples of one point. The fits are compared with the tables and
// exported as maps for engines that cannot draw tables. Least squares on the pictures' values with
// equal weights, in three nonlinear parameters at most; the linear diffuse and specular strengths
// are solved for within each step (variable projection).
#pragma once

#include <array>
#include <span>
#include <string_view>

#include "capture/stack/light_geometry.hpp"

namespace burnish {

// In the order of parametric_model_names: "ward-isotropic" "ward" "ggx" "ashikhmin-shirley".
enum class ParametricModel { ward_isotropic, ward, ggx, ashikhmin_shirley };
std::span<const std::string_view> parametric_model_names();

struct ParametricFit {
    float alpha_along = 0.3f, alpha_across = 0.3f;  // of the groove; equal for ward-isotropic
    float groove = 0.0f;                         // radians, in [0, pi), counter-clockwise from +x
    std::array<float, 3> diffuse{}, specular{};  // albedo; k_s F(1)
    float error = 1.0f;                          // as PointFit::error, with equal weights
};

// Effort of a search: whether it also starts from nearly isotropic lobes, and the steps from each
// start.
struct ParametricEffort {
    bool elsewhere = true;
    int steps = 12;
};

// `start`: where the search begins. eta is not used by Ward's model, which has no Fresnel term.
ParametricFit fit_parametric(ParametricModel model, const PointSamples& samples, float eta,
                             const ParametricFit& start, const ParametricEffort& effort = {});

// The specular shape b of the fitted rho = diffuse/pi + specular b, for unit directions in the
// frame of the normal.
float parametric_shape(ParametricModel model, const ParametricFit& fit, float eta,
                       const Vec3f& to_light, const Vec3f& to_eye);

}  // namespace burnish
