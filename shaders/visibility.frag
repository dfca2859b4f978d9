// Desktop only: ES 3.0 has no gl_PrimitiveID.
uniform uint u_first_triangle;
layout(location = 0) out uint o_triangle;

void main() {
    o_triangle = u_first_triangle + uint(gl_PrimitiveID);
}
