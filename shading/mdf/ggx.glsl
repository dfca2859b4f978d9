// Anisotropic GGX (Trowbridge-Reitz; Walter et al. 2007): 1/((x/alpha_x)^2 + (y/alpha_y)^2 + z^2)^2,
// times 1/(pi alpha_x alpha_y) for Int D (n.h) dw = 1.

FN Float mdf_ggx_shape(Float alpha_x, Float alpha_y, LobePoint q) {
    Float x = q.x * (Float(1) / alpha_x);
    Float y = q.y * (Float(1) / alpha_y);
    // 1e-16: as in beckmann.glsl; reached only by normal-map, at h = n under a 90 degree tilt.
    Float r = max(x * x + y * y + q.z * q.z, Float(1e-16));
    return Float(1) / (r * r);
}

// Samples D (n.h).
FN vec3 mdf_ggx_sample(Float alpha_x, Float alpha_y, vec2 xi) {
    Float psi = Float(2) * kPi * xi.x;
    Float r = sqrt(xi.y / max(Float(1) - xi.y, kTiny));
    return normalize(vec3(alpha_x * r * cos(psi), alpha_y * r * sin(psi), Float(1)));
}
