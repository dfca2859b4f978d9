// Smith masking Lambda(w) and shadowing G of each distribution. w: direction in the lobe's own space,
// not necessarily unit (only x/z and y/z enter); G is 0 for w.z <= 0.

// 1 / (alpha(phi) tan theta), the argument of every Lambda here.
FN Float smith_argument(Float alpha_x, Float alpha_y, vec3 w) {
    Float x = alpha_x * w.x;
    Float y = alpha_y * w.y;
    return max(w.z, Float(0)) / sqrt(max(x * x + y * y, kTiny));
}

// Walter et al. 2007 Eq 34, exact for GGX.
FN Float lambda_ggx(Float a) {
    Float a2 = max(a * a, kTiny);
    return Float(0.5) * (sqrt(Float(1) + Float(1) / a2) - Float(1));
}

// Exact for Beckmann: (exp(-a^2)/(a sqrt(pi)) - erfc(a))/2.
FN Float lambda_beckmann(Float a) {
    Float c = clamp(a, Float(1e-15), Float(9));  // beyond 9 Lambda < 1e-37; below, G < 1e-15
    Float lambda = Float(0.5) * (exp(-c * c) / (c * sqrt(kPi)) - erfc(c));
    return max(lambda, Float(0));
}

FN Float smith_lambda(Lobe lobe, vec3 w) {
    Float a = smith_argument(lobe_alpha_x(lobe), lobe_alpha_y(lobe), w);
    if (lobe.mdf == kMdfGgx) { return lambda_ggx(a); }
    return lambda_beckmann(a);
}

FN Float smith_G1(Lobe lobe, vec3 w) {
    Float g = Float(1) / (Float(1) + smith_lambda(lobe, w));
    return choose(w.z > Float(0), g, Float(0));
}

// Height-correlated (Heitz 2014 Eq 99).
FN Float smith_G2(Lobe lobe, vec3 wi, vec3 wo) {
    Float g = Float(1) / (Float(1) + smith_lambda(lobe, wi) + smith_lambda(lobe, wo));
    return choose(wi.z > Float(0) && wo.z > Float(0), g, Float(0));
}
