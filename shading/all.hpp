// The texts in the order in which they build on each other: the one list, read by the C++ faces
// (include/burnish/f32.hpp, f64.hpp) and by cmake/embed_shaders.cmake for GLSL. No include guard.
// clang-format off
#include "shading/closed_forms.hpp"
#include "shading/mdf/smith.glsl"
#include "shading/mdf/widen.glsl"
#include "shading/mdf/tabulated.glsl"
#include "shading/perturb/forward.glsl"
#include "shading/perturb/facing.glsl"
#include "shading/brdf/fresnel.glsl"
#include "shading/brdf/cosine_power.glsl"
#include "shading/brdf/ashikhmin_shirley.glsl"
#include "shading/brdf/ward.glsl"
#include "shading/brdf/cook_torrance.glsl"
#include "shading/brdf/half_vector.glsl"
#include "shading/brdf/sample.glsl"
#include "shading/brdf/phong.glsl"
#include "shading/brdf/lafortune.glsl"
#include "shading/brdf/cosine_lobe.glsl"
#include "shading/surface/weave.glsl"
// clang-format on
