// Punctual lights as KHR_lights_punctual has them. LIGHTS: how many, at compile time (0 to 16);
// POSITION: one of them has a place, so that shading must know where the surface is.
#if LIGHTS > 0

uniform vec4 u_light_place[LIGHTS];      // xyz: position, or towards a directional light; w: 0 or 1
uniform vec4 u_light_radiance[LIGHTS];   // rgb: colour times intensity; w: 1 / range^2, 0 unbounded
uniform vec4 u_light_direction[LIGHTS];  // xyz: the way a spot points
uniform vec2 u_light_cone[LIGHTS];       // x (cos angle) + y, clamped and squared, is the cone

// Direction towards light i from a position, and the irradiance it gives a surface facing it.
vec3 light_direction(int i, vec3 position, out vec3 irradiance) {
#ifndef POSITION
    irradiance = u_light_radiance[i].rgb;
    return u_light_place[i].xyz;
#else
    vec3 to_light = u_light_place[i].xyz - position * u_light_place[i].w;
    // 1e-12: a micrometre squared; nothing is shaded closer to a light.
    float d2 = max(dot(to_light, to_light), 1e-12);
    vec3 wi = to_light * inversesqrt(d2);
    float reach = d2 * u_light_radiance[i].w;
    float window = clamp(1.0 - reach * reach, 0.0, 1.0);
    float cone = clamp(-dot(u_light_direction[i].xyz, wi) * u_light_cone[i].x + u_light_cone[i].y,
                       0.0, 1.0);
    irradiance = u_light_radiance[i].rgb * (window * cone * cone / d2);
    return wi;
#endif
}

#endif
