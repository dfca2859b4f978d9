// One triangle over the whole target, at depth u_depth in [0, 1].
uniform float u_depth;
out vec2 v_ndc;

void main() {
    v_ndc = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(v_ndc, u_depth * 2.0 - 1.0, 1.0);
}
