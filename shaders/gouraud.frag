in vec3 v_radiance;
layout(location = 0) out vec4 o_radiance;

void main() {
    o_radiance = vec4(v_radiance, 1.0);
}
