// The shadow maps of lights. SHADOW_MAPS: their number.
#if defined(SHADOW_MAPS) && SHADOW_MAPS > 0
uniform sampler2DArrayShadow u_shadow_maps;
uniform mat4 u_shadow_clip[SHADOW_MAPS];
// Side in the world; at distance 1 for lights with a position.
uniform float u_shadow_texel[SHADOW_MAPS];

int face_towards(vec3 d) {
    vec3 l = abs(d);
    if (l.x >= l.y && l.x >= l.z) { return d.x > 0.0 ? 0 : 1; }
    if (l.y >= l.z) { return d.y > 0.0 ? 2 : 3; }
    return d.z > 0.0 ? 4 : 5;
}

// 1 where the light at `from` reaches the position, 0 in its shadow; `normal` unit, `wi` towards the light. `maps`:
// the first, or -1, and their number. The look-up position is offset from the surface by the size of a texel on it, which is largest at
// grazing angles: a texel holds one depth for its whole area, and the look-up reads 2 x 2 texels.
float map_reaches(vec2 maps, vec3 from, vec3 position, vec3 normal, vec3 wi) {
    if (maps.x < 0.0) { return 1.0; }
    int map = int(maps.x);
    if (maps.y > 1.0) { map += face_towards(position - from); }
    float depth = (u_shadow_clip[map] * vec4(position, 1.0)).w;
    float cosine = dot(normal, wi);
    float side = cosine < 0.0 ? -1.0 : 1.0;
    float sine = sqrt(max(1.0 - cosine * cosine, 0.0));
    float off = u_shadow_texel[map] * depth * (0.5 + 2.0 * sine);
    vec4 clip = u_shadow_clip[map] * vec4(position + normal * (side * off), 1.0);
    if (clip.w <= 0.0) { return 1.0; }
    vec3 place = clip.xyz / clip.w * 0.5 + 0.5;
    if (any(lessThan(place, vec3(0.0))) || any(greaterThan(place, vec3(1.0)))) { return 1.0; }
    return texture(u_shadow_maps, vec4(place.xy, float(map), place.z));
}
#endif
