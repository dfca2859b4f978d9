// phong and lafortune on a surface with a normal map: powers of a cosine about a direction, where the
// other models have half vectors. All directions unit, in the unperturbed tangent space. What each
// method does to them: docs/theory/papers.md. A deformation has nothing to act on; who asks for one is told
// so (src/scene/material_parameters.cpp).

struct CosineLobe {
    int brdf;  // kBrdfPhong or kBrdfLafortune
    Float ks;  // f = ks (wi.axis)^n, over n~.wi for phong
    Float n;
    vec3 c;    // lafortune's coefficients, the largest 1; not looked at for phong
};

// The exponent of the lobe about a direction that is as wide as what a distribution of half vectors
// with these alphas reflects: e/4 with e = 2/(alpha_x alpha_y) - 2, since a direction turns twice as
// far as its half vector. One roughness pair drives every model.
FN Float cosine_exponent_from_alpha(Float alpha_x, Float alpha_y) {
    return max(Float(0.5) / (alpha_x * alpha_y) - Float(0.5), Float(0));
}

FN Float alpha_from_cosine_exponent(Float n) {
    return Float(1) / sqrt(Float(2) * n + Float(1));
}

// ks at which a lobe about n~ keeps all light that is seen head-on, and more never leaves: the cosine
// of the light is in phong's own denominator, and lafortune's is one more power.
FN Float cosine_lobe_unit_ks(int brdf, Float n) {
    if (brdf == kBrdfPhong) { return (n + Float(1)) / (Float(2) * kPi); }
    return (n + Float(2)) / (Float(2) * kPi);
}

// `ks` below 0: cosine_lobe_unit_ks. Else as the papers have it, times max(|c|)^n, which is taken out
// of c so that the power stays within what single precision holds.
FN CosineLobe cosine_lobe_make(int brdf, Float ks, vec3 c, Float n) {
    Float most = max(max(max(abs(c.x), abs(c.y)), abs(c.z)), kTiny);
    CosineLobe lobe;
    lobe.brdf = brdf;
    lobe.n = n;
    lobe.c = c * (Float(1) / most);
    Float power = Float(1);
    // 60: e^60 = 1e26 is beyond any radiance, and times the largest ks still a number.
    if (brdf == kBrdfLafortune) { power = exp(min(n * log(most), Float(60))); }
    lobe.ks = choose(ks < Float(0), cosine_lobe_unit_ks(brdf, n), ks * power);
    return lobe;
}

// What the lobe stands about, not unit. Phong knows no frame: it is the mirror direction about n~,
// whatever the method. Lafortune's coefficients belong to the rows of the method's frame: R^T w for the
// rotations, (w_x, w_y, n~.w) for normal-map, K12's matrix for rotate-approx.
FN vec3 cosine_lobe_axis(CosineLobe lobe, Perturbation p, vec3 wo) {
    if (lobe.brdf == kBrdfPhong) { return reflect_about(wo, p.n); }
    return frame_to_outer(p.frame, lobe.c * frame_to_local(p.frame, wo));
}

// Unit; n~ where every coefficient that counts is 0.
FN vec3 cosine_lobe_direction(CosineLobe lobe, Perturbation p, vec3 wo) {
    vec3 axis = cosine_lobe_axis(lobe, p, wo);
    Float l2 = dot(axis, axis);
    return choose(l2 > kTiny, axis * (Float(1) / sqrt(max(l2, kTiny))), p.n);
}

// ks |axis|^n: the value along the axis, but for phong's cosine.
FN Float cosine_lobe_peak(CosineLobe lobe, Perturbation p, vec3 wo) {
    if (lobe.brdf == kBrdfPhong) { return lobe.ks; }
    vec3 axis = cosine_lobe_axis(lobe, p, wo);
    Float l2 = dot(axis, axis);
    Float power = exp(min(Float(0.5) * lobe.n * log(max(l2, kTiny)), Float(60)));
    return choose(l2 > kTiny, min(lobe.ks * power, kMostValue), Float(0));
}

// Per steradian, without the cosine and without Fresnel. 0 where wi or wo is below n~'s horizon.
FN Float cosine_lobe_eval(CosineLobe lobe, Perturbation p, vec3 wi, vec3 wo) {
    Float cos_i = dot(p.n, wi);
    Float f = cosine_lobe_peak(lobe, p, wo) *
              cosine_power(cosine_lobe_direction(lobe, p, wo), wi, lobe.n);
    if (lobe.brdf == kBrdfPhong) { f = f / max(cos_i, kLeastCosine); }
    return choose(cos_i > Float(0) && dot(p.n, wo) > Float(0), min(f, kMostValue), Float(0));
}

