// Vertices of a surface in world space, for surface.frag.
#include "shading/prelude.glsl"
#include "shading/surface/tangent.glsl"

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec4 a_tangent;
layout(location = 3) in vec2 a_texcoord0;
layout(location = 4) in vec2 a_texcoord1;
layout(location = 5) in vec4 a_color;
#ifdef VISIBILITY
layout(location = 6) in vec4 a_blocked0;  // Harmonics in the order of its members
layout(location = 7) in vec4 a_blocked1;
layout(location = 8) in vec4 a_blocked2;
layout(location = 9) in vec4 a_blocked3;
layout(location = 10) in vec4 a_around0;  // Surroundings
layout(location = 11) in vec4 a_around1;
#endif

uniform mat4 u_clip_from_world;
uniform mat4 u_world_from_local;
uniform mat3 u_normal_from_local;  // inverse transpose
uniform float u_mirror;            // -1 when the transform reverses handedness
uniform vec3 u_uv_row_s;           // the one texture transform in use
uniform vec3 u_uv_row_t;
uniform float u_uv_from_set;

out vec3 v_position;
out vec3 v_normal;
out vec4 v_tangent;
#ifdef UV_PER_TEXTURE
out vec4 v_uv;
#else
out vec2 v_uv;
#endif
#ifdef VERTEX_COLOR
out vec4 v_color;
#endif
#ifdef VISIBILITY
out vec4 v_blocked0;
out vec4 v_blocked1;
out vec4 v_blocked2;
out vec4 v_blocked3;
out vec4 v_around_color;
out vec4 v_around_slope;
#endif

void main() {
    vec4 world = u_world_from_local * vec4(a_position, 1.0);
    v_position = world.xyz;
    // 1e-30: a zero normal stays zero (surface_frame handles it).
    v_normal = u_normal_from_local * a_normal;
    v_normal *= inversesqrt(max(dot(v_normal, v_normal), 1e-30));
    vec3 t = mat3(u_world_from_local) * a_tangent.xyz;
    t *= inversesqrt(max(dot(t, t), 1e-30));
    v_tangent = vec4(tangent_or_any(v_normal, t), a_tangent.w * u_mirror);
#ifdef UV_PER_TEXTURE
    v_uv = vec4(a_texcoord0, a_texcoord1);
#else
    vec3 uv = vec3(u_uv_from_set < 0.5 ? a_texcoord0 : a_texcoord1, 1.0);
    v_uv = vec2(dot(u_uv_row_s, uv), dot(u_uv_row_t, uv));
#endif
#ifdef VERTEX_COLOR
    v_color = a_color;
#endif
#ifdef VISIBILITY
    v_blocked0 = a_blocked0;
    v_blocked1 = a_blocked1;
    v_blocked2 = a_blocked2;
    v_blocked3 = a_blocked3;
    v_around_color = vec4(a_around0.xyz, a_around1.w);
    v_around_slope = vec4(a_around0.w, a_around1.xyz);
#endif
    gl_Position = u_clip_from_world * world;
}
