// The radiance of a light with an area that is seen itself.
#include "shaders/lib/output.glsl"

in vec2 v_place;
uniform vec3 u_emitter_radiance;
uniform float u_emitter_round;  // 1: an ellipse
#ifdef AREA_TEXTURES
uniform highp sampler2DArray u_area_textures;
uniform float u_emitter_layer;
#endif

layout(location = 0) out vec4 o_radiance;

void main() {
    if (u_emitter_round > 0.5 && dot(v_place, v_place) > 1.0) { discard; }
    vec3 radiance = u_emitter_radiance;
#ifdef AREA_TEXTURES
    vec3 place = vec3(0.5 + 0.5 * v_place.x, 0.5 - 0.5 * v_place.y, max(u_emitter_layer, 0.0));
    vec3 color = texture(u_area_textures, place).rgb;
    radiance *= u_emitter_layer < 0.0 ? vec3(1.0) : color;
#endif
    o_radiance = vec4(finite_radiance(radiance), 1.0);
}
