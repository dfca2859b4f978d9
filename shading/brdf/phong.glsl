// Phong's lobe about the mirror direction as a BRDF, in the form of the synthesis paper's slide:
// ks (wo.r)^n / (n.wi), r = 2 (n.wi) n - wi. Not reciprocal, and unbounded at grazing wi.
// Directions in the lobe's own frame (perturb_direction of a rotation), z the normal.

FN vec3 mirrored(vec3 w) {
    return vec3(-w.x, -w.y, w.z);
}

FN Float phong_eval(Float ks, Float n, vec3 wi, vec3 wo) {
    Float f = ks * cosine_power(wo, mirrored(wi), n) / max(wi.z, kLeastCosine);
    return choose(wi.z > Float(0) && wo.z > Float(0), f, Float(0));
}

// wo.r(wi) = wi.r(wo), so the lobe about the mirror direction of wo is it exactly. Samples may lie
// below the horizon, where the BRDF is 0.
FN vec3 phong_sample(Float n, vec3 wo, vec2 xi, OUT(Float) pdf) {
    vec3 axis = mirrored(wo);
    vec3 wi = cosine_power_sample(axis, n, xi);
    pdf = cosine_power_pdf(axis, wi, n);
    return wi;
}

FN Float phong_pdf(Float n, vec3 wi, vec3 wo) {
    return cosine_power_pdf(mirrored(wo), wi, n);
}
