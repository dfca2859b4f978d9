// Coat and sheen at a point: uniforms times textures.

uniform vec2 u_coat;               // strength, perceptual roughness
uniform vec3 u_coat_depth;         // of coat_depth
uniform vec2 u_coat_normal_scale;  // y negative: green points down
uniform vec4 u_sheen;              // color, roughness
uniform sampler2D u_coat_map;
uniform sampler2D u_coat_roughness_map;
uniform sampler2D u_coat_normal_map;
uniform sampler2D u_sheen_color_map;
uniform sampler2D u_sheen_roughness_map;

#ifdef COAT_NORMAL_MAP
// Widens `lobe` where the map holds slopes.
vec3 coat_normal_at(Surface s, inout Lobe lobe) {
    vec4 texel = MAP_AT(u_coat_normal_map, 10);
#ifdef COAT_NORMAL_MOMENTS
    vec3 n = normal_of_slopes(texel.x * u_coat_normal_scale.x, texel.y * u_coat_normal_scale.y);
    vec2 variance = variance_about(n, texel.zw, u_coat_normal_scale);
    // The lobe stays round: a coat has no grain.
    float mean = 0.5 * (variance.x + variance.y);
    lobe = widen_lobe(lobe, mean, mean);
    return n;
#elif defined(COAT_NORMAL_MAP_XY)
    return normal_of_vector(vector_of_texel(texel.xy), u_coat_normal_scale);
#else
    return normal_of_vector(vector_of_texel(texel.xyz), u_coat_normal_scale);
#endif
}
#endif

#ifdef COAT
CoatLayer coat_at(Surface s, out vec3 n) {
    n = vec3(0.0, 0.0, 1.0);
    float strength = u_coat.x;
    float roughness = u_coat.y;
#ifdef HAS_COAT_MAP
    strength *= MAP_AT(u_coat_map, 8).r;
#endif
#ifdef HAS_COAT_ROUGHNESS_MAP
    roughness *= MAP_AT(u_coat_roughness_map, 9).g;
#endif
    Lobe lobe = lobe_of_roughness(kMdfGgx, clamp(roughness, 0.0, 1.0), 0.0);
#ifdef COAT_NORMAL_MAP
    n = coat_normal_at(s, lobe);
#endif
#ifdef COAT_TINT
    const bool tinted = true;
#else
    const bool tinted = false;
#endif
    return coat_make(clamp(strength, 0.0, 1.0), lobe, vec3(0.0, 0.0, 1.0), tinted, u_coat_depth);
}
#endif

#ifdef SHEEN
SheenLayer sheen_at(Surface s) {
    vec4 sheen = u_sheen;
#ifdef HAS_SHEEN_COLOR_MAP
    sheen.rgb *= MAP_AT(u_sheen_color_map, 11).rgb;
#endif
#ifdef HAS_SHEEN_ROUGHNESS_MAP
    sheen.a *= MAP_AT(u_sheen_roughness_map, 12).a;
#endif
    return sheen_make(sheen.rgb, sheen.a);
}
#endif

SurfaceLayers layers_at(Surface s, out vec3 coat_n) {
    SurfaceLayers l;
    coat_n = vec3(0.0, 0.0, 1.0);
#ifdef COAT
    l.coat = coat_at(s, coat_n);
#else
    l.coat = coat_none();
#endif
#ifdef SHEEN
    l.sheen = sheen_at(s);
#else
    l.sheen = sheen_none();
#endif
    return l;
}