// Exactly the lobe: f cos/pdf is the peak times 2 pi/(n + 1), for lafortune times n~.wi. Samples may
// lie below the horizon, where the BRDF is 0.
FN vec3 cosine_lobe_sample(CosineLobe lobe, Perturbation p, vec3 wo, vec2 xi, OUT(Float) pdf) {
    vec3 direction = cosine_lobe_direction(lobe, p, wo);
    vec3 wi = cosine_power_sample(direction, lobe.n, xi);
    pdf = cosine_power_pdf(direction, wi, lobe.n);
    return wi;
}

FN Float cosine_lobe_pdf(CosineLobe lobe, Perturbation p, vec3 wi, vec3 wo) {
    return cosine_power_pdf(cosine_lobe_direction(lobe, p, wo), wi, lobe.n);
}

// Phi and phi of the standard normal distribution.
FN Float normal_share(Float x) {
    Float tail = Float(0.5) * erfc(abs(x) * Float(0.70710678118654752));
    return choose(x < Float(0), tail, Float(1) - tail);
}

// The lobe as seen along n~: over it, n~.wi is taken to be normally distributed, with its mean
// c (n + 1)/(n + 2) and the variance of its part beside the axis, s^2/(n + 3). What the horizon cuts off
// follows in closed form.
struct LobeOverHorizon {
    Float mean;
    Float deviation;
    Float share;    // of the lobe above the horizon
    Float density;  // of mean/deviation
};

FN LobeOverHorizon cosine_lobe_over_horizon(Float n, Float c) {
    LobeOverHorizon r;
    r.mean = c * (n + Float(1)) / (n + Float(2));
    // 1e-12: along n~ nothing is beside the axis.
    r.deviation = sqrt(max(Float(1) - c * c, Float(1e-12)) / (n + Float(3)));
    Float x = r.mean / r.deviation;
    r.share = normal_share(x);
    r.density = exp(-Float(0.5) * x * x) / sqrt(Float(2) * kPi);
    return r;
}

// Int f cos dwi, not exact: exact where the horizon cuts nothing off; for unit ks within 0.02 from n = 5
// on, 0.06 for n >= 1 and 0.11 below, where lobes are no bells.
FN Float cosine_lobe_albedo(CosineLobe lobe, Perturbation p, vec3 wo) {
    Float c = dot(p.n, cosine_lobe_direction(lobe, p, wo));
    LobeOverHorizon r = cosine_lobe_over_horizon(lobe.n, c);
    Float kept = r.share;
    if (lobe.brdf == kBrdfLafortune) { kept = r.mean * r.share + r.deviation * r.density; }
    return cosine_lobe_peak(lobe, p, wo) * (Float(2) * kPi) / (lobe.n + Float(1)) * kept;
}

// The mean direction of f cos, unit: where the light of the lobe comes from once the horizon, and for
// lafortune the cosine, have taken their part. They pull it towards n~. Not exact, as above.
FN vec3 cosine_lobe_mean(CosineLobe lobe, Perturbation p, vec3 wo) {
    vec3 d = cosine_lobe_direction(lobe, p, wo);
    Float c = dot(p.n, d);
    LobeOverHorizon r = cosine_lobe_over_horizon(lobe.n, c);
    // By how many deviations the mean of what is kept lies above that of the lobe. 1e-6: five deviations
    // below the horizon, where nothing is left to place.
    Float pull = r.density / max(r.share, Float(1e-6));
    if (lobe.brdf == kBrdfLafortune) {
        pull = r.share / max(r.share * r.mean / r.deviation + r.density, Float(1e-6));
    }
    // pull deviation is along n~; along the part of n~ beside d, whose square is (deviation^2)(n + 3), it is
    Float beside = min(pull, Float(5)) / (r.deviation * (lobe.n + Float(3)));
    vec3 m = d * ((lobe.n + Float(1)) / (lobe.n + Float(2))) + (p.n - d * c) * beside;
    return m * (Float(1) / sqrt(max(dot(m, m), kTiny)));
}
