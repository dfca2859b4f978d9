// What resolve.frag needs to shade a pixel once: normal, tangent, texture coordinates and their
// footprint in two (POSITION: three) float images.
in vec3 v_position;
in vec3 v_normal;
in vec4 v_tangent;
in vec2 v_uv;

layout(location = 0) out vec4 o_normal_u;   // |normal| - 32 is log2 of the pixel's footprint on uv
layout(location = 1) out vec4 o_tangent_v;  // |tangent| 2: the bitangent is mirrored
#ifdef POSITION
layout(location = 2) out vec4 o_position;
#endif

void main() {
    float side = gl_FrontFacing ? 1.0 : -1.0;
    vec2 dx = dFdx(v_uv);
    vec2 dy = dFdy(v_uv);
    // 2^-48: footprints below 2^-24, no larger texture exists; keeps the length positive.
    float footprint = 0.5 * log2(clamp(max(dot(dx, dx), dot(dy, dy)), exp2(-48.0), exp2(48.0)));
    float n2 = max(dot(v_normal, v_normal), 1e-30);
    float t2 = max(dot(v_tangent.xyz, v_tangent.xyz), 1e-30);
    o_normal_u = vec4(v_normal * (side * inversesqrt(n2) * (32.0 + footprint)), v_uv.x);
    float mirrored = v_tangent.w * side < 0.0 ? 2.0 : 1.0;
    o_tangent_v = vec4(v_tangent.xyz * (side * inversesqrt(t2) * mirrored), v_uv.y);
#ifdef POSITION
    o_position = vec4(v_position, 1.0);
#endif
}
