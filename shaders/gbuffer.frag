// What resolve.frag needs to shade a pixel once.
#include "shaders/lib/pack.glsl"

in vec3 v_position;
in vec3 v_normal;
in vec4 v_tangent;
in vec2 v_uv;

layout(location = 0) out uvec4 o_packed;
#ifdef POSITION
layout(location = 1) out vec4 o_position;
#endif

void main() {
    float side = gl_FrontFacing ? 1.0 : -1.0;
    vec2 dx = dFdx(v_uv);
    vec2 dy = dFdy(v_uv);
    o_packed = packed_pixel(v_normal * side, v_tangent.xyz * side, v_tangent.w * side < 0.0,
                            max(dot(dx, dx), dot(dy, dy)), v_uv);
#ifdef POSITION
    o_position = vec4(v_position, 1.0);
#endif
}
