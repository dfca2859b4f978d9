// One lobe of Lafortune, Foo, Torrance & Greenberg ("Non-Linear Approximation of Reflectance
// Functions", SIGGRAPH 1997): ks max(cx ix ox + cy iy oy + cz iz oz, 0)^n. Reciprocal.
// Directions in the lobe's own frame, z the normal.

FN Float lafortune_eval(Float ks, vec3 c, Float n, vec3 wi, vec3 wo) {
    Float bracket = dot(wi, c * wo);
    Float power = exp(n * log(max(bracket, kTiny)));
    return choose(bracket > Float(0) && wi.z > Float(0) && wo.z > Float(0), ks * power, Float(0));
}

// The direction that the lobe leans to; the normal where every coefficient that counts is 0.
FN vec3 lafortune_axis(vec3 c, vec3 wo) {
    vec3 axis = c * wo;
    Float l2 = dot(axis, axis);
    return choose(l2 > kTiny, axis * (Float(1) / sqrt(max(l2, kTiny))),
                  vec3(Float(0), Float(0), Float(1)));
}

// A power of the cosine to that direction is the lobe exactly. Samples may lie below the horizon.
FN vec3 lafortune_sample(vec3 c, Float n, vec3 wo, vec2 xi, OUT(Float) pdf) {
    vec3 axis = lafortune_axis(c, wo);
    vec3 wi = cosine_power_sample(axis, n, xi);
    pdf = cosine_power_pdf(axis, wi, n);
    return wi;
}

FN Float lafortune_pdf(vec3 c, Float n, vec3 wi, vec3 wo) {
    return cosine_power_pdf(lafortune_axis(c, wo), wi, n);
}
