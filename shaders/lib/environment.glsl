// Light of the environment: cube maps of radiance with mips, of radiance blurred by lobes, and of
// irradiance. FURNACE: a uniform white one in its place.

uniform samplerCube u_environment;
uniform samplerCube u_lobes;           // level l: blurred by GGX of alpha 2^(u_lobe_log2_alpha + l); 0 sharp
uniform samplerCube u_irradiance;      // irradiance / pi
uniform vec2 u_environment_turn;       // (cos, sin) of the rotation about +y
uniform float u_environment_scale;  // radiance and irradiance are stored values times this
uniform float u_environment_face;      // texels a side of a face
uniform float u_environment_last_lod;
uniform float u_lobe_log2_alpha;

// Rotates a world direction into the environment.
vec3 environment_direction(vec3 w) {
    vec2 r = u_environment_turn;
    return vec3(r.x * w.x - r.y * w.z, w.y, r.y * w.x + r.x * w.z);
}

#ifdef FURNACE
// A white furnace: radiance 1 from everywhere, so that what a surface reflects is its albedo.
vec3 environment_radiance(vec3 w, float lod) { return vec3(1.0); }
vec3 environment_irradiance(vec3 n) { return vec3(1.0); }
#else
vec3 environment_radiance(vec3 w, float lod) {
    return textureLod(u_environment, environment_direction(w), lod).rgb * u_environment_scale;
}

vec3 environment_irradiance(vec3 n) {
    return textureLod(u_irradiance, environment_direction(n), 0.0).rgb * u_environment_scale;
}
#endif

// The mip level whose texels cover `solid_angle`; a texel of the finest covers 4 pi / (6 face^2) on
// average.
float environment_lod(float solid_angle) {
    float texels = solid_angle * (6.0 / (4.0 * kPi)) * u_environment_face * u_environment_face;
    return clamp(0.5 * log2(max(texels, 1.0)), 0.0, u_environment_last_lod);
}

// Radiance from the lobe map, in units of u_environment_scale; `w` is in the rotated environment.
vec3 lobe_radiance(vec3 w, float lod) {
    return textureLod(u_lobes, w, lod).rgb;
}

// The level of the lobe map for a round lobe of roughness alpha about its direction.
float lobe_lod(float alpha2) {
    return max(0.5 * log2(max(alpha2, kTiny)) - u_lobe_log2_alpha, 0.0);
}
