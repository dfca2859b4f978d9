// Woven cloth at a distance: the mean over many cells in a pixel is a sum over the two families of
// yarns. This file fetches the means of each family (src/maps/weave/weave_mean.hpp);
// shading/surface/cloth.glsl evaluates them.

uniform highp sampler2DArray u_weave_lobes;
uniform vec3 u_weave_nodes[2];   // normals: rms along and across the yarn, mean out of the cloth
uniform vec3 u_weave_widths[2];  // widths of the table along and across, and its scale
uniform vec4 u_weave_wide_lobes[2];

// One family within a pixel.
struct ClothFamily {
    int family;   // 0 weft, 1 warp
    Shading m;    // with the color of the family
    float share;  // fraction of the pixel's area
    Frame a;      // x along the yarn
    vec3 wo;      // direction to the eye in the axes `a`
};

ClothFamily cloth_family(int family, vec4 seen, Shading m, Frame a, vec3 to_eye) {
    ClothFamily f;
    f.family = family;
    f.m = m;
    f.m.base_color *= seen.rgb / max(seen.a, 1e-6);
    put_colors(f.m);
    f.share = seen.a;
    f.a = frame_rotated(a, family == 0 ? vec2(1.0, 0.0) : vec2(0.0, 1.0));
    f.wo = frame_to_local(f.a, to_eye);
    return f;
}

#if LIGHTS > 0
// Mean of f cos over the family's surface, without Fresnel.
float cloth_specular(ClothFamily f, vec3 wi) {
#ifdef COSINE_LOBE
    return cloth_specular_of_nodes(f.m.surface, METHOD, GROOVES_ALONG_X, CONSERVE,
                                   u_weave_nodes[f.family], wi, f.wo);
#else
    vec3 width = u_weave_widths[f.family];
    vec3 h = half_vector(wi + f.wo, vec3(0.0, 0.0, 1.0));
    vec2 place = cloth_table_place(h, width.x, width.y);
    vec3 mean = textureLod(u_weave_lobes, vec3(0.5 + 0.5 * place, float(f.family)), 0.0).rgb;
    return cloth_specular_of_table(f.m.surface, mean.r * width.z, mean.g, mean.b, wi, f.wo);
#endif
}

vec3 cloth_reflected(ClothFamily f, vec3 wi) {
#ifdef LAYERS
    vec3 up = vec3(0.0, 0.0, 1.0);
    vec3 color = specular_fresnel(f.m.surface, half_angle_cosine(wi, f.wo));
    float diffuse = 0.0;
#ifndef METAL
    diffuse = cloth_diffuse(f.m.surface, u_weave_nodes[f.family], wi, f.wo);
#endif
    return layers_laid(f.m.layers, f.m.seen, up, color, cloth_specular(f, wi), f.m.surface.diffuse, diffuse, wi, f.wo);
#else
    return cloth_eval(f.m.surface, cloth_specular(f, wi), u_weave_nodes[f.family], wi, f.wo);
#endif
}

vec3 cloth_lit_by_lights(Surface s, ClothFamily f, vec3 normal) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < LIGHT_COUNT; ++i) {
        vec3 irradiance;
        vec3 towards = light_direction(i, s.position, irradiance);
#if SHADOW_MAPS > 0
        irradiance *= light_reaches(i, s.position, normal, towards);
#endif
        vec3 wi = frame_to_local(f.a, towards);
        sum += irradiance * cloth_reflected(f, wi);
    }
    return sum * f.share;
}
#endif

#if defined(AREA_LIGHTS) || IMAGE_LIGHT > 1
// The material with one lobe as wide as the mean lobe of the family.
SurfaceMaterial cloth_wide(ClothFamily f) {
    vec4 wide = u_weave_wide_lobes[f.family];
    Lobe lobe = f.m.surface.lobe;
    lobe.p0 = wide.x;
    lobe.p1 = wide.y;
    lobe.paper_norm = wide.z;
    lobe.projected_norm = wide.w;
    return surface_with_lobe(f.m.surface, lobe);
}
#endif

