// A lobe widened by the slopes of detail too small to see. Detail whose slopes vary by variance_x,
// variance_y along the lobe's own axes makes of the density of the lobe's slopes, D (n.h)^4 at
// (-h.x/h.z, -h.y/h.z), its convolution with that of the detail: Olano & Baker, "LEAN Mapping", 2010;
// Dupuy et al. 2013. docs/theory/normal-filtering.md has the error of each against the convolution.

// Beckmann: slopes are Gaussian with variance alpha^2/2, so variances add. Exact. Ward's 1 - z in
// place of half the squared slope is the same for narrow lobes.
FN Float widen_gaussian(Float alpha, Float variance) {
    return sqrt(alpha * alpha + Float(2) * variance);
}

// GGX has no variance of slopes to add to. With a = alpha^2 and b = 2 variance the peak of a round GGX
// convolved with a Gaussian is 1/(pi b g), 1/g = e^t E2(t), t = a/b (E2 an exponential integral);
// a + b + a b / (a + b) is b g within 5 %, and exact where a or b vanishes.
FN Float widen_ggx(Float alpha, Float variance) {
    Float a = alpha * alpha;
    Float b = Float(2) * variance;
    return sqrt(a + b + a * b / max(a + b, kTiny));
}

// Ashikhmin-Shirley by alpha, which is that of the Beckmann lobe of the same peak. Its slopes' variance is
// 1/e; adding to that instead would leave the peak a third too high under coarse detail.
FN Float widen_exponent(Float e, Float variance) {
    Float wide = e + Float(2);
    return max(wide / (Float(1) + wide * variance) - Float(2), Float(0));
}

// Variances >= 0. Normalised as every lobe is, whatever its width.
FN Lobe widen_lobe(Lobe lobe, Float variance_x, Float variance_y) {
    if (lobe.mdf == kMdfAshikhminShirley) {
        return lobe_make(lobe.mdf, widen_exponent(lobe.p0, variance_x),
                         widen_exponent(lobe.p1, variance_y));
    }
    if (lobe.mdf == kMdfGgx) {
        return lobe_make(lobe.mdf, widen_ggx(lobe.p0, variance_x), widen_ggx(lobe.p1, variance_y));
    }
    return lobe_make(lobe.mdf, widen_gaussian(lobe.p0, variance_x),
                     widen_gaussian(lobe.p1, variance_y));
}
