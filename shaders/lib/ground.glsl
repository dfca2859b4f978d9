// The square of the ground that receives the shadow (src/gpu/draw/ground.hpp).
#include "shaders/lib/lights.glsl"

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
