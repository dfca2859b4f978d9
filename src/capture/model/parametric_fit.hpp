// Analytic models fitted to one point's samples: for comparison with the tables, and as maps for
// engines that cannot draw tables. Least squares on the pictures' values, all weighted alike, in
// four parameters at most; diffuse and specular strengths are solved for within (variable
// projection).
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
    float error = 1.0f;                          // of PointFit's kind, without its weights
};

// How long to search: from `start` alone or from rounder lobes too; steps from each.
struct ParametricEffort {
    bool elsewhere = true;
    int steps = 12;
};

// `start`: where the search begins. eta is not used by Ward's model, which has no Fresnel term.
ParametricFit fit_parametric(ParametricModel model, const PointSamples& samples, float eta,
                             const ParametricFit& start, const ParametricEffort& effort = {});

// rho of the fitted model, luminance-free: the specular shape b of rho = diffuse/pi + specular b,
// for unit directions in the normal's frame.
float parametric_shape(ParametricModel model, const ParametricFit& fit, float eta,
                       const Vec3f& to_light, const Vec3f& to_eye);

}  // namespace burnish
