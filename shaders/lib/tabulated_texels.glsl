// The exemplars of a tabulated material within a pixel. Texels must not be averaged before
// reflection, so their radiances are averaged. For a magnified texture these are the four texels
// about the point, with bilinear weights. Where the pixel (or the part of it for one of several
// samples) is wider than a texel, they are 4 to 16 texels drawn uniformly from its area: their mean
// over the samples of a pixel is the mean over all texels.

uniform highp usampler2D u_tabulated_texels;  // tabulated_maps.hpp
uniform highp usampler2D u_tabulated_colors;
uniform int u_tabulated_columns;    // number of blocks in a row
uniform float u_tabulated_part;     // side of a sample's part of the pixel
uniform int u_tabulated_one;        // 1 where all texels are equal
uniform int u_tabulated_area_rows;  // height of a block of areas
#if IMAGE_LIGHT != 1
uniform uint u_frame;
uniform uint u_seed;
#endif

vec2 tabulated_uv(Surface s) {
#ifdef UV_PER_TEXTURE
    return texture_uv(s, 2);  // those of the normal map
#else
    return s.uv.xy;
#endif
}

// Two numbers in [-1, 1] from 16 bits each.
vec2 pair_of(uint bits) {
    return (vec2(float(int(bits & 0xffffu)), float(int(bits >> 16))) - 32768.0) * (1.0 / 32767.0);
}

// A color from non-negative half floats: their bits are those of a float 2^112 times as small.
vec3 color_of(uint r, uint g, uint b) {
    return vec3(uintBitsToFloat((r & 0xffffu) << 13), uintBitsToFloat((g & 0xffffu) << 13),
                uintBitsToFloat((b & 0xffffu) << 13)) * 5.192296858534828e33;
}

// Sets `m`, whose n is that of the normal map, to the material at a texel. Returns 1, or 0 for a
// texel without measurement, whose material is then arbitrary. No branches, because software
// renderers execute both sides.
float put_texel(inout Shading m, vec2 whole) {
    vec2 size = vec2(textureSize(u_tabulated_texels, 0));
    // 0.5: keeps the quotient of whole numbers from being rounded below an integer.
    vec2 cell = whole - size * floor((whole + 0.5) / size);
    ivec2 at = ivec2(clamp(cell, vec2(0.0), size - 1.0));
    uvec4 bits = texelFetch(u_tabulated_texels, at, 0);
    int exemplar = int(bits.x & 0xffffu);
    bool measured = exemplar != 0xffff;
    exemplar = measured ? exemplar : 0;
    // As float, exact for 16 bits: software renderers divide integers one by one.
    int row = int((float(exemplar) + 0.5) / float(u_tabulated_columns));
    ivec2 block = ivec2(exemplar - row * u_tabulated_columns, row);
    m.table.table = block * u_tabulated_grid;
    m.table.areas = block * ivec2(kAreaGrid.x, u_tabulated_area_rows);
    uvec4 colors = texelFetch(u_tabulated_colors, at, 0);
    m.base_color = color_of(colors.x, colors.x >> 16, colors.y);
    put_colors(m);
    m.surface.specular = color_of(colors.y >> 16, colors.z, colors.z >> 16);
    vec2 disk = pair_of(bits.y);
    m.n = normal_over(vector_of_disk(disk.x, disk.y), m.n);
    m.table.groove = tabulated_rotation(METHOD, float(int(bits.x >> 16)) * (1.0 / 65536.0));
    m.direction = direction_added(pair_of(METHOD == kMethodFollowGrain ? bits.w : bits.z), u_anisotropy_direction);
    return measured ? 1.0 : 0.0;
}

// Position of a tap in its part of the pixel. Multiples of sqrt(2) and sqrt(3), which do not
// correlate with those that choose directions.
vec2 tap_place(uvec2 pixel, int tap) {
    Rotation rotation = rotation_of_pixel(pixel, u_seed);
    uint index = u_frame * 16u + uint(tap);
    return vec2(unit_of(index * 1779033703u + rotation.y), unit_of(index * 3144134277u + rotation.z));
}

#if LIGHTS > 0
// Values that all texels share; directions are in the axes of the surface.
struct TexelLights {
    vec3 wi[LIGHTS];
    vec3 h[LIGHTS];
    vec3 irradiance[LIGHTS];
    float fresnel[LIGHTS];
};

