// The specular term under the environment. IMAGE_LIGHT: 0 off, 1 importance sampling of the
// perturbed lobe, 2 the bent reflection vector of today's engines, 3 look-ups of the lobe map along
// the lobe's axis. A lobe about a direction (COSINE_LOBE) is round: 2 and 3 take a single look-up.
#if IMAGE_LIGHT == 1

// One sample of the integral of f F cos L over wi by specular_draw. Filtered importance sampling
// (Colbert & Krivanek, GPU Gems 3, ch. 20): a sample represents the solid angle 1/(total pdf) and reads the
// mip of that size. As the total grows, this converges to mip 0 and the exact integral. wi may lie below
// the geometric horizon where the map tilts n~ enough. A mapped bump must match the modeled one
// (NormalTangentTest), so only the horizon of n~ counts.
vec3 image_sample(Surface s, Shading m, Frame a, Perturbation p, vec3 wo, vec2 xi, float select) {
    float pdf;
    vec3 wi = specular_draw(m, p, wo, xi, select, pdf);
    float cos_i = dot(p.n, wi);
    bool counts = pdf > 0.0 && cos_i > 0.0;
    float weight = specular_at(m, p, wi, wo) * cos_i / max(pdf, kTiny);
    float lod = environment_lod(1.0 / (u_total_samples * max(pdf, kTiny)));
    vec3 towards = frame_to_outer(a, wi);
    vec3 radiance = seen_radiance(s, towards, environment_radiance(towards, lod));
    vec3 color = specular_color(m.surface, half_angle_cosine(wi, wo));
    vec3 term = color * specular_left(m, p, color, wi) * radiance * weight;
    return counts ? finite_radiance(term) : vec3(0.0);
}

vec3 image_specular(Surface s, Shading m, Frame a, Perturbation p, vec3 wo) {
    Rotation rotation = rotation_of_pixel(s.pixel, u_seed);
    vec3 sum = vec3(0.0);
#ifdef TABULATED
    // The texels within a pixel share its samples. Their number differs from pixel to pixel, so the
    // points are those of the sequence alone.
    int samples = max(u_image_samples / m.taps, 1);
    for (int i = 0; i < samples; ++i) {
        uint index = (u_frame * uint(samples) + uint(i)) * uint(m.taps) + uint(m.tap);
        sum += image_sample(s, m, a, p, wo, point_of(index, rotation), select_of(index, rotation));
    }
    return sum / float(samples);
#else
    vec2 first = first_point(rotation);
    for (int i = 0; i < u_image_samples; ++i) {
        float select = select_of(u_frame, uint(i), rotation);
        sum += image_sample(s, m, a, p, wo, lattice_point(first, i), select);
    }
    return sum / float(u_image_samples);
#endif
}

#elif IMAGE_LIGHT > 1 && defined(COSINE_LOBE)

// kCosineLobeWidth: width of the look-up relative to the lobe. The map is
// blurred by GGX, which has a tail a^2/t^4 that a power of a cosine lacks. 4/3 of one level minus
// 1/3 of the next, twice as wide, is a kernel without that tail and nowhere negative.
vec3 round_lobe_radiance(vec3 w, float alpha) {
    vec3 narrow = lobe_radiance(w, lobe_lod(alpha * alpha));
    vec3 wide = lobe_radiance(w, lobe_lod(4.0 * alpha * alpha));
    return max(narrow * (4.0 / 3.0) - wide * (1.0 / 3.0), vec3(0.0));
}

vec3 image_specular(Surface s, Shading m, Frame a, Perturbation p, vec3 wo) {
    CosineLobe lobe = m.surface.cosine;
    vec3 wi = cosine_lobe_mean(lobe, p, wo);
    // f cos has one more cosine factor for lafortune.
    float n = BRDF == kBrdfLafortune ? lobe.n + 1.0 : lobe.n;
    float alpha = kCosineLobeWidth * alpha_from_cosine_exponent(n);
    vec3 towards = frame_to_outer(a, wi);
    vec3 radiance = seen_radiance(
        s, towards, round_lobe_radiance(environment_direction(towards), alpha) * u_environment_scale);
    float albedo = dot(p.n, wo) > 0.0 ? cosine_lobe_albedo(lobe, p, wo) : 0.0;
    return specular_fresnel(m.surface, half_angle_cosine(wi, wo)) * radiance * albedo;
}

#elif IMAGE_LIGHT == 2

// Lazarov's split-sum table as fitted by Karis ("Physically Based Shading on Mobile", 2014).
vec3 split_sum(vec3 f0, float f90, float roughness, float cos_o) {
    vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    float a = min(r.x * r.x, exp2(-9.28 * cos_o)) * r.x + r.y;
    vec2 ab = vec2(-1.04, 1.04) * a + r.zw;
    return max(f0 * ab.x + f90 * ab.y, vec3(0.0));
}

// As in Filament, three.js and the Khronos sample renderer: the perturbed normal is bent towards
// the normal perpendicular to the grooves of the unperturbed frame, and one mip is read along its
// reflection. For comparison only.
vec3 image_specular(Surface s, Shading m, Frame a, Perturbation p, vec3 wo) {
    float alpha_x = lobe_alpha_x(m.surface.lobe);
    float alpha_y = lobe_alpha_y(m.surface.lobe);
    float narrow = min(alpha_x, alpha_y);
    float roughness = sqrt(narrow);
    float strength = sqrt(clamp((max(alpha_x, alpha_y) - narrow) / max(1.0 - narrow, 1e-3), 0.0, 1.0));
    vec3 groove = m.grooves_along_x ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
    vec3 across = wo - groove * dot(groove, wo);
    across = across * inversesqrt(max(dot(across, across), kTiny));
    float keep = 1.0 - strength * (1.0 - roughness);
    keep = keep * keep;
    vec3 bent = normalize(mix(across, p.n, keep * keep));
    vec3 wi = reflect(-wo, bent);
    // Perceptual roughness is sqrt(alpha), so the lobe has the width alpha = roughness^2.
    vec3 towards = frame_to_outer(a, wi);
    vec3 radiance = lobe_radiance(environment_direction(towards), lobe_lod(narrow * narrow));
    radiance = seen_radiance(s, towards, radiance * u_environment_scale);
    return radiance * m.surface.gain *
           split_sum(specular_fresnel(m.surface, 1.0), m.surface.f90, roughness, max(dot(p.n, wo), 0.0));
}

#elif IMAGE_LIGHT == 3
#include "shaders/lib/prefiltered_light.glsl"
#endif
