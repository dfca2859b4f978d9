// Light reflected by a point of a surface: the diffuse and the specular term together, their sampling
// and its density. Directions unit, in the unperturbed tangent space of the lobe.

// Per steradian, without the cosine. 0 where wi or wo is below the horizon of n~.
FN vec3 surface_eval(SurfaceMaterial m, Perturbation p, LobeValues v, vec3 wi, vec3 wo) {
    vec3 f = specular_color(m, half_angle_cosine(wi, wo)) * specular_eval(m, p, v, wi, wo);
    if (m.has_diffuse) {
        Float cos_i = dot(p.n, wi);
        Float cos_o = dot(p.n, wo);
        Float diffuse = diffuse_eval(m.brdf, m.dielectric_f0, m.dielectric_f90, max(cos_i, Float(0)),
                                     max(cos_o, Float(0)));
        f = f + m.diffuse * choose(cos_i > Float(0) && cos_o > Float(0), diffuse, Float(0));
    }
    return f;
}

FN vec3 surface_eval(SurfaceMaterial m, Perturbation p, vec3 wi, vec3 wo) {
    return surface_eval(m, p, no_lobe_values(), wi, wo);
}

// The probability with which surface_direction draws from the specular lobe: its share of the light
// that the two terms reflect together, estimated for constant light by the Fresnel factor at n~ and the
// albedo of the diffuse term. 1 without a diffuse term; else 0.1 to 0.9, so that f cos/pdf is at most ten
// times what one term alone would give where the estimate is poor.
FN Float surface_specular_share(SurfaceMaterial m, Perturbation p, vec3 wo) {
    Float share = Float(1);
    if (m.has_diffuse) {
        Float cos_o = max(dot(p.n, wo), Float(0));
        Float specular = luminance(specular_color(m, cos_o));
        Float diffuse = luminance(m.diffuse) * diffuse_albedo(m.brdf, m.dielectric_f0, m.dielectric_f90, cos_o);
        share = clamp(specular / max(specular + diffuse, kTiny), Float(0.1), Float(0.9));
    }
    return share;
}

// A direction towards which to look for light; `drawn` false: throw it away. Uniform numbers in [0, 1):
// `select` chooses the term and its parts. `table_half`: as specular_direction.
FN vec3 surface_direction(SurfaceMaterial m, Perturbation p, vec3 table_half, vec3 wo, vec2 xi,
                          Float select, OUT(Bool) drawn) {
    Float share = surface_specular_share(m, p, wo);
    vec3 wi = p.n;
    drawn = true;
    if (select < share) {
        wi = specular_direction(m, p, table_half, wo, xi, select / share, drawn);
    } else {
        wi = frame_to_outer(frame_about(p.n), cosine_sample(xi));
    }
    return wi;
}

// The density of surface_direction per steradian. It may be positive where surface_eval is 0.
FN Float surface_pdf(SurfaceMaterial m, Perturbation p, LobeValues v, vec3 wi, vec3 wo) {
    Float share = surface_specular_share(m, p, wo);
    Float diffuse = (Float(1) - share) * cosine_pdf(dot(p.n, wi));
    return min(share * specular_pdf(m, p, v, wi, wo) + diffuse, kMostValue);
}

FN Float surface_pdf(SurfaceMaterial m, Perturbation p, vec3 wi, vec3 wo) {
    return surface_pdf(m, p, no_lobe_values(), wi, wo);
}

// Both at once, for models without tables; pdf 0: throw the sample away. Tables: surface_direction, the
// look-ups at what it returns, surface_pdf.
FN vec3 surface_sample(SurfaceMaterial m, Perturbation p, vec3 wo, vec2 xi, Float select,
                       OUT(Float) pdf) {
    Bool drawn = false;
    vec3 wi = surface_direction(m, p, p.n, wo, xi, select, drawn);
    pdf = choose(drawn, surface_pdf(m, p, wi, wo), Float(0));
    return wi;
}
