// Ashikhmin-Shirley distribution, K11 Eq 1 = K12 Eq 1: z^eps, eps = e_x cos^2 phi + e_y sin^2 phi.
// Exponents >= 0.

// ln z for a direction with sine squared s2 and cosine z: from s2 near the pole, from z near the rim.
FN Float log_cosine(Float s2, Float z) {
    Bool near_pole = s2 < Float(0.5);
    return choose(near_pole, Float(0.5), Float(1)) * log1m_or_log(near_pole, s2, max(z, kTiny));
}

// cos^2 phi = 1 at the pole, where phi is undefined (docs/theory/papers.md).
FN Float ashikhmin_shirley_exponent(Float e_x, Float e_y, Float x, Float y) {
    Float xx = x * x;
    Float yy = y * y;
    Float r2 = xx + yy;
    return choose(r2 > kTiny, (e_x * xx + e_y * yy) / max(r2, kTiny), e_x);
}

FN Float mdf_ashikhmin_shirley_shape(Float e_x, Float e_y, LobePoint q) {
    return exp(ashikhmin_shirley_exponent(e_x, e_y, q.x, q.y) * log_cosine(q.s2, q.z));
}

// Int shape dw = 1 / this: the paper's "probability" is per solid angle.
FN Float mdf_ashikhmin_shirley_solid_norm(Float e_x, Float e_y) {
    return sqrt((e_x + Float(1)) * (e_y + Float(1))) / (Float(2) * kPi);
}

// Int shape (n.h) dw = 1 / this.
FN Float mdf_ashikhmin_shirley_projected_norm(Float e_x, Float e_y) {
    return sqrt((e_x + Float(2)) * (e_y + Float(2))) / (Float(2) * kPi);
}

// Samples D (n.h): the 2000 paper's Eq 9, 10 with every exponent raised by one.
FN vec3 mdf_ashikhmin_shirley_sample(Float e_x, Float e_y, vec2 xi) {
    Float psi = Float(2) * kPi * xi.x;
    Float x = cos(psi) * sqrt(e_y + Float(2));
    Float y = sin(psi) * sqrt(e_x + Float(2));
    Float eps = ashikhmin_shirley_exponent(e_x, e_y, x, y);
    Float z = pow(max(Float(1) - xi.y, kTiny), Float(1) / (eps + Float(2)));
    Float s = sqrt(max(Float(1) - z * z, Float(0)) / max(x * x + y * y, kTiny));
    return vec3(s * x, s * y, z);
}
