// Ward's distribution as K12 Eq 3 means it (squares restored: docs/theory/papers.md), peak 1:
// exp(-2 ((x/alpha_x)^2 + (y/alpha_y)^2) / (1 + z)). 2/(1+z) is Ward's approximation to 1/z^2.

FN Float mdf_ward_shape(Float alpha_x, Float alpha_y, LobePoint q) {
    Float x = q.x * (Float(1) / alpha_x);  // the reciprocal is the lobe's, not the direction's
    Float y = q.y * (Float(1) / alpha_y);
    return exp(-Float(2) * (x * x + y * y) / (Float(1) + q.z));
}

// 1 / Int shape (n.h) dw. With u = 1 - z and m(psi) = alpha_x^2 cos^2 psi + alpha_y^2 sin^2 psi the
// integral is pi alpha_x alpha_y (1 - (alpha_x^2 + alpha_y^2)/4 + mean_psi(m exp(-2/m))/2); the mean
// by n Gauss-Chebyshev nodes, the rest exact. Relative error, worst case 100:1: n = 4 2e-5, 8 8e-8,
// 24 3e-14 for alpha <= 1; 8 3e-5, 24 1e-9, 48 4e-14 for alpha <= 2.
FN Float mdf_ward_projected_norm(Float alpha_x, Float alpha_y) {
    Float xx = alpha_x * alpha_x;
    Float yy = alpha_y * alpha_y;
    Float mean = Float(0);
    for (int j = 0; j < kWardNodes; ++j) {
        Float c = cos(Float(2 * j + 1) * kPi / Float(4 * kWardNodes));
        Float m = yy + (xx - yy) * c * c;
        mean = mean + m * exp(-Float(2) / max(m, kTiny));
    }
    mean = mean / Float(kWardNodes);
    Float tail = Float(1) - (xx + yy) / Float(4) + mean / Float(2);
    return Float(1) / (kPi * alpha_x * alpha_y * tail);
}

// Slope concentration k(phi) = (cos phi/alpha_x)^2 + (sin phi/alpha_y)^2.
FN Float ward_concentration(Float alpha_x, Float alpha_y, Float x, Float y) {
    Float u = x / alpha_x;
    Float v = y / alpha_y;
    return (u * u + v * v) / max(x * x + y * y, kTiny);
}

// Samples shape / (1 - exp(-2k)) per solid angle: azimuth by the ellipse, 1 - z exponential, cut at
// the horizon.
FN vec3 mdf_ward_sample(Float alpha_x, Float alpha_y, vec2 xi) {
    Float psi = Float(2) * kPi * xi.x;
    Float x = alpha_x * cos(psi);
    Float y = alpha_y * sin(psi);
    Float two_k = Float(2) * ward_concentration(alpha_x, alpha_y, x, y);
    Float u = -log(max(Float(1) - xi.y * (Float(1) - exp(-two_k)), kTiny)) / two_k;
    u = min(u, Float(1));
    Float s = sqrt(u * (Float(2) - u) / max(x * x + y * y, kTiny));
    return vec3(s * x, s * y, Float(1) - u);
}

FN Float mdf_ward_pdf(Float alpha_x, Float alpha_y, LobePoint q) {
    Float pole = max(alpha_x, alpha_y);  // where phi is undefined any k > 0 does; this is the least
    Float k = choose(q.x * q.x + q.y * q.y > kTiny,
                     ward_concentration(alpha_x, alpha_y, q.x, q.y), Float(1) / (pole * pole));
    return mdf_ward_shape(alpha_x, alpha_y, q) /
           (kPi * alpha_x * alpha_y * (Float(1) - exp(-Float(2) * k)));
}