#ifdef AREA_LIGHTS
// The diffuse term of every normal exactly, the specular term by the wide lobe.
vec3 cloth_lit_by_area_lights(Surface s, ClothFamily f, vec3 normal) {
    SurfaceMaterial wide = cloth_wide(f);
    Frame a = frame_rotated(f.a, u_weave_twist);
    Perturbation p = perturb_make(kMethodNone, vec3(0.0, 0.0, 1.0), GROOVES_ALONG_X, CONSERVE);
    vec3 wo = frame_to_local(a, s.to_eye);
    bool has_diffuse = wide.has_diffuse;
    wide.has_diffuse = false;
    AreaLobe lobe = area_lobe(wide, p, wo);
#ifdef LAYERS
    AreaLobe coat = lobe;
#ifdef COAT
    coat = area_lobe(coat_surface(f.m.layers.coat), f.m.layers.coat.at, wo);
#endif
#endif
    vec3 sum = vec3(0.0);
    for (int i = 0; i < AREA_COUNT; ++i) {
        AreaLight light = area_light_at(i, s.position, a);
        AreaReflection r = area_reflection(wide, p, lobe, light, area_shape(i), wo);
        vec3 color = r.specular * mirror_left(f.m, p, wo);
#ifdef LAYERS
        AreaReflection none = r;
        none.specular = vec3(0.0);
        none.diffuse = vec3(0.0);
        none.towards_diffuse = normalize(light.middle);
        AreaReflection over = area_layered(none, wide, f.m.layers, f.m.seen, p, coat, light, area_shape(i), wo);
        color += over.specular + over.diffuse;
#endif
        if (has_diffuse) {
            AreaLight along = area_light_at(i, s.position, f.a);
            for (int k = 0; k < kClothNodes; ++k) {
                vec3 n = normal_facing(normalize(cloth_node(u_weave_nodes[f.family], k)), f.wo);
                float through = diffuse_albedo(BRDF, f.m.surface.dielectric_f0, f.m.surface.dielectric_f90,
                                               max(dot(n, f.wo), 0.0));
                color += wide.diffuse * diffuse_left(f.m) * (cloth_node_weight(k) * through * area_cosine(along, area_shape(i), n));
            }
        }
        sum += color * u_area_radiance[i].rgb * area_reaches(i, s.position, normal);
    }
    return sum * f.share;
}
#endif

#if IMAGE_LIGHT > 0
#ifndef METAL
vec3 cloth_lit_by_irradiance(Surface s, ClothFamily f) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < kClothNodes; ++i) {
        vec3 n = normal_facing(normalize(cloth_node(u_weave_nodes[f.family], i)), f.wo);
        sum += seen_irradiance(s, frame_to_outer(f.a, n)) *
               (cloth_node_weight(i) * diffuse_albedo(BRDF, f.m.surface.dielectric_f0, f.m.surface.dielectric_f90,
                                                        max(dot(n, f.wo), 0.0)));
    }
    return f.m.surface.diffuse * diffuse_left(f.m) * sum * f.share;
}
#endif

#if IMAGE_LIGHT > 1
#if IMAGE_LIGHT == 3 && !defined(COSINE_LOBE)
// Ratio of the albedo of the fibers' lobe, averaged over its normals, to the albedo of the family's
// lobe, which is as wide as all of them together and masks itself more. `wo` is in axes along the
// fibers.
float cloth_energy(Shading fibers, Shading wide, ClothFamily f, vec3 wo) {
    float sum = 0.0;
    for (int i = 0; i < kClothNodes; ++i) {
        vec3 n = normalize(cloth_node(u_weave_nodes[f.family], i));
        Perturbation p = surface_perturbation(METHOD, n, u_weave_twist, GROOVES_ALONG_X, CONSERVE, wo);
        sum += cloth_node_weight(i) * albedo_at(albedo_place_of(fibers.surface.lobe, p, wo));
    }
    float one = albedo_at(albedo_place(wide.surface.lobe, wo));
    return sum / max(one, 1e-3);
}
#endif