TexelLights texel_lights(Surface s, Frame a, vec3 wo) {
    TexelLights l;
    for (int i = 0; i < LIGHT_COUNT; ++i) {
        vec3 irradiance;
        vec3 towards = light_direction(i, s.position, irradiance);
#if SHADOW_MAPS > 0
        irradiance *= light_reaches(i, s.position, a.n, towards);
#endif
        l.irradiance[i] = irradiance;
        l.wi[i] = frame_to_local(a, towards);
        l.h[i] = half_vector(l.wi[i] + wo, vec3(0.0, 0.0, 1.0));
        l.fresnel[i] = fresnel_rise(u_tabulated_fresnel.x, u_tabulated_fresnel.y, max(dot(l.h[i], wo), 0.0));
    }
    return l;
}

// Radiance of one texel. Directions are in the axes of the texel, except those of `l`.
vec3 lit_texel(TexelLights l, Shading m, Perturbation p, vec3 wo) {
    float cos_o = dot(p.n, wo);
    float seen = tabulated_seen(m.table, perturb_direction(p, wo));
    vec3 sum = vec3(0.0);
    for (int i = 0; i < LIGHT_COUNT; ++i) {
        vec3 wi = seen_from_rotated(l.wi[i], m.direction);
        float cos_i = dot(p.n, wi);
        float D = tabulated_D(m.table, perturb_point(p, seen_from_rotated(l.h[i], m.direction)));
        float lit = tabulated_seen(m.table, perturb_direction(p, wi));
#ifdef LAYERS
        vec2 f = vec2(tabulated_brdf(D, lit, seen, cos_i, cos_o),
                      diffuse_eval(kBrdfTabulated, u_dielectric_f0, cos_i, cos_o)) * max(cos_i, 0.0);
        sum += l.irradiance[i] * layers_laid(m.layers, m.seen, p.n, m.surface.specular * l.fresnel[i], f.x,
                                             m.surface.diffuse, f.y, wi, wo);
#else
        vec3 f = m.surface.specular * (l.fresnel[i] * tabulated_brdf(D, lit, seen, cos_i, cos_o));
        f += m.surface.diffuse * diffuse_eval(kBrdfTabulated, u_dielectric_f0, cos_i, cos_o);
        sum += l.irradiance[i] * f * max(cos_i, 0.0);
#endif
    }
    return sum;
}
#endif

vec3 reflected_by_texels(Surface s, Shading m, Frame a) {
    vec3 wo = frame_to_local(a, s.to_eye);
#if LIGHTS > 0
    TexelLights lights = texel_lights(s, a, wo);
#endif
    vec2 size = vec2(textureSize(u_tabulated_texels, 0));
    vec2 at = tabulated_uv(s) * size;
#ifdef FOOTPRINT_GIVEN
    vec2 right = s.shape.xy * size * u_tabulated_part;
    vec2 up = s.shape.zw * size * u_tabulated_part;
#else
    vec2 right = dFdx(at) * u_tabulated_part;
    vec2 up = dFdy(at) * u_tabulated_part;
#endif
    float extent = sqrt(max(dot(right, right), dot(up, up)));
    bool wide = extent > 1.0;
    float side = wide ? min(ceil(extent), 4.0) : 2.0;
    m.taps = u_tabulated_one > 0 ? 1 : int(side * side);
    vec2 first = floor(at - 0.5);
    vec2 between = at - 0.5 - first;
    vec3 sum = vec3(0.0);
    float weights = 0.0;
    vec2 corner = vec2(0.0);
    for (int tap = 0; tap < m.taps; ++tap) {
        vec2 cell = first + corner;
        // A loop that runs once or not at all: software renderers can skip a loop, but execute both
        // sides of an `if`.
        for (int i = wide ? 0 : 1; i < 1; ++i) {
            vec2 place = (corner + tap_place(s.pixel, tap)) / side - 0.5;
            cell = floor(at + right * place.x + up * place.y);
        }
        vec2 share = mix(1.0 - between, between, corner);
        float weight = wide || u_tabulated_one > 0 ? 1.0 : share.x * share.y;
        Shading t = m;
        t.tap = tap;
        weight *= put_texel(t, cell);
        Frame turned_axes = a;
        Perturbation p = facing_perturbation(s, t, turned_axes);
        vec3 turned_wo = seen_from_rotated(wo, t.direction);
#ifdef LAYERS
        lay_over(t, s, turned_axes, p, turned_wo);
#endif
        vec3 radiance = vec3(0.0);
#if LIGHTS > 0
        radiance += lit_texel(lights, t, p, turned_wo);
#endif
#ifdef AREA_LIGHTS
        radiance += lit_by_area_lights(s, t, turned_axes, p, turned_wo);
#endif
#if IMAGE_LIGHT > 0
        radiance += lit_by_environment(s, t, turned_axes, p, turned_wo);
#endif
        sum += weight * radiance;
        weights += weight;
        corner.x += 1.0;
        corner = corner.x < side ? corner : vec2(0.0, corner.y + 1.0);
    }
    return sum / max(weights, 1e-6);
}
