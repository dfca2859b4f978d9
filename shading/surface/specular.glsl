// The specular term of a material at a point, for every kind of lobe: distributions of half vectors,
// powers of a cosine, tables. Per steradian, without the cosine; directions unit, in the unperturbed
// tangent space of the lobe (x along its p0). brdf/kinds.glsl says which model is of which kind.

// A material at a point, as values: whoever has textures has read them. Made by surface_material.
struct SurfaceMaterial {
    int brdf;             // kBrdf..., a constant in shaders
    Lobe lobe;            // of brdf_mdf(brdf, mdf)
    Float ks;             // of phong and lafortune, as cosine_lobe_make takes it
    vec3 c;               // of lafortune
    CosineLobe cosine;    // made of these and the lobe: surface_with_lobe
    int fresnel;          // kFresnel..., a constant in shaders
    vec3 specular;        // reflectance at normal incidence; not of conductors and curves
    vec3 eta;             // of conductors: eta + i k. Of kFresnelDielectric: x, and 1/F at normal
    vec3 k;               // incidence in k.x
    vec3 gain;            // factor of the specular term: surface_compensated
    FresnelCurve curve;   // of kFresnelCurve
    Bool has_diffuse;     // false: metals, whose diffuse term then costs nothing
    vec3 diffuse;         // albedo of the base under the interface
    vec3 dielectric;      // reflectance of that interface at normal incidence: surface_dielectric
    Float dielectric_f0;  // the largest of its channels
    Float dielectric_f90; // at grazing incidence
    Float f90;            // of the specular term, with kFresnelSchlick
};

// What the caller has looked up, or computed, for one pair of directions. Only the models of
// brdf_takes_areas and he read any of it.
struct LobeValues {
    Float D;              // tabulated: D at perturb_point(p, h), its weight included. he: the value itself
    Float area_i;         // areas (tabulated_area) seen from perturb_direction(p, wi)
    Float area_o;         // and from perturb_direction(p, wo)
    Float density;        // tabulated: of the caller's draws, per steradian, at base_points(p, h).at
    Float density_round;  // and at base_points(p, h).round
};

FN LobeValues no_lobe_values() {
    LobeValues v;
    v.D = Float(0);
    v.area_i = Float(1);
    v.area_o = Float(1);
    v.density = Float(0);
    v.density_round = Float(0);
    return v;
}

// The material with another lobe, a widened one for example: of brdf_mdf(m.brdf, mdf). Phong and lafortune
// have the exponent that belongs to its alphas.
FN SurfaceMaterial surface_with_lobe(SurfaceMaterial m, Lobe lobe) {
    m.lobe = lobe;
    m.cosine = cosine_lobe_make(
        m.brdf, m.ks, m.c, cosine_exponent_from_alpha(lobe_alpha_x(lobe), lobe_alpha_y(lobe)));
    return m;
}

// The material whose lobe is widened by detail too small to see: `variance` of its slopes along the lobe's
// axes (variance_about). normal-map leaves the lobe at the geometric normal: it does not move with n~, which
// shows in n~.h alone, and is not widened by it.
FN SurfaceMaterial surface_widened(SurfaceMaterial m, int method, vec2 variance) {
    if (method == kMethodNormalMap) { return m; }
    return surface_with_lobe(m, widen_lobe(m.lobe, variance.x, variance.y));
}

// A dielectric without a diffuse base; the caller sets what differs. `lobe`: of brdf_mdf. `ks`, `c`: of
// phong and lafortune.
FN SurfaceMaterial surface_material(int brdf, Lobe lobe, Float ks, vec3 c, Float dielectric_f0) {
    SurfaceMaterial m;
    m.brdf = brdf;
    m.ks = ks;
    m.c = c;
    m = surface_with_lobe(m, lobe);
    m.fresnel = kFresnelSchlick;
    m.specular = vec3(dielectric_f0, dielectric_f0, dielectric_f0);
    m.eta = vec3(Float(1), Float(1), Float(1));
    m.k = vec3(Float(0), Float(0), Float(0));
    m.gain = vec3(Float(1), Float(1), Float(1));
    m.curve = fresnel_curve_of_mirror();
    m.has_diffuse = false;
    m.diffuse = vec3(Float(0), Float(0), Float(0));
    m.dielectric = m.specular;
    m.dielectric_f0 = dielectric_f0;
    m.dielectric_f90 = Float(1);
    m.f90 = Float(1);
    return m;
}

// The interface of KHR_materials_specular: `weight` of a reflectance that is `f0` at normal incidence and 1 at grazing
// incidence. Before surface_colored.
FN SurfaceMaterial surface_dielectric(SurfaceMaterial m, vec3 f0, Float weight) {
    m.dielectric = vec3(min(f0.x, Float(1)), min(f0.y, Float(1)), min(f0.z, Float(1))) * weight;
    m.dielectric_f0 = max(max(m.dielectric.x, m.dielectric.y), m.dielectric.z);
    m.dielectric_f90 = weight;
    m.specular = m.dielectric;
    m.f90 = weight;
    return m;
}

// Base color and metallic as glTF 2.0 has them.
FN SurfaceMaterial surface_colored(SurfaceMaterial m, vec3 base_color, Float metallic) {
    m.specular = m.dielectric * (Float(1) - metallic) + base_color * metallic;
    m.f90 = Float(1) - (Float(1) - m.dielectric_f90) * (Float(1) - metallic);
    m.diffuse = base_color * (Float(1) - metallic);
    return m;
}

