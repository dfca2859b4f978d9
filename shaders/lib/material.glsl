// The material at a point: uniforms times textures. HAS_*_MAP: the textures in use.
// LOBE_FROM_TEXTURE: the roughness pair varies over the surface (otherwise GROOVES_ALONG_X is
// known). UV_PER_TEXTURE: textures differ in set or transform (otherwise the vertex stage has
// selected and transformed the only one in use). FOOTPRINT_GIVEN: s.footprint selects mips instead
// of derivatives between pixels.

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
#ifdef FRESNEL_CURVE
uniform vec3 u_fresnel_curve[6];     // the terms of FresnelCurve, in its order
#endif
uniform float u_dielectric_f0;
uniform float u_ks;  // of COSINE_LOBE; below 0: the value that conserves its energy
uniform vec3 u_lafortune_c;
uniform float u_alpha_cutoff;
uniform float u_lod_bias;

uniform sampler2D u_base_color_map;
uniform sampler2D u_metallic_roughness_map;
uniform sampler2D u_normal_map;
uniform sampler2D u_occlusion_map;
uniform sampler2D u_emissive_map;
uniform sampler2D u_anisotropy_map;
#ifdef SPECULAR_FACTORS
uniform vec4 u_dielectric;  // reflectance at normal incidence, and the weight
uniform sampler2D u_specular_map;
uniform sampler2D u_specular_color_map;
#endif

#ifdef UV_PER_TEXTURE
uniform vec3 u_uv_s[13];  // rows of each texture's transform, by MaterialTexture
uniform vec3 u_uv_t[13];
uniform float u_uv_set[13];
vec2 texture_uv(Surface s, int use) {
    vec3 p = vec3(u_uv_set[use] < 0.5 ? s.uv.xy : s.uv.zw, 1.0);
    return vec2(dot(u_uv_s[use], p), dot(u_uv_t[use], p));
}
#define MAP_AT(map, use) texture(map, texture_uv(s, use), u_lod_bias)
#elif defined(FOOTPRINT_GIVEN)
uniform float u_map_lod[13];  // log2 of each texture's longer side, plus u_lod_bias
#define MAP_AT(map, use) textureLod(map, s.uv.xy, s.footprint + u_map_lod[use])
#else
#define MAP_AT(map, use) texture(map, s.uv.xy, u_lod_bias)
#endif

#ifdef LAYERS
#include "shaders/lib/layer_maps.glsl"
#endif

struct Shading {
    SurfaceMaterial surface;  // its colors are set by put_colors
    vec3 base_color;
    float alpha;
    float metallic;
    bool grooves_along_x;
    vec2 direction;  // of the stretch, relative to the tangent: unit
    vec3 n;          // perturbed normal in the axes of tangent, bitangent and geometric normal
#ifdef LAYERS
    SurfaceLayers layers;  // the coat's normal is that of the surface until lay_over
    vec3 coat_n;           // in the axes of tangent, bitangent and geometric normal
    LayersSeen seen;       // from the eye: lay_over
#endif
#ifdef TABULATED
    TableBlock table;  // tabulated.glsl
    int tap;           // index of the texel among those in the pixel; taps: their number
    int taps;
#endif
};

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

#ifdef LOBE_FROM_TEXTURE
Lobe lobe_at(float roughness, float anisotropy) {
    return lobe_of_roughness(MDF, clamp(roughness, 0.0, 1.0), clamp(anisotropy, 0.0, 1.0));
}
#else
Lobe lobe_at(float roughness, float anisotropy) {
    return uniform_lobe();
}
#endif

// The Fresnel factor and the interface; METAL: no diffuse term.
SurfaceMaterial material_of(Lobe lobe) {
#ifdef TABULATED
    SurfaceMaterial m = surface_material(kBrdfTabulated, lobe, u_ks, u_lafortune_c, u_dielectric_f0);
    m.fresnel = kFresnelDielectric;
    m.eta.x = u_tabulated_fresnel.x;
    m.k.x = u_tabulated_fresnel.y;
#else
    SurfaceMaterial m = surface_material(BRDF, lobe, u_ks, u_lafortune_c, u_dielectric_f0);
#endif
#ifdef FRESNEL_CURVE
    m.fresnel = kFresnelCurve;
    m.curve = FresnelCurve(u_fresnel_curve[0], u_fresnel_curve[1], u_fresnel_curve[2],
                           u_fresnel_curve[3], u_fresnel_curve[4], u_fresnel_curve[5]);
#elif defined(CONDUCTOR)
    m.fresnel = kFresnelConductor;
    m.eta = u_eta;
    m.k = u_k;
#endif
#ifndef METAL
    m.has_diffuse = true;
#endif
    return m;
}

#ifdef SPECULAR_FACTORS
SurfaceMaterial with_specular_factors(Surface s, SurfaceMaterial m) {
    vec4 dielectric = u_dielectric;
#ifdef HAS_SPECULAR_MAP
    dielectric.a *= MAP_AT(u_specular_map, 6).a;
#endif
#ifdef HAS_SPECULAR_COLOR_MAP
    dielectric.rgb *= MAP_AT(u_specular_color_map, 7).rgb;
#endif
    return surface_dielectric(m, dielectric.rgb, dielectric.a);
}
#endif

// Call after the last change of the base color.
void put_colors(inout Shading m) { m.surface = surface_colored(m.surface, m.base_color, m.metallic); }

#ifdef HAS_NORMAL_MAP
// Sets the normal, and with NORMAL_MOMENTS the lobe that the variances of the map widen.
void put_normal(inout Shading m, vec4 texel) {
#ifdef NORMAL_MOMENTS
    m.n = normal_of_slopes(texel.x * u_normal_scale.x, texel.y * u_normal_scale.y);
    vec2 variance = variance_under(METHOD, m.n, texel.zw, u_normal_scale);
#ifdef TURNED
    variance = variance_along(variance, m.direction);
#endif
    m.surface = surface_widened(m.surface, METHOD, variance);
#elif defined(NORMAL_MAP_XY)
    m.n = normal_of_vector(vector_of_texel(texel.xy), u_normal_scale);
#else
    m.n = normal_of_vector(vector_of_texel(texel.xyz), u_normal_scale);
#endif
}
#endif

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
    m.direction = stretch_direction(texel.rg, u_anisotropy_direction);
    anisotropy *= texel.b;
#endif
    m.surface = material_of(lobe_at(roughness, anisotropy));
#ifdef SPECULAR_FACTORS
    m.surface = with_specular_factors(s, m.surface);
#endif
#ifdef LAYERS
    m.layers = layers_at(s, m.coat_n);
#endif
#ifdef LOBE_FROM_TEXTURE
    m.grooves_along_x = lobe_grooves_along_x(MDF, m.surface.lobe.p0, m.surface.lobe.p1);
#else
    m.grooves_along_x = GROOVES_ALONG_X;
#endif
    m.n = vec3(0.0, 0.0, 1.0);
#ifdef TABULATED
    m.table = TableBlock(ivec2(0), ivec2(0), 0.0);
    m.tap = 0;
    m.taps = 1;
#endif
#ifdef HAS_NORMAL_MAP
    put_normal(m, MAP_AT(u_normal_map, 2));
#endif
    put_colors(m);
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
