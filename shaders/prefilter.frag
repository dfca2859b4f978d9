// One face of one level of the environment's lobe map: radiance blurred by an isotropic lobe, as a
// surface of that roughness facing the direction reflects it.
#include "shading"
#include "shaders/lib/environment.glsl"

in vec2 v_ndc;
uniform int u_face;
uniform int u_kernel_samples;
uniform float u_kernel_alpha;

layout(location = 0) out vec4 o_radiance;

// The point of a face of the cube of half side 1, in OpenGL's layout of faces.
vec3 face_point(int face, vec2 p) {
    if (face == 0) { return vec3(1.0, -p.y, -p.x); }
    if (face == 1) { return vec3(-1.0, -p.y, p.x); }
    if (face == 2) { return vec3(p.x, 1.0, p.y); }
    if (face == 3) { return vec3(p.x, -1.0, -p.y); }
    if (face == 4) { return vec3(p.x, -p.y, 1.0); }
    return vec3(-p.x, -p.y, -1.0);
}

// GGX viewed along its axis. tan^2 of the half angle is a^2 u/(1-u), and the density of the
// reflected direction is D/4. The points form a golden spiral; each reads the mip level that covers
// its share.
void main() {
    vec3 axis = normalize(face_point(u_face, v_ndc));
    vec3 spare = abs(axis.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
    vec3 t = normalize(cross(spare, axis));
    vec3 b = cross(axis, t);
    vec3 sum = vec3(0.0);
    float a2 = u_kernel_alpha * u_kernel_alpha;
    for (int i = 0; i < u_kernel_samples; ++i) {
        float u = (float(i) + 0.5) / float(u_kernel_samples);
        float turn = 2.0 * kPi * fract(float(i) * 0.6180339887);
        float tan2 = a2 * u / (1.0 - u);
        float cos2 = 1.0 / (1.0 + tan2);
        // Twice the half angle: cos 2t = 2 cos^2 t - 1, sin 2t = 2 cos^2 t tan t.
        vec2 side = 2.0 * cos2 * sqrt(tan2) * vec2(cos(turn), sin(turn));
        vec3 w = axis * (2.0 * cos2 - 1.0) + t * side.x + b * side.y;
        float shape = 1.0 - u;  // 1 / (1 + tan^2/a^2)
        float density = shape * shape / (4.0 * kPi * a2 * cos2 * cos2);
        // 4: a share covers four times its area; otherwise the points would be visible around a
        // sun.
        float lod = environment_lod(4.0 / (float(u_kernel_samples) * density));
        sum += textureLod(u_environment, w, u_kernel_alpha > 0.0 ? lod : 0.0).rgb;
    }
    o_radiance = vec4(sum / float(u_kernel_samples), 1.0);
}
