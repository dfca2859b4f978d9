// The environment as a point sees it past what blocks it (VISIBILITY): shading/surface/visibility.glsl. Included
// after surface.glsl and environment.glsl. Directions in world space.

#ifdef VISIBILITY
Harmonics harmonics_of(vec4 a, vec4 b, vec4 c, vec4 d) {
    return Harmonics(a.x, a.yzw, b.xyz, vec2(b.w, c.x), c.yzw, d.xyz, d.w);
}

// `radiance`: of the environment in direction w.
vec3 seen_radiance(Surface s, vec3 w, vec3 radiance) {
    float blocked = blocked_towards(s.blocked, w);
    return radiance * (1.0 - blocked) + surroundings_towards(s.around, w) * blocked;
}

// Over pi.
vec3 seen_irradiance(Surface s, vec3 n) {
    float blocked = blocked_about(s.blocked, n);
    vec3 open = open_direction(s.blocked, n);
    return environment_irradiance(open * inversesqrt(max(dot(open, open), kTiny))) *
               ((1.0 - blocked) * s.around.sky) +
           surroundings_about(s.around, blocked, n);
}

// The part of an occlusion map that the meshes do not already show.
float occlusion_left(Surface s, vec3 n, float occlusion) {
    // 0.02: below it nothing is left to darken.
    return min(occlusion / max(1.0 - blocked_about(s.blocked, n), 0.02), 1.0);
}
#else
vec3 seen_radiance(Surface s, vec3 w, vec3 radiance) { return radiance; }
vec3 seen_irradiance(Surface s, vec3 n) { return environment_irradiance(n); }
float occlusion_left(Surface s, vec3 n, float occlusion) { return occlusion; }
#endif
