// Writes the data that resolve.frag needs to shade a pixel once.
#include "shaders/lib/pack.glsl"

in vec3 v_position;
in vec3 v_normal;
in vec4 v_tangent;
in vec2 v_uv;

layout(location = 0) out uvec4 o_packed;
#ifdef POSITION
layout(location = 1) out vec4 o_position;
#endif
#ifdef SHAPE
layout(location = 2) out vec4 o_shape;
#endif

void main() {
    vec2 dx = dFdx(v_uv);
    vec2 dy = dFdy(v_uv);
    float footprint2 = max(dot(dx, dx), dot(dy, dy));
#ifdef DOUBLE_SIDED
    float side = gl_FrontFacing ? 1.0 : -1.0;
    o_packed = packed_pixel(v_normal * side, v_tangent.xyz * side, v_tangent.w * side, footprint2,
                            v_uv);
#else
    o_packed = packed_pixel(v_normal, v_tangent.xyz, v_tangent.w, footprint2, v_uv);
#endif
#ifdef POSITION
    o_position = vec4(v_position, 1.0);
#endif
#ifdef SHAPE
    o_shape = vec4(dx, dy);
#endif
}
