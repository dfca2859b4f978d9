// Four 32-bit words per pixel from gbuffer.frag to resolve.frag. x: the normal (octahedral, 16 bits
// per coordinate: 3e-5 rad). y: the tangent (octahedral, 11 bits per coordinate: 7e-4 rad), the
// sign of the bitangent (1 bit) and the footprint (9 bits). z and w: texture coordinates as floats.
// One image, because writing and reading a second one costs more than the packing.

const float kLowFootprint = 5.421010862427522e-20;  // 2^-64

// 1e-30: keeps the division finite for a zero vector.
vec2 octahedral(vec3 v) {
    vec2 p = v.xy * (1.0 / (abs(v.x) + abs(v.y) + abs(v.z) + 1e-30));
    vec2 side = vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
    return v.z < 0.0 ? (1.0 - abs(p.yx)) * side : p;
}

// The result is not a unit vector.
vec3 from_octahedral(vec2 p) {
    float z = 1.0 - abs(p.x) - abs(p.y);
    float fold = max(-z, 0.0);
    return vec3(p.x + (p.x < 0.0 ? fold : -fold), p.y + (p.y < 0.0 ? fold : -fold), z);
}

// Maps [-1, 1] to 0 .. 2 half; 0 is representable exactly. Through int, because conversions from
// and to unsigned take software renderers several instructions.
uvec2 quantised(vec2 p, float half_range) {
    return uvec2(ivec2(p * half_range + (half_range + 0.5)));
}

vec2 from_quantised(uvec2 q, float half_range) {
    return vec2(ivec2(q)) * (1.0 / half_range) - 1.0;
}

// `mirrored`: negative where the bitangent is mirrored. `footprint2`: square of the footprint. Its
// exponent and two bits of its mantissa are kept, a precision of an eighth of a mip level. The
// range 2^-64 to 2^64 exceeds any texture's.
uvec4 packed_pixel(vec3 normal, vec3 tangent, float mirrored, float footprint2, vec2 uv) {
    uvec2 n = quantised(octahedral(normal), 32767.0);
    uvec2 t = quantised(octahedral(tangent), 1023.0);
    uint f = (floatBitsToUint(max(footprint2, kLowFootprint)) - floatBitsToUint(kLowFootprint)) >> 21;
    uint sign_bit = (floatBitsToUint(mirrored) >> 31) << 22;
    return uvec4(n.x | (n.y << 16), t.x | (t.y << 11) | sign_bit | (f << 23),
                 floatBitsToUint(uv.x), floatBitsToUint(uv.y));
}

vec3 packed_normal(uvec4 p) {
    return from_octahedral(from_quantised(uvec2(p.x & 65535u, p.x >> 16), 32767.0));
}

// w: the sign of the bitangent.
vec4 packed_tangent(uvec4 p) {
    vec3 t = from_octahedral(from_quantised(uvec2(p.y & 2047u, (p.y >> 11) & 2047u), 1023.0));
    return vec4(t, (p.y & (1u << 22)) != 0u ? -1.0 : 1.0);
}

// log2 of the footprint. 1 << 20: the middle of the interval of the dropped bits.
float packed_footprint(uvec4 p) {
    uint bits = ((p.y >> 23) << 21) + (1u << 20) + floatBitsToUint(kLowFootprint);
    return 0.5 * log2(uintBitsToFloat(bits));
}

vec2 packed_uv(uvec4 p) {
    return vec2(uintBitsToFloat(p.z), uintBitsToFloat(p.w));
}

// Three numbers in [-1/2, 1/2], 10 bits each.
uint packed_three(vec3 v) {
    uvec3 q = uvec3(ivec3(clamp(v, -0.5, 0.5) * 1022.0 + 511.5));
    return q.x | (q.y << 10) | (q.z << 20);
}

vec3 from_packed_three(uint word) {
    ivec3 q = ivec3(int(word & 1023u), int((word >> 10) & 1023u), int((word >> 20) & 1023u));
    return vec3(q) * (1.0 / 1022.0) - 0.5;
}

// A color: 9 bits a channel of a common exponent, 2^-15 to 2^16.
uint packed_color(vec3 color) {
    float most = max(max(color.r, max(color.g, color.b)), 1e-9);
    float exponent = clamp(floor(log2(most)) + 1.0, -15.0, 16.0);
    uvec3 q = uvec3(ivec3(clamp(color * exp2(-exponent), 0.0, 1.0) * 511.0 + 0.5));
    return q.x | (q.y << 9) | (q.z << 18) | (uint(int(exponent) + 15) << 27);
}

vec3 from_packed_color(uint word) {
    ivec3 q = ivec3(int(word & 511u), int((word >> 9) & 511u), int((word >> 18) & 511u));
    return vec3(q) * (exp2(float(int(word >> 27)) - 15.0) / 511.0);
}

#ifdef VISIBILITY
// Harmonics and Surroundings: every coefficient but the first is in [-1/2, 1/2], as no function in [0, 1] has
// another; slopes and the ratio of the sky up to 4.
Harmonics packed_blocked(uvec4 a, uvec4 b) {
    vec3 v0 = from_packed_three(a.x);
    vec3 v1 = from_packed_three(a.y);
    vec3 v2 = from_packed_three(a.z);
    return Harmonics(v0.x + 0.5, vec3(v0.yz, v1.x), vec3(v1.yz, v2.x), v2.yz, from_packed_three(a.w),
                     from_packed_three(b.x), from_packed_three(b.y).x);
}

Surroundings packed_around(uvec4 b) {
    return Surroundings(from_packed_color(b.z), from_packed_three(b.w) * 8.0,
                        from_packed_three(b.y).y * 8.0 + 1.0);
}
#endif
