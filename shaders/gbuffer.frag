// Writes the data that resolve.frag needs to shade a pixel once.
#include "shading/prelude.glsl"
#include "shading/surface/visibility.glsl"
#include "shaders/lib/pack.glsl"

in vec3 v_position;
in vec3 v_normal;
in vec4 v_tangent;
in vec2 v_uv;
#ifdef VISIBILITY
in vec4 v_blocked0;
in vec4 v_blocked1;
in vec4 v_blocked2;
in vec4 v_blocked3;
in vec4 v_around_color;  // and the ratio of the sky, less 1, of the back
in vec4 v_around_slope;  // and the same of the front
#endif

layout(location = 0) out uvec4 o_packed;
#ifdef POSITION
layout(location = 1) out vec4 o_position;
#endif
#ifdef SHAPE
layout(location = 2) out vec4 o_shape;
#endif

#ifdef VISIBILITY
layout(location = 3) out uvec4 o_seen0;
layout(location = 4) out uvec4 o_seen1;
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
#ifdef VISIBILITY
    float sky = gl_FrontFacing ? v_around_slope.w : v_around_color.w;
    o_seen0 = uvec4(packed_three(vec3(v_blocked0.x - 0.5, v_blocked0.yz)),
                    packed_three(vec3(v_blocked0.w, v_blocked1.xy)),
                    packed_three(vec3(v_blocked1.zw, v_blocked2.x)), packed_three(v_blocked2.yzw));
    o_seen1 = uvec4(packed_three(v_blocked3.xyz), packed_three(vec3(v_blocked3.w, sky * 0.125, 0.0)),
                    packed_color(v_around_color.rgb), packed_three(v_around_slope.xyz * 0.125));
#endif
#ifdef SHAPE
    o_shape = vec4(dx, dy);
#endif
}
