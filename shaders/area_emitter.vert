// A light with an area in the picture: a rectangle as two triangles without buffers.
uniform mat4 u_clip_from_world;
uniform vec3 u_emitter_middle;
uniform vec3 u_emitter_x;  // half the sides
uniform vec3 u_emitter_y;

out vec2 v_place;

void main() {
    int corner = gl_VertexID < 3 ? gl_VertexID : gl_VertexID - 2;  // 0 1 2, 1 2 3
    v_place = vec2((corner & 1) == 1 ? 1.0 : -1.0, corner >= 2 ? 1.0 : -1.0);
    vec3 position = u_emitter_middle + u_emitter_x * v_place.x + u_emitter_y * v_place.y;
    gl_Position = u_clip_from_world * vec4(position, 1.0);
}
