// Radiance towards the eye at a point of a surface. METHOD, MDF, BRDF, CONSERVE: the model, at
// compile time; METAL: no diffuse term.

#if LIGHTS > 0
// Only the horizon of n~ counts, as for the light of the environment.
vec3 lit_by_lights(Surface s, Shading m, Frame a, Perturbation p, vec3 wo) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < LIGHT_COUNT; ++i) {
        vec3 irradiance;
        vec3 towards = light_direction(i, s.position, irradiance);
        vec3 wi = frame_to_local(a, towards);
#if SHADOW_MAPS > 0
        irradiance *= light_reaches(i, s.position, a.n, towards);
#endif
        sum += irradiance * reflected_cos(m, p, wi, wo);
    }
    return sum;
}
#endif

#if IMAGE_LIGHT > 0
// `n`: the normal in world space.
float specular_open(Surface s, Shading m, vec3 n, float cos_o) {
#ifdef HAS_OCCLUSION_MAP
    float occlusion = occlusion_left(s, n, occlusion_at(s));
    return specular_occlusion(occlusion, max(cos_o, 0.0), m.surface.lobe);
#else
    return 1.0;
#endif
}

// Irradiance covers all directions, so diffuse_eval is averaged over wi.
vec3 lit_by_environment(Surface s, Shading m, Frame a, Perturbation p, vec3 wo) {
    vec3 n = frame_to_outer(a, p.n);
    vec3 sum = image_specular(s, m, a, p, wo) * specular_open(s, m, n, dot(p.n, wo));
#if IMAGE_LIGHT > 1
    sum *= mirror_left(m, p, wo);
#endif
#ifndef METAL
    float albedo = diffuse_albedo(m.surface.brdf, m.surface.dielectric_f0, m.surface.dielectric_f90,
                                  max(dot(p.n, wo), 0.0));
    sum += m.surface.diffuse * diffuse_left(m) * seen_irradiance(s, n) *
           (albedo * occlusion_left(s, n, occlusion_at(s)));
#endif
#ifdef LAYERS
    sum += layers_image(s, m, a, p, wo);
#endif
    return sum;
}
#endif

// The perturbation by the material's normal and direction; `a` becomes the axes of the lobe.
// Without a map the normal is that of the surface, which faces the eye.
Perturbation facing_perturbation(Surface s, Shading m, inout Frame a) {
    vec2 stretch = vec2(1.0, 0.0);
#ifdef TURNED
    stretch = m.direction;
    a = frame_rotated(a, stretch);
#endif
#if defined(HAS_NORMAL_MAP) || defined(CLOTH) || defined(TABULATED)
    return surface_perturbation(METHOD, m.n, stretch, m.grooves_along_x, CONSERVE,
                                frame_to_local(a, s.to_eye));
#else
    return perturb_make(METHOD, m.n, m.grooves_along_x, CONSERVE);
#endif
}

vec3 reflected(Surface s, Shading m, Frame a) {
    Perturbation p = facing_perturbation(s, m, a);
    vec3 wo = frame_to_local(a, s.to_eye);
#ifdef COMPENSATED
    m.surface = surface_compensated(m.surface, albedo_at(albedo_place_of(m.surface.lobe, p, wo)));
#endif
#ifdef LAYERS
    lay_over(m, s, a, p, wo);
#endif
    vec3 radiance = vec3(0.0);
#if LIGHTS > 0
    radiance += lit_by_lights(s, m, a, p, wo);
#endif
#ifdef AREA_LIGHTS
    radiance += lit_by_area_lights(s, m, a, p, wo);
#endif
#if IMAGE_LIGHT > 0
    radiance += lit_by_environment(s, m, a, p, wo);
#endif
    return radiance;
}

#ifdef CLOTH
#include "shaders/lib/cloth_mean.glsl"

// The cloth at the pixel's middle, the mean over its cells, or a mixture. Loops that run once or
// not at all: software renderers can skip a loop, but execute both sides of an `if`.
vec3 reflected_by_cloth(Surface s, Shading m, Frame a) {
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

// Reflected radiance, of every kind of surface.
vec3 reflected_by_surface(Surface s, Shading m, Frame a) {
#ifdef CLOTH
    return reflected_by_cloth(s, m, a);
#elif defined(TABULATED)
    return reflected_by_texels(s, m, a);
#else
    return reflected(s, m, a);
#endif
}

// What is known of the surface. A masked one ends here where it has a hole.
Shading shading_of_visible(Surface s) {
    Shading m = shading_at(s);
#ifdef MASK
    if (m.alpha < u_alpha_cutoff) { discard; }
#endif
    return m;
}

Frame frame_of(Surface s) {
    return surface_frame(s.normal, s.tangent.xyz, s.tangent.w, s.front ? 1.0 : -1.0, s.to_eye);
}

// Radiance and alpha, premultiplied when BLEND.
vec4 shade(Surface s) {
    Shading m = shading_of_visible(s);
    Frame a = frame_of(s);
    vec3 radiance = emission_at(s) * emission_left(m, s, a) + reflected_by_surface(s, m, a);
#ifdef BLEND
    float coverage = finite_coverage(m.alpha);
    return vec4(finite_radiance(radiance) * coverage, coverage);
#else
    return vec4(finite_radiance(radiance), 1.0);
#endif
}
