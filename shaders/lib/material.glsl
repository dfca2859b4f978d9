// The material at a point: uniforms times textures. HAS_*_MAP: which textures there are;
// LOBE_FROM_TEXTURE: the roughness pair varies over the surface (else GROOVES_ALONG_X is known); UV_PER_TEXTURE: textures differ in
// set or transform (else the vertex stage has already chosen and transformed the one that is used);
// FOOTPRINT_GIVEN: mips are chosen by s.footprint, not by neighbouring pixels.

uniform vec4 u_base_color;
uniform float u_metallic;
uniform float u_roughness;           // perceptual
uniform float u_anisotropy;          // strength
uniform vec2 u_anisotropy_direction; // (cos, sin) of the rotation
uniform vec3 u_emissive;
uniform float u_occlusion_strength;
uniform vec2 u_normal_scale;         // y negative: green points down
uniform vec4 u_lobe;                 // p0, p1, paper_norm, projected_norm unless LOBE_FROM_TEXTURE
uniform vec3 u_eta;                  // conductor
uniform vec3 u_k;
uniform float u_dielectric_f0;
uniform float u_ks;                  // of COSINE_LOBE; below 0: as much as keeps its energy
uniform vec3 u_lafortune_c;
uniform float u_alpha_cutoff;
uniform float u_lod_bias;

uniform sampler2D u_base_color_map;
uniform sampler2D u_metallic_roughness_map;
uniform sampler2D u_normal_map;
uniform sampler2D u_occlusion_map;
uniform sampler2D u_emissive_map;
uniform sampler2D u_anisotropy_map;

#ifdef UV_PER_TEXTURE
uniform vec3 u_uv_s[6];  // rows of each texture's transform, in the order of the samplers
uniform vec3 u_uv_t[6];
uniform float u_uv_set[6];
vec2 texture_uv(Surface s, int use) {
    vec3 p = vec3(u_uv_set[use] < 0.5 ? s.uv.xy : s.uv.zw, 1.0);
    return vec2(dot(u_uv_s[use], p), dot(u_uv_t[use], p));
}
#define MAP_AT(map, use) texture(map, texture_uv(s, use), u_lod_bias)
#elif defined(FOOTPRINT_GIVEN)
uniform float u_map_lod[6];  // log2 of each texture's longer side, plus u_lod_bias
#define MAP_AT(map, use) textureLod(map, s.uv.xy, s.footprint + u_map_lod[use])
#else
#define MAP_AT(map, use) texture(map, s.uv.xy, u_lod_bias)
#endif

// KHR_materials_anisotropy squares roughness; below 1e-3 a lobe is narrower than the sun is wide a
// hundred times over, and 1/alpha^4 of GGX's tail still fits single precision.
const float kLowestAlpha = 1e-3;

struct Shading {
    vec3 base_color;
    float alpha;
    float metallic;
    Lobe lobe;
    Bool grooves_along_x;
    vec2 direction;  // of the stretch, from the tangent: unit
    vec3 n;          // perturbed normal against tangent, bitangent and geometric normal
#ifdef TABULATED
    vec3 specular;  // reflectance at normal incidence
    ivec2 table;    // tabulated.glsl
    ivec2 areas;
    float groove;
    int tap;        // which of the texels that a pixel sees, and how many there are
    int taps;
#endif
};

#if defined(HAS_NORMAL_MAP) && defined(NORMAL_MOMENTS)
// Slopes and their variances (docs/theory/normal-filtering.md): how the lobe of a normal `n` = normal_of_slopes
// is to be widened along the tangent and the bitangent. A step ds of the slope turns n by ds nz^2 in
// the direction of the tilt and by ds nz across it, here resolved along the axes.
// 1: beyond, lobes of alpha > sqrt(2) are all one, and the widest whose normaliser is good.
vec2 variance_about(vec3 n, vec2 variance) {
    vec2 tilted = variance * u_normal_scale * u_normal_scale;
    return min(tilted * (n.z * n.z) * (1.0 - n.xy * n.xy), vec2(1.0));
}

vec3 normal_of_slopes(vec2 slopes) {
    vec2 v = slopes * u_normal_scale;
    // 0.03: tilts end at 88.8 degrees, short of where the frames of perturb.glsl are singular.
    return normalize(vec3(v, max(1.0, 0.03 * max(abs(v.x), abs(v.y)))));
}
#elif defined(HAS_NORMAL_MAP)
// A texel that is no direction out of the surface (zero, NaN, z <= 0) leaves it unperturbed. Infinite
// ones do not get here: texture_upload.cpp.
vec3 normal_of_texel(vec3 texel) {
    vec3 v = texel * 2.0 - 1.0;
#ifdef NORMAL_MAP_XY
    v.z = sqrt(max(1.0 - dot(v.xy, v.xy), 0.0));
#endif
    v = v.z > 0.0 ? v : vec3(0.0, 0.0, 1.0);
    v.xy *= u_normal_scale;
    // 0.03: tilts end at 88.8 degrees, short of where the frames of perturb.glsl are singular.
    v.z = max(v.z, 0.03 * max(abs(v.x), abs(v.y)));
    return normalize(v);
}
#endif

