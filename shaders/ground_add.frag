// The irradiance of one light that the model blocks; blending adds it to that of the others.
#include "shaders/lib/ground.glsl"

in vec2 v_ndc;
uniform sampler2D u_mask;  // depth: 1 where no shadow falls
uniform int u_light;       // -1: the sky's, or
uniform int u_area;        // that of a light with an area, whose texture counts as white
uniform vec3 u_sky;
uniform float u_share;

layout(location = 0) out vec4 o_blocked;

void main() {
    if (texelFetch(u_mask, ivec2(gl_FragCoord.xy), 0).r >= 1.0) { discard; }
    vec3 irradiance = u_sky * u_ground_scale;
#if LIGHTS > 0
    if (u_light >= 0) { irradiance = ground_irradiance(u_light, ground_position(v_ndc)); }
#endif
#ifdef AREA_LIGHTS
    if (u_area >= 0) { irradiance = ground_area_irradiance(u_area, ground_position(v_ndc)); }
#endif
    o_blocked = vec4(irradiance * u_share, 0.0);
}
