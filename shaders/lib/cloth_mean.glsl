// Woven cloth from afar: what a pixel sees of many cells is a sum over the two families of yarns. Each
// family's specular term is the mean of its lobe over the normals of its surface, from a table; its
// diffuse term a sum over six normals with the same moments (src/maps/weave_mean.hpp).

uniform highp sampler2DArray u_weave_lobes;
uniform vec3 u_weave_nodes[2];   // normals: rms along and across the yarn, mean out of the cloth
uniform vec3 u_weave_widths[2];  // of the table along and across, and its scale
uniform vec4 u_weave_wide_lobes[2];

// One family as a pixel sees it.
struct ClothFamily {
    int family;     // 0 weft, 1 warp
    Shading m;      // with its colour
    float share;    // of the pixel's area
    Axes a;         // x along the yarn
    vec3 wo;        // against them
};

ClothFamily cloth_family(int family, vec4 seen, Shading m, Axes a, vec3 to_eye) {
    ClothFamily f;
    f.family = family;
    f.m = m;
    f.m.base_color *= seen.rgb / max(seen.a, 1e-6);
    f.share = seen.a;
    f.a = turned(a, family == 0 ? vec2(1.0, 0.0) : vec2(0.0, 1.0));
    f.wo = to_axes(f.a, to_eye);
    return f;
}

// Normals that stand for a family's: two along the yarn, where slopes pile up at their ends, times three
// across, where the sine of the tilt is spread evenly: the points and weights of Gauss and Legendre.
const int kClothNodes = 6;

vec3 cloth_node(vec3 node, int i) {
    // sqrt(3) sqrt(3/5) root mean squares.
    return vec3(i < 3 ? node.x : -node.x, float(i % 3 - 1) * (1.3416408 * node.y), node.z);
}

float cloth_node_weight(int i) { return i % 3 == 1 ? 4.0 / 18.0 : 2.5 / 18.0; }

#if LIGHTS > 0
#ifdef COSINE_LOBE
// No half vectors to tabulate over: the lobe at the normals.
float cloth_specular(ClothFamily f, vec3 wi) {
    float sum = 0.0;
    for (int i = 0; i < kClothNodes; ++i) {
        vec3 n = normal_facing(normalize(cloth_node(u_weave_nodes[f.family], i)), f.wo);
        Perturbation p = perturb_make(METHOD, n, GROOVES_ALONG_X, CONSERVE);
        sum += cloth_node_weight(i) * specular_eval(f.m, p, wi, f.wo) * max(dot(p.n, wi), 0.0);
    }
    return sum;
}
#else
// Mean of f cos over the family's surface. Masking and cosines are those of the mean normal of what
// reflects at this half vector.
float cloth_specular(ClothFamily f, vec3 wi) {
    vec3 up = vec3(0.0, 0.0, 1.0);
    vec3 h = half_vector(wi + f.wo, up);
    vec3 width = u_weave_widths[f.family];
    // 1e-3: the table ends at 190 widths.
    vec2 slope = h.xy / max(h.z, 1e-3);
    vec2 place = vec2(weave_table_coordinate(slope.x, width.x), weave_table_coordinate(slope.y, width.y));
    vec3 mean = textureLod(u_weave_lobes, vec3(0.5 + 0.5 * place, float(f.family)), 0.0).rgb;
    Perturbation p = perturb_make(kMethodNone, up, GROOVES_ALONG_X, false);
    p.n = normal_facing(vec3(mean.gb, sqrt(max(1.0 - dot(mean.gb, mean.gb), 0.0))), f.wo);
    float value = brdf_of_factor(BRDF, f.m.lobe, mean.r * width.z, p, wi, f.wo);
    return h.z > 0.0 ? value * max(dot(p.n, wi), 0.0) : 0.0;
}
#endif

// Mean of f cos of a white base.
float cloth_diffuse(ClothFamily f, vec3 wi) {
    float sum = 0.0;
    for (int i = 0; i < kClothNodes; ++i) {
        vec3 n = cloth_node(u_weave_nodes[f.family], i);
        float cos_i = max(dot(n, wi), 0.0);
        sum += cloth_node_weight(i) * diffuse_eval(cos_i, max(dot(n, f.wo), 0.0)) * cos_i;
    }
    return sum;
}

vec3 cloth_lit_by_lights(Surface s, ClothFamily f, vec3 normal) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < LIGHTS; ++i) {
        vec3 irradiance;
        vec3 towards = light_direction(i, s.position, irradiance);
#if SHADOW_MAPS > 0
        irradiance *= light_reaches(i, s.position, normal, towards);
#endif
        vec3 wi = to_axes(f.a, towards);
        float cos_h = sqrt(max(0.5 + 0.5 * dot(wi, f.wo), 0.0));
        vec3 reflected = specular_fresnel(f.m, cos_h) * cloth_specular(f, wi);
#ifndef METAL
        reflected += diffuse_color(f.m) * cloth_diffuse(f, wi);
#endif
        sum += irradiance * reflected;
    }
    return sum * f.share;
}
#endif

