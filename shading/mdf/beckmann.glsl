// Anisotropic Beckmann distribution: exp(-((x/alpha_x)^2 + (y/alpha_y)^2)/z^2) / z^4, times
// 1/(pi alpha_x alpha_y) for Int D (n.h) dw = 1.

// 1/z^2, z^2 held above 1e-16: 1/(pi alpha_x alpha_y z^4) still fits single precision for alphas
// from 0.001, and the exponential is 0 long before.
FN Float slope_inverse_z2(LobePoint q) {
    return Float(1) / max(q.z * q.z, Float(1e-16));
}

// exp(-((x/alpha_x)^2 + (y/alpha_y)^2)/z^2): the normal distribution of slopes, peak 1.
FN Float slope_gaussian(Float alpha_x, Float alpha_y, LobePoint q) {
    Float x = q.x * (Float(1) / alpha_x);
    Float y = q.y * (Float(1) / alpha_y);
    return exp(-(x * x + y * y) * slope_inverse_z2(q));
}

FN Float mdf_beckmann_shape(Float alpha_x, Float alpha_y, LobePoint q) {
    Float inverse_z2 = slope_inverse_z2(q);
    return slope_gaussian(alpha_x, alpha_y, q) * (inverse_z2 * inverse_z2);
}

// Samples D (n.h): an ellipse of normally distributed slopes.
FN vec3 mdf_beckmann_sample(Float alpha_x, Float alpha_y, vec2 xi) {
    Float psi = Float(2) * kPi * xi.x;
    Float r = sqrt(-log(max(Float(1) - xi.y, kTiny)));
    return normalize(vec3(alpha_x * r * cos(psi), alpha_y * r * sin(psi), Float(1)));
}
