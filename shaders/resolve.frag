// Shades each pixel once from the data of gbuffer.frag, by the same shade() as surface.frag.
#define FOOTPRINT_GIVEN
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
#include "shaders/lib/pack.glsl"

in vec2 v_ndc;
uniform highp usampler2D u_packed;
uniform sampler2D u_position;
#ifdef TABULATED
uniform highp sampler2D u_shape;
#endif
#ifdef VISIBILITY
uniform highp usampler2D u_seen0;
uniform highp usampler2D u_seen1;
#endif
uniform vec3 u_ray_center;
uniform vec3 u_ray_x;
uniform vec3 u_ray_y;
uniform ivec2 u_tile_origin;

layout(location = 0) out vec4 o_radiance;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    uvec4 words = texelFetch(u_packed, pixel, 0);
    Surface s;
#ifdef POSITION
    s.position = texelFetch(u_position, pixel, 0).xyz;
#else
    s.position = vec3(0.0);  // directional lights do not use it
#endif
    s.to_eye = -normalize(u_ray_center + u_ray_x * v_ndc.x + u_ray_y * v_ndc.y);
    s.normal = packed_normal(words);
    s.footprint = packed_footprint(words);
#ifdef TABULATED
    s.shape = texelFetch(u_shape, pixel, 0);
#endif
    s.tangent = packed_tangent(words);
    s.uv = vec4(packed_uv(words), 0.0, 0.0);
    s.color = vec4(1.0);
#ifdef VISIBILITY
    uvec4 seen0 = texelFetch(u_seen0, pixel, 0);
    uvec4 seen1 = texelFetch(u_seen1, pixel, 0);
    s.blocked = packed_blocked(seen0, seen1);
    s.around = packed_around(seen1);
#endif
    s.front = true;
    s.pixel = uvec2(pixel + u_tile_origin);
#ifdef VIEW
    o_radiance = vec4(surface_view(s), 1.0);
#else
    o_radiance = shade(s);
#endif
}
