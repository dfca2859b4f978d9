// Radiance towards the eye at a point of a surface. METHOD, MDF, BRDF, CONSERVE: the model, at
// compile time; METAL: nothing is diffuse.

// What the interface lets through to the diffuse base and back, as Schlick has it:
// (1 - F(n~.wi)) (1 - F(n~.wo)). At most 1 - F, so that with the specular term no energy is gained.
float diffuse_through(float cosine) {
    return 1.0 - fresnel_schlick(u_dielectric_f0, cosine);
}

// The diffuse term of a white base. The 2000 model of Ashikhmin and Shirley has its own, coupled to
// the specular one by its reflectance; no frame enters either, cosines are those of n~.
float diffuse_eval(float cos_i, float cos_o) {
#ifdef TABULATED
    return 1.0 / kPi;  // what the albedo was fitted with
#else
    if (BRDF == kBrdfAshikhminShirley) {
        return ashikhmin_shirley_diffuse(1.0, u_dielectric_f0, cos_i, cos_o);
    }
    return diffuse_through(cos_o) * diffuse_through(cos_i) / kPi;
#endif
}

// What diffuse_eval reflects of constant light all around: both exactly. The cosine-weighted mean of
// Schlick's term is f0 + (1 - f0)/21.
float diffuse_albedo(float cos_o) {
#ifdef TABULATED
    return 1.0;
#else
    float share = 1.0 - u_dielectric_f0;
    if (BRDF == kBrdfAshikhminShirley) { return share * ashikhmin_shirley_through(cos_o); }
    return share * (20.0 / 21.0) * diffuse_through(cos_o);
#endif
}

vec3 diffuse_color(Shading m) {
#ifdef METAL
    return vec3(0.0);
#else
    return m.base_color * (1.0 - m.metallic);
#endif
}

#if LIGHTS > 0
// Only the horizon of n~ counts, as under the environment.
vec3 lit_by_lights(Surface s, Shading m, Axes a, Perturbation p, vec3 wo) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < LIGHTS; ++i) {
        vec3 irradiance;
        vec3 towards = light_direction(i, s.position, irradiance);
        vec3 wi = to_axes(a, towards);
#if SHADOW_MAPS > 0
        irradiance *= light_reaches(i, s.position, a.z, towards);
#endif
        float cos_i = max(dot(p.n, wi), 0.0);
        float cos_h = sqrt(max(0.5 + 0.5 * dot(wi, wo), 0.0));  // wi.h = cos of half the angle
        vec3 f = specular_fresnel(m, cos_h) * specular_eval(m, p, wi, wo);
#ifndef METAL
        f += diffuse_color(m) * diffuse_eval(cos_i, max(dot(p.n, wo), 0.0));
#endif
        sum += irradiance * f * cos_i;
    }
    return sum;
}
#endif

#if IMAGE_LIGHT > 0
// What an occlusion map leaves of a reflection (Lagarde & de Rousiers, "Moving Frostbite to PBR",
// 2014): a smooth surface loses less than a rough one, most where it is seen head-on in a deep place.
float specular_occlusion(float occlusion, float cos_o, Lobe lobe) {
    float alpha = sqrt(lobe_alpha_x(lobe) * lobe_alpha_y(lobe));
    float open = pow(max(cos_o + occlusion, 0.0), exp2(-16.0 * min(alpha, 1.0) - 1.0));
    return clamp(open - 1.0 + occlusion, 0.0, 1.0);
}

float specular_open(Surface s, Shading m, float cos_o) {
#ifdef HAS_OCCLUSION_MAP
    return specular_occlusion(occlusion_at(s), max(cos_o, 0.0), m.lobe);
#else
    return 1.0;
#endif
}

// Irradiance stands for light from everywhere: diffuse_eval's dependence on wi is averaged over it.
vec3 lit_by_environment(Surface s, Shading m, Axes a, Perturbation p, vec3 wo) {
    vec3 sum = image_specular(s, m, a, p, wo) * specular_open(s, m, dot(p.n, wo));
#ifndef METAL
    sum += diffuse_color(m) * environment_irradiance(from_axes(a, p.n)) *
           (diffuse_albedo(max(dot(p.n, wo), 0.0)) * occlusion_at(s));
#endif
    return sum;
}
#endif

// What the material's normal and direction do to the lobe; `a` becomes the axes of the lobe.
Perturbation facing_perturbation(Surface s, Shading m, inout Axes a) {
    vec3 n = m.n;
#ifdef TURNED
    // The stretch is not along the tangent: everything is seen against axes turned to it.
    a = turned(a, m.direction);
    n = vec3(n.x * m.direction.x + n.y * m.direction.y, n.y * m.direction.x - n.x * m.direction.y, n.z);
#endif
#if defined(HAS_NORMAL_MAP) || defined(CLOTH) || defined(TABULATED)
    n = normal_facing(n, to_axes(a, s.to_eye));
#endif
    return perturb_make(METHOD, n, m.grooves_along_x, CONSERVE);
}

vec3 reflected(Surface s, Shading m, Axes a) {
    Perturbation p = facing_perturbation(s, m, a);
    vec3 wo = to_axes(a, s.to_eye);
    vec3 radiance = vec3(0.0);
#if LIGHTS > 0
    radiance += lit_by_lights(s, m, a, p, wo);
#endif
#if IMAGE_LIGHT > 0
    radiance += lit_by_environment(s, m, a, p, wo);
#endif
    return radiance;
}

#ifdef CLOTH
#include "shaders/lib/cloth_mean.glsl"

// The point at the pixel's middle, the mean over its cells, or between the two a mixture. A loop that runs
// once or not at all: software renderers leave a loop, but go through both sides of an `if`.
vec3 reflected_by_cloth(Surface s, Shading m, Axes a) {
    ClothPlace place = cloth_place(s);
    float mean = weave_mean_share(place.size) * u_weave_filter;
    vec3 radiance = vec3(0.0);
    for (int i = mean < 1.0 ? 0 : 1; i < 1; ++i) {
        Shading yarn = m;
        float cover = put_yarn(yarn, place.at);
        radiance += reflected(s, yarn, a) * (cover * (1.0 - mean));
    }
    radiance += cloth_from_afar(s, m, a, place, mean > 0.0) * mean;
    return radiance;
}
#endif

#ifdef TABULATED
#include "shaders/lib/tabulated_texels.glsl"
#endif

// Premultiplied by alpha when BLEND.
vec4 shade(Surface s) {
    Shading m = shading_at(s);
#ifdef MASK
    if (m.alpha < u_alpha_cutoff) { discard; }
#endif
    Axes a = surface_axes(s, s.to_eye);
#ifdef CLOTH
    vec3 radiance = emission_at(s) + reflected_by_cloth(s, m, a);
#elif defined(TABULATED)
    vec3 radiance = emission_at(s) + reflected_by_texels(s, m, a);
#else
    vec3 radiance = emission_at(s) + reflected(s, m, a);
#endif
#ifdef BLEND
    float coverage = finite_coverage(m.alpha);
    return vec4(finite_radiance(radiance) * coverage, coverage);
#else
    return vec4(finite_radiance(radiance), 1.0);
#endif
}
