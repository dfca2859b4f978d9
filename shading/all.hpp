// The texts in the order in which they build on each other: the one list, read by the C++ faces
// (include/burnish/f32.hpp, f64.hpp) and by cmake/embed_shaders.cmake for GLSL. No include guard.
// clang-format off
#include "shading/names.glsl"
#include "shading/frame.glsl"
#include "shading/perturb.glsl"
#include "shading/mdf_ashikhmin_shirley.glsl"
#include "shading/mdf_ward.glsl"
#include "shading/mdf_beckmann.glsl"
#include "shading/mdf_ggx.glsl"
#include "shading/lobe.glsl"
#include "shading/smith.glsl"
#include "shading/fresnel.glsl"
#include "shading/brdf_ashikhmin_shirley.glsl"
#include "shading/brdf_ward.glsl"
#include "shading/brdf_cook_torrance.glsl"
#include "shading/brdf.glsl"
#include "shading/sample.glsl"
#include "shading/horizon.glsl"
#include "shading/cosine_power.glsl"
#include "shading/brdf_phong.glsl"
#include "shading/brdf_lafortune.glsl"
#include "shading/brdf_cosine_lobe.glsl"
// clang-format on