// The Fresnel factor; cos_h = wi.h.
FN vec3 specular_fresnel(SurfaceMaterial m, Float cos_h) {
    vec3 f = m.specular;
    if (m.fresnel == kFresnelConductor) {
        f = fresnel_conductor(m.eta, m.k, cos_h);
    } else if (m.fresnel == kFresnelCurve) {
        f = fresnel_curve(m.curve, cos_h);
    } else if (m.fresnel == kFresnelDielectric) {
        f = m.specular * fresnel_rise(m.eta.x, m.k.x, cos_h);
    } else {
        f = fresnel_schlick(m.specular, m.f90, cos_h);
    }
    return f;
}

// The material seen from a direction whose albedo is `albedo` (albedo_place_of). Light that facets reflect more
// than once leaves in the shape of the lobe, multiplied by the reflectance at normal incidence each time
// (Turquin 2019, "Practical multiple scattering compensation for microfacet models"): 1 + F0 (1 - E)/E. With
// F = 1 the lobe reflects all light. Not reciprocal: the factor is that of wo alone.
// 0.05: below the albedo of any lobe (GGX of alpha 1.5, seen along the normal: 0.14).
FN SurfaceMaterial surface_compensated(SurfaceMaterial m, Float albedo) {
    Float lost = Float(1) / clamp(albedo, Float(0.05), Float(1)) - Float(1);
    vec3 one = vec3(Float(1), Float(1), Float(1));
    m.gain = one + specular_fresnel(m, Float(1)) * lost;
    return m;
}

// The color of the specular term: Fresnel factor and gain.
FN vec3 specular_color(SurfaceMaterial m, Float cos_h) {
    return specular_fresnel(m, cos_h) * m.gain;
}

// Without Fresnel. 0 where wi or wo is below the horizon of n~.
FN Float specular_eval(SurfaceMaterial m, Perturbation p, LobeValues v, vec3 wi, vec3 wo) {
    Float f = Float(0);
    if (brdf_is_cosine_lobe(m.brdf)) {
        f = cosine_lobe_eval(m.cosine, p, wi, wo);
    } else if (m.brdf == kBrdfTabulated) {
        f = tabulated_brdf(v.D, v.area_i, v.area_o, dot(p.n, wi), dot(p.n, wo));
    } else if (m.brdf == kBrdfAshikhminPremozeShirley) {
        f = tabulated_brdf(lobe_D(m.lobe, p, half_vector(wi + wo, p.n)), v.area_i, v.area_o,
                           dot(p.n, wi), dot(p.n, wo));
    } else if (m.brdf == kBrdfHe) {
        f = choose(dot(p.n, wi) > Float(0) && dot(p.n, wo) > Float(0), v.D, Float(0));
    } else {
        f = brdf_eval(m.brdf, m.lobe, p, wi, wo);
    }
    return f;
}

// He's lobe is sampled as the Beckmann lobe of its slopes, and by this share as Lambert's law: what a
// smooth surface scatters is broader than its slopes.
CONSTANT(kHeCosineShare, 0.5)

// A direction drawn from the lobe; `drawn` false: throw it away. `table_half`: the half vector that the
// caller has drawn from a table by xi (tabulated_half_vector); not looked at by other models. `select`:
// chooses the part of a mixture.
FN vec3 specular_direction(SurfaceMaterial m, Perturbation p, vec3 table_half, vec3 wo, vec2 xi,
                           Float select, OUT(Bool) drawn) {
    vec3 wi = p.n;
    drawn = true;
    if (brdf_is_cosine_lobe(m.brdf)) {
        wi = cosine_power_sample(cosine_lobe_direction(m.cosine, p, wo), m.cosine.n, xi);
    } else {
        vec3 h = p.n;
        if (m.brdf == kBrdfTabulated) {
            h = perturbed_sample(p, table_half, table_half, xi, select);
        } else {
            h = brdf_half_sample(m.brdf, m.lobe, p, wo, xi, select);
        }
        drawn = dot(wo, h) > Float(0);
        wi = reflect_about(wo, h);
        if (m.brdf == kBrdfHe && select < kHeCosineShare) {
            drawn = true;
            wi = frame_to_outer(frame_about(p.n), cosine_sample(xi));
        }
    }
    return wi;
}

// The density of specular_direction per steradian; its integral falls short of 1 by what is thrown away.
FN Float specular_pdf(SurfaceMaterial m, Perturbation p, LobeValues v, vec3 wi, vec3 wo) {
    Float pdf = Float(0);
    if (brdf_is_cosine_lobe(m.brdf)) {
        pdf = cosine_lobe_pdf(m.cosine, p, wi, wo);
    } else if (m.brdf == kBrdfTabulated) {
        vec3 h = half_vector(wi + wo, p.n);
        pdf = reflected_pdf(perturbed_density(p, h, base_points(p, h), v.density, v.density_round),
                            dot(wo, h));
    } else {
        pdf = brdf_pdf(m.brdf, m.lobe, p, wi, wo);
        if (m.brdf == kBrdfHe) {
            pdf = mix(pdf, cosine_pdf(dot(p.n, wi)), kHeCosineShare);
        }
    }
    return pdf;
}

// Both at once, for models without tables; pdf 0: throw the sample away.
FN vec3 specular_sample(SurfaceMaterial m, Perturbation p, vec3 wo, vec2 xi, Float select,
                        OUT(Float) pdf) {
    vec3 wi = p.n;
    if (brdf_is_cosine_lobe(m.brdf)) {
        wi = cosine_lobe_sample(m.cosine, p, wo, xi, pdf);
    } else if (m.brdf == kBrdfHe) {
        Bool drawn = false;
        wi = specular_direction(m, p, p.n, wo, xi, select, drawn);
        pdf = choose(drawn, specular_pdf(m, p, no_lobe_values(), wi, wo), Float(0));
    } else {
        wi = brdf_sample(m.brdf, m.lobe, p, wo, xi, select, pdf);
    }
    return wi;
}
