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

// Ashikhmin-Shirley and Ward have no closed Lambda. Both are fitted in one form, exp(-T)/(a (c0 + v
// (c1 + v c2))), found against quadrature: along the projected direction of w the A-S lobe is exactly
// Student-t between GGX (e = 0) and Beckmann (e -> inf), so beside the width a it needs the shape s
// towards w and the mean shape g. |G1 error| <= 0.0114, <= 0.0014 for alpha <= 0.3 (A-S) and
// <= 0.011, <= 0.001 (Ward): tests/shading/smith_test.cpp. Fitted for alpha <= 1; beyond, g and s
// are held at 1.
struct SmithFit {
    Float g;  // (alpha_x^2 + alpha_y^2) / 2
    Float s;  // alpha^2 towards w, weighted by its part in the slope
    Float a;  // 1 / (alpha(phi) tan theta)
    Float a2;
};

FN SmithFit smith_fit(Float alpha_x, Float alpha_y, vec3 w) {
    Float ax2 = alpha_x * alpha_x;
    Float ay2 = alpha_y * alpha_y;
    Float xx = ax2 * w.x * w.x;
    Float yy = ay2 * w.y * w.y;
    Float r2 = max(xx + yy, kTiny);
    SmithFit f;
    f.g = min(Float(0.5) * (ax2 + ay2), Float(1));
    f.s = min((xx * ax2 + yy * ay2) / r2, Float(1));
    f.a2 = max(w.z * w.z / r2, kTiny);
    f.a = sqrt(f.a2);
    return f;
}

// 80: exp(-80) is 0 beside 1 in any precision.
FN Float lambda_fitted(Float exponent, Float a, Float v, Float c0, Float c1, Float c2) {
    return exp(-min(exponent, Float(80))) / (a * (c0 + v * (c1 + v * c2)));
}

FN Float lambda_ashikhmin_shirley(Float alpha_x, Float alpha_y, vec3 w) {
    SmithFit f = smith_fit(alpha_x, alpha_y, w);
    Float q = Float(1) / sqrt(Float(1) + f.s * f.a2);
    Float exponent = (Float(1) - Float(0.5) * f.s) * f.a2 * q;
    return lambda_fitted(exponent, f.a, f.a * q,
                         Float(3.5593) - Float(0.9052) * f.g - Float(0.7981) * f.s,
                         Float(6.0554) - Float(3.0206) * f.g - Float(0.4787) * f.s,
                         Float(4.904) * max(Float(0), Float(1) - Float(2) * f.g));
}

FN Float lambda_ward(Float alpha_x, Float alpha_y, vec3 w) {
    SmithFit f = smith_fit(alpha_x, alpha_y, w);
    Float q = Float(1) / sqrt(Float(1) + f.s * f.a2);
    Float exponent = Float(2) * f.a2 * q * q / (Float(1) + q);  // Ward's own, at the masking edge
    Float m = (Float(1) - f.g) * (Float(1) - f.g);
    return lambda_fitted(
        exponent, f.a, f.a * q,
        Float(3.5593) - Float(1.8112) * f.g + Float(1.0955) * f.g * f.g + Float(0.3318) * f.s,
        Float(6.0554) - Float(2.6216) * f.g - Float(1.3995) * f.g * f.g + Float(2.3637) * f.s,
        Float(4.904) * m * m);
}

FN Float smith_lambda(Lobe lobe, vec3 w) {
    Float lambda = Float(0);
    if (lobe.mdf == kMdfAshikhminShirley) {
        lambda = lambda_ashikhmin_shirley(lobe_alpha_x(lobe), lobe_alpha_y(lobe), w);
    } else if (lobe.mdf == kMdfWard) {
        lambda = lambda_ward(lobe.p0, lobe.p1, w);
    } else if (lobe.mdf == kMdfBeckmann) {
        lambda = lambda_beckmann(smith_argument(lobe.p0, lobe.p1, w));
    } else {
        lambda = lambda_ggx(smith_argument(lobe.p0, lobe.p1, w));
    }
    return lambda;
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
