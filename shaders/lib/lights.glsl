// Punctual lights as KHR_lights_punctual defines them. LIGHTS: their number at compile time (0 to
// 16). POSITION: some light has a position or casts a shadow, so that shading needs the position of
// the surface. SHADOW_MAPS: the number of maps (shadow_maps.hpp).
#include "shading/prelude.glsl"
#include "shading/surface/light.glsl"
// LIGHT_COUNT_AT_RUN_TIME: u_light_count of the LIGHTS are in use, so that one program serves
// scenes of any number of lights.
#if LIGHTS > 0

#ifdef LIGHT_COUNT_AT_RUN_TIME
uniform int u_light_count;
#define LIGHT_COUNT u_light_count
#else
#define LIGHT_COUNT LIGHTS
#endif

uniform vec4 u_light_place[LIGHTS];      // xyz: position, or towards a directional light; w: 0 or 1
uniform vec4 u_light_radiance[LIGHTS];   // rgb: color times intensity; w: 1 / range^2, 0 unbounded
uniform vec4 u_light_direction[LIGHTS];  // xyz: the direction of a spot
uniform vec2 u_light_cone[LIGHTS];       // parameters of spot_cone

// Direction towards light i from a position, and its irradiance on a surface facing it.
vec3 light_direction(int i, vec3 position, out vec3 irradiance) {
#ifndef POSITION
    irradiance = u_light_radiance[i].rgb;
    return u_light_place[i].xyz;
#else
    LightAtPoint l = light_at(u_light_place[i].xyz, u_light_place[i].w, u_light_direction[i].xyz,
                              u_light_cone[i], u_light_radiance[i].w, position);
    irradiance = u_light_radiance[i].rgb * l.falloff;
    return l.wi;
#endif
}

#if defined(SHADOW_MAPS) && SHADOW_MAPS > 0
uniform sampler2DArrayShadow u_shadow_maps;
uniform mat4 u_shadow_clip[SHADOW_MAPS];
// Side in the world; at distance 1 for lights with a position.
uniform float u_shadow_texel[SHADOW_MAPS];
uniform vec2 u_shadow_of_light[LIGHTS];     // first map or -1, number of maps

int face_towards(vec3 d) {
    vec3 l = abs(d);
    if (l.x >= l.y && l.x >= l.z) { return d.x > 0.0 ? 0 : 1; }
    if (l.y >= l.z) { return d.y > 0.0 ? 2 : 3; }
    return d.z > 0.0 ? 4 : 5;
}

// 1 where light i reaches the position, 0 in its shadow; `normal` unit, `wi` towards the light. The
// look-up position is offset from the surface by the size of a texel on it, which is largest at
// grazing angles: a texel holds one depth for its whole area, and the look-up reads 2 x 2 texels.
float light_reaches(int i, vec3 position, vec3 normal, vec3 wi) {
    if (u_shadow_of_light[i].x < 0.0) { return 1.0; }
    int map = int(u_shadow_of_light[i].x);
    if (u_shadow_of_light[i].y > 1.0) { map += face_towards(position - u_light_place[i].xyz); }
    float depth = (u_shadow_clip[map] * vec4(position, 1.0)).w;
    float cosine = dot(normal, wi);
    float side = cosine < 0.0 ? -1.0 : 1.0;
    float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
    float off = u_shadow_texel[map] * depth * (0.5 + 2.0 * sine);
    vec4 clip = u_shadow_clip[map] * vec4(position + normal * (side * off), 1.0);
    if (clip.w <= 0.0) { return 1.0; }
    vec3 place = clip.xyz / clip.w * 0.5 + 0.5;
    if (any(lessThan(place, vec3(0.0))) || any(greaterThan(place, vec3(1.0)))) { return 1.0; }
    return texture(u_shadow_maps, vec4(place.xy, float(map), place.z));
}
#endif

#endif