vec2 stretch_direction(vec3 texel) {
    vec2 d = texel.xy * 2.0 - 1.0;
    float l2 = dot(d, d);
    // 1e-4: directions that cancel under filtering leave less than the step of an 8-bit texel.
    d = l2 > 1e-4 ? d * inversesqrt(l2) : vec2(1.0, 0.0);
    vec2 r = u_anisotropy_direction;
    return vec2(d.x * r.x - d.y * r.y, d.x * r.y + d.y * r.x);
}

Lobe lobe_of_roughness(float roughness, float anisotropy) {
    float alpha = max(roughness * roughness, kLowestAlpha);
    return lobe_from_alpha(MDF, max(mix(alpha, 1.0, anisotropy * anisotropy), kLowestAlpha), alpha);
}

Lobe uniform_lobe() {
    Lobe lobe;
    lobe.mdf = MDF;
    lobe.p0 = u_lobe.x;
    lobe.p1 = u_lobe.y;
    lobe.paper_norm = u_lobe.z;
    lobe.projected_norm = u_lobe.w;
    return lobe;
}

vec4 base_color_at(Surface s) {
    vec4 base = u_base_color;
#ifdef VERTEX_COLOR
    base *= s.color;
#endif
#ifdef HAS_BASE_COLOR_MAP
    base *= MAP_AT(u_base_color_map, 0);
#endif
    return base;
}

Shading shading_at(Surface s) {
    Shading m;
    vec4 base = base_color_at(s);
    m.base_color = base.rgb;
    m.alpha = base.a;
    m.metallic = u_metallic;
    float roughness = u_roughness;
    float anisotropy = u_anisotropy;
#ifdef HAS_METALLIC_ROUGHNESS_MAP
    vec2 mr = MAP_AT(u_metallic_roughness_map, 1).gb;
    roughness *= mr.x;
    m.metallic *= mr.y;
#endif
    m.direction = u_anisotropy_direction;
#ifdef HAS_ANISOTROPY_MAP
    vec3 texel = MAP_AT(u_anisotropy_map, 5).rgb;
    m.direction = stretch_direction(texel);
    anisotropy *= texel.b;
#endif
#ifdef LOBE_FROM_TEXTURE
    m.lobe = lobe_of_roughness(clamp(roughness, 0.0, 1.0), clamp(anisotropy, 0.0, 1.0));
#else
    m.lobe = uniform_lobe();
#endif
#ifdef LOBE_FROM_TEXTURE
    m.grooves_along_x = lobe_grooves_along_x(MDF, m.lobe.p0, m.lobe.p1);
#else
    m.grooves_along_x = GROOVES_ALONG_X;
#endif
    m.n = vec3(0.0, 0.0, 1.0);
#ifdef TABULATED
    m.specular = vec3(0.0);
    m.table = ivec2(0);
    m.areas = ivec2(0);
    m.groove = 0.0;
    m.tap = 0;
    m.taps = 1;
#endif
#if defined(HAS_NORMAL_MAP) && defined(NORMAL_MOMENTS)
    vec4 slopes = MAP_AT(u_normal_map, 2);
    m.n = normal_of_slopes(slopes.xy);
    vec2 variance = variance_about(m.n, slopes.zw);
#ifdef TURNED
    // Along the stretch and across it; of slopes that vary together nothing is kept.
    vec2 along = m.direction * m.direction;
    variance = vec2(dot(variance, along), dot(variance, along.yx));
#endif
    // normal-map leaves the lobe at the geometric normal: it does not move with n~, which shows in n~.h
    // alone, and is not widened by it.
    if (METHOD != kMethodNormalMap) { m.lobe = widen_lobe(m.lobe, variance.x, variance.y); }
#elif defined(HAS_NORMAL_MAP)
    m.n = normal_of_texel(MAP_AT(u_normal_map, 2).rgb);
#endif
    return m;
}

vec3 emission_at(Surface s) {
#ifdef HAS_EMISSIVE_MAP
    return u_emissive * MAP_AT(u_emissive_map, 4).rgb;
#else
    return u_emissive;
#endif
}

float occlusion_at(Surface s) {
#ifdef HAS_OCCLUSION_MAP
    return 1.0 + u_occlusion_strength * (MAP_AT(u_occlusion_map, 3).r - 1.0);
#else
    return 1.0;
#endif
}

vec3 normal_incidence(Shading m) {
    return mix(vec3(u_dielectric_f0), m.base_color, m.metallic);
}

#ifndef TABULATED
// The Fresnel factor of the specular term at the half vector.
vec3 specular_fresnel(Shading m, float cos_h) {
#ifdef CONDUCTOR
    return fresnel_conductor(u_eta, u_k, cos_h);
#else
    return fresnel_schlick(normal_incidence(m), cos_h);
#endif
}
#endif
