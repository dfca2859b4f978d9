// The square of the ground that receives the shadow (src/gpu/draw/ground.hpp).
#include "shaders/lib/lights.glsl"
#ifdef AREA_LIGHTS
#include "shaders/lib/area_lights.glsl"
#endif

uniform vec3 u_ground_center;
uniform float u_ground_half;
uniform float u_ground_scale;  // stored values are irradiance times this

// The world position of `place` in [-1, 1]^2: x along the world's x axis, y along its z axis.
vec3 ground_position(vec2 place) {
    return u_ground_center + u_ground_half * vec3(place.x, 0.0, place.y);
}

#if LIGHTS > 0
// Unshadowed irradiance of the ground by light i, scaled and limited to the range of the texture.
vec3 ground_irradiance(int i, vec3 position) {
    vec3 irradiance;
    vec3 wi = light_direction(i, position, irradiance);
    return min(irradiance * (max(wi.y, 0.0) * u_ground_scale), vec3(1000.0));
}
#endif

#ifdef AREA_LIGHTS
// The same of light i with an area.
vec3 ground_area_irradiance(int i, vec3 position) {
    Frame axes = Frame(vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0), vec3(0.0, 0.0, 1.0));
    AreaLight light = area_light_at(i, position, axes);
    float share = area_cosine(light, area_shape(i), vec3(0.0, 1.0, 0.0));
    return min(u_area_radiance[i].rgb * (share * kPi * u_ground_scale), vec3(1000.0));
}
#endif
