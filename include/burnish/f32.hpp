// The maths of shading/ in single precision: namespace burnish::f32. Header only; no state, so that any
// number of threads may call it. burnish/f64.hpp has the same in double.
//
// Directions are unit vectors that point away from the surface, in the tangent space of the unperturbed
// surface: x tangent, y bitangent, z geometric normal. wi is towards the light, wo towards the viewer, h the
// half vector, n~ (n in signatures) the perturbed normal. Angles are radians, colors linear Rec. 709. Values
// of reflectance are per steradian, without the cosine. `mdf`, `brdf`, `method` are the numbers of
// names.glsl, which are those of burnish/shading_names.hpp. Functions throw nothing; guards keep every value
// finite for finite input.
//
// Where to look, by subject (the texts of shading/ document each function):
//
//   frames          frame.glsl                frame_keep_tangent frame_keep_bitangent frame_shortest_arc
//                                             frame_to_local frame_to_outer reflect_about
//   methods         perturb/perturb.glsl      perturb_make perturb_point perturb_direction
//                   perturb/forward.glsl      perturb_forward deform_jacobian (the way back, for sampling)
//                   perturb/facing.glsl       normal_facing (views below the horizon of n~)
//   distributions   mdf/lobe.glsl             lobe_make lobe_from_alpha lobe_D lobe_paper_D
//                                             lobe_grooves_along_x exponent_from_alpha
//                   mdf/smith.glsl            smith_lambda smith_G1 smith_G2
//                   mdf/widen.glsl            widen_lobe (by the variance of slopes too small to see)
//                   mdf/tabulated.glsl        table_place table_value tabulated_half_vector area_brdf
//   models          brdf/kinds.glsl           brdf_mdf brdf_takes_method brdf_is_cosine_lobe
//                   brdf/half_vector.glsl     brdf_eval half_vector
//                   brdf/sample.glsl          brdf_sample brdf_pdf lobe_sample lobe_pdf
//                   brdf/cosine_lobe.glsl     cosine_lobe_make cosine_lobe_eval cosine_lobe_sample
//                                             cosine_lobe_pdf cosine_lobe_albedo (phong, lafortune)
//                   brdf/phong.glsl, brdf/lafortune.glsl, brdf/ashikhmin_shirley.glsl: one paper each
//                   brdf/fresnel.glsl         fresnel_schlick fresnel_conductor fresnel_rise
//   whole surfaces  surface/specular.glsl     SurfaceMaterial: surface_material surface_colored
//                                             specular_eval specular_sample specular_pdf specular_fresnel
//                   surface/surface.glsl      surface_eval surface_sample surface_pdf
//                                             surface_direction surface_specular_share
//                   surface/layers.glsl       layered_eval layered_sample layered_pdf, over
//                                             coat_make (coat.glsl) and sheen_make (sheen.glsl)
//                   surface/diffuse.glsl      diffuse_eval diffuse_albedo specular_occlusion
//                   surface/cloth.glsl        cloth_eval cloth_sample cloth_pdf
//                   surface/weave.glsl        weave_point
//   texels          surface/normal.glsl       normal_of_vector normal_of_slopes variance_about normal_over
//                   surface/roughness.glsl    alpha_of_roughness lobe_of_roughness
//                   surface/axes.glsl         surface_frame stretch_direction surface_perturbation
//                   surface/tangent.glsl      tangent_or_any
//   lights          surface/light.glsl        light_at spot_cone
//                   surface/area_light.glsl   area_light_seen area_cosine
//                   surface/area_lit.glsl     area_lobe area_reflection
//   display         display/color.glsl        luminance srgb_from_linear linear_from_srgb
//                   display/tone_map.glsl     tone_map display_color
//
// A surface in four lines:
//
//   SurfaceMaterial m = surface_material(brdf, lobe_from_alpha(mdf, 0.1f, 0.4f), -1.0f, {}, 0.04f);
//   m = surface_colored(m, {0.8f, 0.6f, 0.4f}, 1.0f);
//   Perturbation p = perturb_make(kMethodFollowGrain, n, true, false);
//   vec3 f = surface_eval(m, p, wi, wo);
#pragma once

#include "shading/precision.hpp"
#include "shading/prelude.hpp"

namespace burnish::f32 {

using namespace dialect;  // NOLINT: the dialect's words are meant to be here
using Float = float;
using Bool = bool;
using vec2 = Vec2<Float>;
using vec3 = Vec3<Float>;

inline constexpr int kWardNodes = dialect::Precision<Float>::ward_nodes;
inline constexpr int kDeformRootSteps = dialect::Precision<Float>::deform_root_steps;
inline constexpr Float kLeastCosine = dialect::Precision<Float>::least_cosine;
inline constexpr Float kMostValue = dialect::Precision<Float>::most_value;

// In this order.
// clang-format off
#include "shading/prelude_begin.hpp"
#include "shading/all.hpp"
#include "shading/prelude_end.hpp"
// clang-format on

}  // namespace burnish::f32
