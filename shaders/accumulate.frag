// Adds one frame to the sum of frames.
uniform sampler2D u_sum;
uniform sampler2D u_latest;
layout(location = 0) out vec4 o_sum;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    o_sum = texelFetch(u_sum, pixel, 0) + texelFetch(u_latest, pixel, 0);
}
