// Forward shading: one invocation a fragment.
#include "shading"
#include "shaders/lib/random.glsl"
#include "shaders/lib/output.glsl"
#include "shaders/lib/surface.glsl"
#ifdef TABULATED
#include "shaders/lib/tabulated.glsl"
#endif
#include "shaders/lib/material.glsl"
#if defined(COMPENSATED) || (IMAGE_LIGHT == 3 && !defined(COSINE_LOBE))
#include "shaders/lib/albedo.glsl"
#endif
#include "shaders/lib/specular.glsl"
#include "shaders/lib/lights.glsl"
#ifdef AREA_LIGHTS
#include "shaders/lib/area_lights.glsl"
#endif
#include "shaders/lib/environment.glsl"
#include "shaders/lib/visibility.glsl"
#if IMAGE_LIGHT == 1
#include "shaders/lib/image_samples.glsl"
#endif
#include "shaders/lib/layers.glsl"
#ifdef AREA_LIGHTS
#include "shaders/lib/area_lit.glsl"
#endif
#include "shaders/lib/image_light.glsl"
#ifdef CLOTH
#include "shaders/lib/cloth.glsl"
#endif
#include "shaders/lib/shade.glsl"
#ifdef VIEW
#include "shaders/lib/view.glsl"
#endif

in vec3 v_position;
in vec3 v_normal;
in vec4 v_tangent;
#ifdef UV_PER_TEXTURE
in vec4 v_uv;
#else
in vec2 v_uv;
#endif
#ifdef VERTEX_COLOR
in vec4 v_color;
#endif
#ifdef VISIBILITY
in vec4 v_blocked0;
in vec4 v_blocked1;
in vec4 v_blocked2;
in vec4 v_blocked3;
in vec4 v_around_color;  // and the ratio of the sky, less 1, of the back
in vec4 v_around_slope;  // and the same of the front
#endif

uniform ivec2 u_tile_origin;
uniform vec4 u_eye;  // xyz: eye position, w = 1; orthographic: towards the viewer, w = 0

layout(location = 0) out vec4 o_radiance;

void main() {
    Surface s;
    s.position = v_position;
    s.to_eye = normalize(u_eye.xyz - v_position * u_eye.w);
    s.normal = v_normal;
    s.tangent = v_tangent;
#ifdef UV_PER_TEXTURE
    s.uv = v_uv;
#else
    s.uv = vec4(v_uv, v_uv);
#endif
    s.footprint = 0.0;
#ifdef VERTEX_COLOR
    s.color = v_color;
#else
    s.color = vec4(1.0);
#endif
#ifdef VISIBILITY
    s.blocked = harmonics_of(v_blocked0, v_blocked1, v_blocked2, v_blocked3);
    float sky = gl_FrontFacing ? v_around_slope.w : v_around_color.w;
    s.around = Surroundings(v_around_color.rgb, v_around_slope.xyz, sky + 1.0);
#endif
    s.front = gl_FrontFacing;
    s.pixel = uvec2(ivec2(gl_FragCoord.xy) + u_tile_origin);
#ifdef VIEW
    o_radiance = vec4(surface_view(s), 1.0);
#else
    o_radiance = shade(s);
#endif
}
