// Shading once a pixel, from the images of gbuffer.frag, by the same shade() as surface.frag.
#define FOOTPRINT_GIVEN
#include "shading"
#include "shaders/lib/random.glsl"
#include "shaders/lib/output.glsl"
#include "shaders/lib/surface.glsl"
#include "shaders/lib/material.glsl"
#include "shaders/lib/lights.glsl"
#include "shaders/lib/environment.glsl"
#include "shaders/lib/image_light.glsl"
#include "shaders/lib/shade.glsl"

in vec2 v_ndc;
uniform sampler2D u_normal_u;
uniform sampler2D u_tangent_v;
uniform sampler2D u_position;
uniform vec3 u_ray_center;
uniform vec3 u_ray_x;
uniform vec3 u_ray_y;
uniform ivec2 u_tile_origin;

layout(location = 0) out vec4 o_radiance;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 normal_u = texelFetch(u_normal_u, pixel, 0);
    vec4 tangent_v = texelFetch(u_tangent_v, pixel, 0);
    float n2 = max(dot(normal_u.xyz, normal_u.xyz), 1e-30);
    Surface s;
#ifdef POSITION
    s.position = texelFetch(u_position, pixel, 0).xyz;
#else
    s.position = vec3(0.0);  // directional lights do not ask
#endif
    s.to_eye = -normalize(u_ray_center + u_ray_x * v_ndc.x + u_ray_y * v_ndc.y);
    s.normal = normal_u.xyz;
    s.footprint = sqrt(n2) - 32.0;
    s.tangent = vec4(tangent_v.xyz, 2.25 - dot(tangent_v.xyz, tangent_v.xyz));
    s.uv = vec4(normal_u.w, tangent_v.w, 0.0, 0.0);
    s.color = vec4(1.0);
    s.front = true;
    s.pixel = uvec2(pixel + u_tile_origin);
    o_radiance = shade(s);
}
