// Limits outputs to finite, non-negative half floats.

float finite_radiance(float v) {
    return isnan(v) ? 0.0 : clamp(v, 0.0, 65504.0);
}

vec3 finite_radiance(vec3 v) {
    return vec3(finite_radiance(v.x), finite_radiance(v.y), finite_radiance(v.z));
}

// A coverage in [0, 1]. Textures may hold any value; NaN becomes 1.
float finite_coverage(float v) {
    return isnan(v) ? 1.0 : clamp(v, 0.0, 1.0);
}
