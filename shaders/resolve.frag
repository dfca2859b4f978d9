// Shading once a pixel: the triangle that visibility.frag has written there, its three vertices, the
// place within it and the footprint of the pixel on its texture, then the same shade() as surface.frag.
#define TEXTURE_GRADIENTS
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
uniform highp usampler2D u_visible;    // triangle seen
uniform highp usampler2D u_triangles;  // three vertices a triangle, 4096 triangles a row
uniform highp sampler2D u_vertices;    // three texels a vertex, 1024 vertices a row
uniform mat4 u_clip_from_world;
uniform vec2 u_ndc_per_pixel;
uniform ivec2 u_tile_origin;
uniform vec3 u_uv_row_s;
uniform vec3 u_uv_row_t;

layout(location = 0) out vec4 o_radiance;

struct Corner {
    vec4 a;  // position, u
    vec4 b;  // normal, v
    vec4 c;  // tangent
    vec3 d;  // clip x and y relative to the pixel, and w
};

Corner corner_of(uint vertex) {
    ivec2 at = ivec2(int(vertex & 1023u) * 3, int(vertex >> 10));
    Corner k;
    k.a = texelFetch(u_vertices, at, 0);
    k.b = texelFetch(u_vertices, at + ivec2(1, 0), 0);
    k.c = texelFetch(u_vertices, at + ivec2(2, 0), 0);
    vec4 clip = u_clip_from_world * vec4(k.a.xyz, 1.0);
    // Relative to the pixel first: edges of small triangles are differences of large numbers.
    k.d = vec3(clip.xy - v_ndc * clip.w, clip.w);
    return k;
}

// Homogeneous barycentric weight of the corner opposite to the edge p, q, and its change a pixel.
vec3 edge_weight(vec3 p, vec3 q) {
    return vec3(p.x * q.y - p.y * q.x, (q.z * p.y - p.z * q.y) * u_ndc_per_pixel.x,
                (p.z * q.x - q.z * p.x) * u_ndc_per_pixel.y);
}

vec2 mapped_uv(vec2 uv) {
    vec3 p = vec3(uv, 1.0);
    return vec2(dot(u_uv_row_s, p), dot(u_uv_row_t, p));
}

void main() {
    uint triangle = texelFetch(u_visible, ivec2(gl_FragCoord.xy), 0).r;
    uvec4 t = texelFetch(u_triangles, ivec2(int(triangle & 4095u), int(triangle >> 12)), 0);
    Corner k0 = corner_of(t.x);
    Corner k1 = corner_of(t.y);
    Corner k2 = corner_of(t.z);
    vec3 w0 = edge_weight(k1.d, k2.d);
    vec3 w1 = edge_weight(k2.d, k0.d);
    vec3 w2 = edge_weight(k0.d, k1.d);
    vec3 w = w0 + w1 + w2;
    // A triangle seen exactly edge-on covers no pixel; 1e-30 keeps a stray one finite.
    float scale = 1.0 / (abs(w.x) > 1e-30 ? w.x : 1e-30);
    vec3 m = vec3(w0.x, w1.x, w2.x) * scale;
    vec2 uv0 = mapped_uv(vec2(k0.a.w, k0.b.w));
    vec2 uv1 = mapped_uv(vec2(k1.a.w, k1.b.w));
    vec2 uv2 = mapped_uv(vec2(k2.a.w, k2.b.w));
    vec2 uv = uv0 * m.x + uv1 * m.y + uv2 * m.z;
    float gradient = scale * u_gradient_scale;
    Surface s;
    s.position = k0.a.xyz * m.x + k1.a.xyz * m.y + k2.a.xyz * m.z;
    s.normal = k0.b.xyz * m.x + k1.b.xyz * m.y + k2.b.xyz * m.z;
    s.tangent = k0.c * m.x + k1.c * m.y + k2.c * m.z;
    s.uv = vec4(uv, uv);
    s.uv_dx = vec4((uv0 * w0.y + uv1 * w1.y + uv2 * w2.y - uv * w.y) * gradient,
                   (uv0 * w0.z + uv1 * w1.z + uv2 * w2.z - uv * w.z) * gradient);
    s.color = vec4(1.0);
    s.front = w.x > 0.0;
    s.pixel = uvec2(ivec2(gl_FragCoord.xy) + u_tile_origin);
    o_radiance = shade(s);
}
