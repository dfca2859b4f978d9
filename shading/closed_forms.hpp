// The closed forms, in the order in which they build on each other: distributions under every
// method. They also compile with a SIMD register for Float, so that mdf_batch_text.hpp reads them
// by themselves. No include guard: once a precision.
// clang-format off
#include "shading/names.glsl"
#include "shading/frame.glsl"
#include "shading/perturb/facet_map.glsl"
#include "shading/perturb/perturb.glsl"
#include "shading/mdf/ashikhmin_shirley.glsl"
#include "shading/mdf/ward.glsl"
#include "shading/mdf/beckmann.glsl"
#include "shading/mdf/ggx.glsl"
#include "shading/mdf/lobe.glsl"
// clang-format on
