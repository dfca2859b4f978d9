// Punctual lights as KHR_lights_punctual defines them. LIGHTS: their number at compile time (0 to
// 16). POSITION: some light has a position or casts a shadow, so that shading needs the position of
// the surface. SHADOW_MAPS: the number of maps (shadow_maps.hpp).
#include "shading/prelude.glsl"
#include "shading/surface/light.glsl"
#include "shaders/lib/shadow_maps.glsl"
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
uniform vec2 u_shadow_of_light[LIGHTS];     // first map or -1, number of maps

// 1 where light i reaches the position, 0 in its shadow; `normal` unit, `wi` towards the light.
float light_reaches(int i, vec3 position, vec3 normal, vec3 wi) {
    return map_reaches(u_shadow_of_light[i], u_light_place[i].xyz, position, normal, wi);
}
#endif

#endif
