// The specular term of a Shading, and its sampling: this file looks up tables; the rest is
// shading/surface/specular.glsl.

LobeValues lobe_values(Shading m, Perturbation p, vec3 wi, vec3 wo) {
#ifdef TABULATED
    return tabulated_values(m.table, p, wi, wo);
#else
    return no_lobe_values();
#endif
}

float specular_at(Shading m, Perturbation p, vec3 wi, vec3 wo) {
    return specular_eval(m.surface, p, lobe_values(m, p, wi, wo), wi, wo);
}

#if IMAGE_LIGHT == 1
vec3 specular_draw(Shading m, Perturbation p, vec3 wo, vec2 xi, float select, out float pdf) {
#ifdef TABULATED
    vec3 h = tabulated_sample(m.table, p, xi, select);
    float wo_h = dot(wo, h);
    pdf = wo_h > 0.0 ? reflected_pdf(tabulated_pdf(m.table, p, h), wo_h) : 0.0;
    return reflect_about(wo, h);
#else
    return specular_sample(m.surface, p, wo, xi, select, pdf);
#endif
}
#endif
