// The fraction of its light that the ground receives in the shadow of the model.
#include "shaders/lib/ground.glsl"
#include "shading/display/color.glsl"

in vec2 v_place;
uniform sampler2D u_blocked;
uniform vec3 u_sky;
uniform float u_transparent;

layout(location = 0) out vec4 o_left;

void main() {
    vec3 all = u_sky * u_ground_scale;
#if LIGHTS > 0
    for (int i = 0; i < LIGHT_COUNT; ++i) { all += ground_irradiance(i, ground_position(v_place)); }
#endif
#ifdef AREA_LIGHTS
    for (int i = 0; i < AREA_COUNT; ++i) { all += ground_area_irradiance(i, ground_position(v_place)); }
#endif
    vec3 blocked = texture(u_blocked, 0.5 + 0.5 * v_place).rgb;
    // Fades out long shadows before the edge of the square.
    float shown = 1.0 - smoothstep(0.7, 1.0, length(v_place));
    // 1e-6: without light, no light is missing.
    vec3 left = 1.0 - shown * clamp(blocked / max(all, vec3(1e-6)), 0.0, 1.0);
    float missing = 1.0 - luminance(left);
    o_left = u_transparent > 0.5 ? vec4(0.0, 0.0, 0.0, missing) : vec4(left, 1.0);
}
