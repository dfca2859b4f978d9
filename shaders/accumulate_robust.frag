// Adds one frame to the sum of frames, in which samples brighter than a limit have a smaller weight: each
// adds the limit at most, so that one of them does not decide a pixel. Coverage is summed without weights.
uniform sampler2D u_sum;
uniform sampler2D u_weights;
uniform sampler2D u_latest;
uniform float u_limit;        // of the brightest channel
uniform float u_transparent;  // 1: alpha is coverage, and colors are premultiplied by it

layout(location = 0) out vec4 o_sum;
layout(location = 1) out float o_weights;  // of the coverage

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 latest = texelFetch(u_latest, pixel, 0);
    float coverage = u_transparent > 0.5 ? latest.a : 1.0;
    // The color without coverage is rgb / coverage.
    float brightest = max(max(latest.r, latest.g), latest.b);
    float limit = u_limit * coverage;
    float weight = brightest > limit ? limit / brightest : 1.0;
    o_sum = texelFetch(u_sum, pixel, 0) + vec4(weight * latest.rgb, latest.a);
    o_weights = texelFetch(u_weights, pixel, 0).r + weight * coverage;
}
