// Lights with an area. AREA_LIGHTS: their number at compile time (1 to 8). AREA_TEXTURES: some have a texture.
// AREA_SHADOWS: they have shadow maps (shadow_maps.hpp), drawn from another point of the light in every frame.
// docs/theory/area-lights.md.
#include "shading/prelude.glsl"
#include "shading/frame.glsl"
#include "shading/surface/area_light.glsl"

// LIGHT_COUNT_AT_RUN_TIME: as in lights.glsl.
#ifdef LIGHT_COUNT_AT_RUN_TIME
uniform int u_area_count;
#define AREA_COUNT u_area_count
#else
#define AREA_COUNT AREA_LIGHTS
#endif

uniform vec4 u_area_middle[AREA_LIGHTS];    // w: the shape
uniform vec4 u_area_x[AREA_LIGHTS];         // half a side; w: 1 with two sides
uniform vec4 u_area_y[AREA_LIGHTS];         // w: layer of the texture, -1 none
uniform vec4 u_area_radiance[AREA_LIGHTS];  // rgb

int area_shape(int i) { return int(u_area_middle[i].w + 0.5); }

// Light i from `position`, its vectors against `a`.
AreaLight area_light_at(int i, vec3 position, Frame a) {
    return area_light_seen(area_shape(i), frame_to_local(a, u_area_middle[i].xyz - position),
                           frame_to_local(a, u_area_x[i].xyz), frame_to_local(a, u_area_y[i].xyz),
                           u_area_x[i].w > 0.5);
}

#ifdef AREA_TEXTURES
uniform highp sampler2DArray u_area_textures;

// The light's texture where the ray `towards` (local) meets its plane, blurred over `side` of a length at the light.
vec3 area_texture(int i, AreaLight light, vec3 towards, float side) {
    float layer = u_area_y[i].w;
    vec3 normal = cross(light.x, light.y);
    float facing = dot(normal, towards);
    vec3 at = towards * (dot(normal, light.middle) / (abs(facing) > kTiny ? facing : kTiny)) - light.middle;
    float x2 = max(dot(light.x, light.x), kTiny);
    float y2 = max(dot(light.y, light.y), kTiny);
    vec2 uv = 0.5 + 0.5 * vec2(dot(at, light.x) / x2, -dot(at, light.y) / y2);
    // Of texels: how many the footprint covers, in the direction in which they are small.
    float texels = side / (2.0 * sqrt(min(x2, y2))) * float(textureSize(u_area_textures, 0).x);
    vec3 color = textureLod(u_area_textures, vec3(clamp(uv, 0.0, 1.0), max(layer, 0.0)),
                            log2(max(texels, 1.0))).rgb;
    return layer < 0.0 ? vec3(1.0) : color;
}
#endif

#ifdef AREA_SHADOWS
uniform vec2 u_area_shadow[AREA_LIGHTS];  // first map or -1, number of maps
uniform vec3 u_area_point[AREA_LIGHTS];   // where the maps of this frame are drawn from

float area_reaches(int i, vec3 position, vec3 normal) {
    vec3 away = u_area_point[i] - position;
    return map_reaches(u_area_shadow[i], u_area_point[i], position, normal,
                       away * inversesqrt(max(dot(away, away), kTiny)));
}
#else
float area_reaches(int i, vec3 position, vec3 normal) { return 1.0; }
#endif