// Reflection by one lobe as wide as the mean lobe of the family.
vec3 cloth_image_specular(Surface s, ClothFamily f) {
    Shading m = f.m;
    m.surface = cloth_wide(f);
    Frame a = frame_rotated(f.a, u_weave_twist);
    Perturbation p = perturb_make(METHOD, vec3(0.0, 0.0, 1.0), GROOVES_ALONG_X, CONSERVE);
    vec3 wo = frame_to_local(a, s.to_eye);
    float energy = f.share;
#if IMAGE_LIGHT == 3 && !defined(COSINE_LOBE)
    energy *= cloth_energy(f.m, m, f, wo);
#endif
    return image_specular(s, m, a, p, wo) * mirror_left(f.m, p, wo) * energy;
}
#endif
#endif

#if IMAGE_LIGHT == 1
// Each sample has its own point within the pixel, with the cell, normal and color there.
vec3 cloth_image_specular(Surface s, Shading cloth, Frame axes, ClothPlace place, int samples) {
    Rotation rotation = rotation_of_pixel(s.pixel, u_seed);
    Rotation other = rotation_of_pixel(s.pixel, u_seed + 1u);
    vec2 first = first_point(rotation);
    float reach = exp2(place.size);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < samples; ++i) {
        uint index = u_frame * uint(u_image_samples) + uint(i);
        // Multiples of sqrt(2) and sqrt(3), which do not correlate with those that choose the
        // direction.
        vec2 shift = vec2(unit_of(index * 1779033703u + other.x), unit_of(index * 3144134277u + other.y));
        Shading m = cloth;
        float cover = put_yarn(m, place.at + (shift - 0.5) * reach);
        Frame a = axes;
        Perturbation p = facing_perturbation(s, m, a);
#ifdef LAYERS
        lay_over(m, s, a, p, frame_to_local(a, s.to_eye));
#endif
        sum += cover * image_sample(s, m, a, p, frame_to_local(a, s.to_eye), lattice_point(first, i),
                                    select_of(index, rotation));
    }
    return sum / float(u_image_samples);
}
#endif

// Black unless `seen`. Compilers do not unroll a loop of unknown length, which makes it cheaper for
// software renderers, above all where `seen` is false.
vec3 cloth_from_afar(Surface s, Shading m, Frame a, ClothPlace place, bool seen) {
    int families = seen ? 2 : 0;
    vec2 uv = place.at / vec2(textureSize(u_weave_cells, 0));
    float lod = max(place.size, 0.0);
    vec4 weft = textureLod(u_weave_weft, uv, lod);
    vec4 warp = textureLod(u_weave_warp, uv, lod);
    vec3 sum = vec3(0.0);
    for (int family = 0; family < families; ++family) {
        ClothFamily f = cloth_family(family, family == 0 ? weft : warp, m, a, s.to_eye);
#ifdef LAYERS
        Perturbation flat_p = perturb_make(kMethodNone, vec3(0.0, 0.0, 1.0), true, false);
        lay_over(f.m, s, f.a, flat_p, f.wo);
#if IMAGE_LIGHT > 0
        sum += layers_image(s, f.m, f.a, flat_p, f.wo) * f.share;
#endif
#endif
#if LIGHTS > 0
        sum += cloth_lit_by_lights(s, f, a.n);
#endif
#ifdef AREA_LIGHTS
        sum += cloth_lit_by_area_lights(s, f, a.n);
#endif
#if IMAGE_LIGHT > 0 && !defined(METAL)
        sum += cloth_lit_by_irradiance(s, f) * occlusion_left(s, a.n, occlusion_at(s));
#endif
#if IMAGE_LIGHT > 1
        sum += cloth_image_specular(s, f) * specular_open(s, m, a.n, f.wo.z);
#endif
    }
#if IMAGE_LIGHT == 1
    int samples = seen ? u_image_samples : 0;
    sum += cloth_image_specular(s, m, a, place, samples) * specular_open(s, m, a.n, dot(a.n, s.to_eye));
#endif
    return sum;
}
