// Converts the sum of frames to displayed colors: mean, exposure, tone map, sRGB encoding
// (shading/display). The mean is computed as src/gpu/draw/renderer.cpp does for a sum that is read
// back. The target may differ in size from the picture: each of its pixels shows the nearest one.
#include "shading"

in vec2 v_ndc;
uniform sampler2D u_sum;
uniform sampler2D u_weights;    // what divides the sum of a robust mean
uniform float u_robust;         // 1: u_sum is one
uniform ivec2 u_size;         // of the picture, in the lower left of u_sum
uniform float u_share;        // 1 / samples
uniform float u_gain;         // 2^EV
uniform int u_tone_map;       // kToneMap...
uniform int u_albedo;         // 1: the sum is of albedos, which are shown by their scale
uniform float u_transparent;  // 1: alpha is coverage, and the sum's color is premultiplied by it

layout(location = 0) out vec4 o_color;

// NaN, infinity and negative values become 0; 65504 is the largest half float.
float writable(float v) {
    return v >= 0.0 && v <= 3.4e38 ? min(v, 65504.0) : 0.0;
}

void main() {
    ivec2 pixel = clamp(ivec2((0.5 + 0.5 * v_ndc) * vec2(u_size)), ivec2(0), u_size - 1);
    vec4 sum = texelFetch(u_sum, pixel, 0);
    bool transparent = u_transparent > 0.5;
    float alpha = transparent ? min(writable(sum.a * u_share), 1.0) : 1.0;
    // An alpha below 1e-6 is rounding error and must not divide.
    float each = !transparent ? u_share : alpha > 1e-6 ? u_share / alpha : 0.0;
    if (u_robust > 0.5 && each > 0.0) { each = 1.0 / texelFetch(u_weights, pixel, 0).r; }
    vec3 radiance = vec3(writable(sum.r * each), writable(sum.g * each), writable(sum.b * each));
    if (u_albedo > 0) { radiance = color_of_albedo(radiance); }
    o_color = vec4(display_color(u_tone_map, radiance * u_gain), alpha);
}
