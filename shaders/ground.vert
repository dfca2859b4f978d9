// The square of the ground, as two triangles without buffers.
#include "shaders/lib/ground.glsl"

uniform mat4 u_clip_from_world;
out vec2 v_place;

void main() {
    int corner = gl_VertexID < 3 ? gl_VertexID : gl_VertexID - 2;  // 0 1 2, 1 2 3
    v_place = vec2((corner & 1) == 1 ? 1.0 : -1.0, corner >= 2 ? 1.0 : -1.0);
    gl_Position = u_clip_from_world * vec4(ground_position(v_place), 1.0);
}