#if IMAGE_LIGHT > 0
#ifndef METAL
vec3 cloth_lit_by_irradiance(ClothFamily f) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < kClothNodes; ++i) {
        vec3 n = normal_facing(normalize(cloth_node(u_weave_nodes[f.family], i)), f.wo);
        sum += environment_irradiance(from_axes(f.a, n)) *
               (cloth_node_weight(i) * diffuse_albedo(max(dot(n, f.wo), 0.0)));
    }
    return diffuse_color(f.m) * sum * f.share;
}
#endif

#if IMAGE_LIGHT > 1
#if IMAGE_LIGHT == 3 && !defined(COSINE_LOBE)
// Albedo of the fibres' lobe at its normals over that of the family's one, which is as wide as they
// are together and masks itself more. `a`: along the fibres.
float cloth_energy(Shading fibres, Shading wide, ClothFamily f, vec3 wo) {
    float sum = 0.0;
    for (int i = 0; i < kClothNodes; ++i) {
        vec3 n = normalize(cloth_node(u_weave_nodes[f.family], i));
        n = vec3(n.x * u_weave_twist.x + n.y * u_weave_twist.y, n.y * u_weave_twist.x - n.x * u_weave_twist.y, n.z);
        Perturbation p = perturb_make(METHOD, normal_facing(n, wo), GROOVES_ALONG_X, CONSERVE);
        sum += cloth_node_weight(i) * albedo_towards(lobe_alpha_x(fibres.lobe),
                                                     lobe_alpha_y(fibres.lobe),
                                                     perturb_direction(p, wo));
    }
    float one = albedo_towards(lobe_alpha_x(wide.lobe), lobe_alpha_y(wide.lobe), wo);
    return sum / max(one, 1e-3);
}
#endif

// One lobe as wide as the family's together.
vec3 cloth_image_specular(Surface s, ClothFamily f) {
    Shading m = f.m;
    vec4 wide = u_weave_wide_lobes[f.family];
    m.lobe.p0 = wide.x;
    m.lobe.p1 = wide.y;
    m.lobe.paper_norm = wide.z;
    m.lobe.projected_norm = wide.w;
    Axes a = turned(f.a, u_weave_twist);
    Perturbation p = perturb_make(METHOD, vec3(0.0, 0.0, 1.0), GROOVES_ALONG_X, CONSERVE);
    vec3 wo = to_axes(a, s.to_eye);
    float energy = f.share;
#if IMAGE_LIGHT == 3 && !defined(COSINE_LOBE)
    energy *= cloth_energy(f.m, m, f, wo);
#endif
    return image_specular(s, m, a, p, wo) * energy;
}
#endif
#endif

#if IMAGE_LIGHT == 1
// Each sample at a point of its own within the pixel: cells, normals and colours as they are there.
vec3 cloth_image_specular(Surface s, Shading cloth, Axes axes, ClothPlace place, int samples) {
    Rotation rotation = rotation_of_pixel(s.pixel, u_seed);
    Rotation other = rotation_of_pixel(s.pixel, u_seed + 1u);
    float reach = exp2(place.size);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < samples; ++i) {
        uint index = u_frame * uint(u_image_samples) + uint(i);
        // Multiples of sqrt(2) and sqrt(3): uneven with those that choose the direction.
        vec2 shift = vec2(unit_of(index * 1779033703u + other.x), unit_of(index * 3144134277u + other.y));
        Shading m = cloth;
        float cover = put_yarn(m, place.at + (shift - 0.5) * reach);
        Axes a = axes;
        Perturbation p = facing_perturbation(s, m, a);
        sum += cover * image_sample(m, a, p, to_axes(a, s.to_eye), index, rotation);
    }
    return sum / float(u_image_samples);
}
#endif

// Black where it is not `seen`. A loop whose length is not known beforehand is not written out, and costs
// software renderers less, most of all where nothing is seen.
vec3 cloth_from_afar(Surface s, Shading m, Axes a, ClothPlace place, bool seen) {
    int families = seen ? 2 : 0;
    vec2 uv = place.at / vec2(textureSize(u_weave_cells, 0));
    float lod = max(place.size, 0.0);
    vec4 weft = textureLod(u_weave_weft, uv, lod);
    vec4 warp = textureLod(u_weave_warp, uv, lod);
    vec3 sum = vec3(0.0);
    for (int family = 0; family < families; ++family) {
        ClothFamily f = cloth_family(family, family == 0 ? weft : warp, m, a, s.to_eye);
#if LIGHTS > 0
        sum += cloth_lit_by_lights(s, f, a.z);
#endif
#if IMAGE_LIGHT > 0 && !defined(METAL)
        sum += cloth_lit_by_irradiance(f) * occlusion_at(s);
#endif
#if IMAGE_LIGHT > 1
        sum += cloth_image_specular(s, f) * specular_open(s, m, f.wo.z);
#endif
    }
#if IMAGE_LIGHT == 1
    int samples = seen ? u_image_samples : 0;
    sum += cloth_image_specular(s, m, a, place, samples) * specular_open(s, m, dot(a.z, s.to_eye));
#endif
    return sum;
}
