// Which exemplars a pixel sees of a tabulated material, and what it sees of each: texels cannot be
// mixed before the light is reflected, so radiance is mixed after. Up close the four texels about the
// point, weighed as a bilinear filter weighs them. Where the pixel (or its part for one of several
// samples) is wider than a texel, 4 to 16 texels drawn evenly from its area: their mean over the samples
// of a pixel is the mean over all texels.

uniform highp usampler2D u_tabulated_texels;  // x: exemplar, angle; y: normal
uniform sampler2D u_tabulated_diffuse;
uniform sampler2D u_tabulated_specular;
uniform int u_tabulated_columns;              // of blocks beside one another
uniform float u_tabulated_part;               // side of a sample's share of the pixel
uniform int u_tabulated_one;                  // 1 where all texels are one
uniform int u_tabulated_area_rows;            // of a block of areas
#if IMAGE_LIGHT != 1
uniform uint u_frame;
uniform uint u_seed;
#endif

vec2 tabulated_uv(Surface s) {
#ifdef UV_PER_TEXTURE
    return texture_uv(s, 2);  // that of the normal map
#else
    return s.uv.xy;
#endif
}

vec3 texel_normal(uint bits) {
    vec2 xy = (vec2(float(int(bits & 0xffffu)), float(int(bits >> 16))) - 32768.0) / 32767.0;
    // 0.03: as normal_of_texel.
    return normalize(vec3(xy, max(sqrt(max(1.0 - dot(xy, xy), 0.0)), 0.03)));
}

// Makes `m`, whose n is the normal map's, the material at a texel. False where nothing was measured.
bool put_texel(inout Shading m, vec2 whole) {
    vec2 size = vec2(textureSize(u_tabulated_texels, 0));
    // 0.5: so that a quotient of whole numbers is never rounded down to the one before.
    vec2 cell = whole - size * floor((whole + 0.5) / size);
    ivec2 at = ivec2(clamp(cell, vec2(0.0), size - 1.0));
    uvec2 bits = texelFetch(u_tabulated_texels, at, 0).rg;
    int exemplar = int(bits.x & 0xffffu);
    if (exemplar == 0xffff) { return false; }
    ivec2 block = ivec2(exemplar % u_tabulated_columns, exemplar / u_tabulated_columns);
    m.table = block * u_tabulated_grid;
    m.areas = block * ivec2(kAreaGrid.x, u_tabulated_area_rows);
    m.base_color = texelFetch(u_tabulated_diffuse, at, 0).rgb;
    m.specular = texelFetch(u_tabulated_specular, at, 0).rgb;
    m.n = tabulated_normal(texel_normal(bits.y), m.n);
    float angle = float(int(bits.x >> 16)) * (2.0 * kPi / 65536.0);
    m.groove = 0.0;
    if (METHOD == kMethodFollowGrain) {
        // Turned so that the groove runs along the lobe's x axis.
        m.groove = texelFetch(u_tabulated_areas, m.areas + ivec2(0, kAreaGrid.y), 0).r;
    }
    vec2 d = vec2(cos(angle + m.groove), sin(angle + m.groove));
    vec2 r = u_anisotropy_direction;
    m.direction = vec2(d.x * r.x - d.y * r.y, d.x * r.y + d.y * r.x);
    return true;
}

// Where in its part of the pixel a tap lies. Multiples of sqrt(2) and sqrt(3): uneven with those that
// choose directions.
vec2 tap_place(Rotation rotation, int tap) {
    uint index = u_frame * 16u + uint(tap);
    return vec2(unit_of(index * 1779033703u + rotation.y), unit_of(index * 3144134277u + rotation.z));
}

vec3 reflected_by_texels(Surface s, Shading m, Axes a) {
    vec2 at = tabulated_uv(s) * vec2(textureSize(u_tabulated_texels, 0));
    vec2 right = dFdx(at) * u_tabulated_part;
    vec2 up = dFdy(at) * u_tabulated_part;
    float extent = sqrt(max(dot(right, right), dot(up, up)));
    bool wide = extent > 1.0;
    int side = wide ? clamp(int(min(ceil(extent), 4.0)), 2, 4) : 2;
    m.taps = u_tabulated_one > 0 ? 1 : side * side;
    Rotation rotation = rotation_of_pixel(s.pixel, u_seed);
    vec2 first = floor(at - 0.5);
    vec2 between = at - 0.5 - first;
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    for (int tap = 0; tap < m.taps; ++tap) {
        vec2 corner = vec2(float(tap % side), float(tap / side));
        vec2 share = mix(1.0 - between, between, corner);
        vec2 place = (corner + tap_place(rotation, tap)) / float(side) - 0.5;
        vec2 cell = wide ? floor(at + right * place.x + up * place.y) : first + corner;
        float weight = wide || u_tabulated_one > 0 ? 1.0 : share.x * share.y;
        Shading t = m;
        t.tap = tap;
        if (weight > 0.0 && put_texel(t, cell)) {
            sum += weight * reflected(s, t, a);
            weights += weight;
        }
    }
    return sum / max(weights, 1e-6);
}
