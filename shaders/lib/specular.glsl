// The specular term without Fresnel and without the cosine, and its sampling. BRDF: the model, over a
// distribution of half vectors or, with COSINE_LOBE, a power of the cosine about a direction.
#ifdef TABULATED
#include "shaders/lib/tabulated.glsl"
#elif defined(COSINE_LOBE)

CosineLobe cosine_lobe_of(Shading m) {
    float n = cosine_exponent_from_alpha(lobe_alpha_x(m.lobe), lobe_alpha_y(m.lobe));
    return cosine_lobe_make(BRDF, u_ks, u_lafortune_c, n);
}

float specular_eval(Shading m, Perturbation p, vec3 wi, vec3 wo) {
    return cosine_lobe_eval(cosine_lobe_of(m), p, wi, wo);
}

vec3 specular_sample(Shading m, Perturbation p, vec3 wo, vec2 xi, float select, out float pdf) {
    return cosine_lobe_sample(cosine_lobe_of(m), p, wo, xi, pdf);
}

#else

float specular_eval(Shading m, Perturbation p, vec3 wi, vec3 wo) {
    return brdf_eval(BRDF, m.lobe, p, wi, wo);
}

vec3 specular_sample(Shading m, Perturbation p, vec3 wo, vec2 xi, float select, out float pdf) {
    return brdf_sample(BRDF, m.lobe, p, wo, xi, select, pdf);
}

#endif
