// Lighting per vertex by Lambert and Phong: the reference for frame costs (K11 Fig 11, K12 Table
// I).
#include "shaders/lib/lights.glsl"
#include "shading/frame.glsl"

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;

uniform mat4 u_clip_from_world;
uniform mat4 u_world_from_local;
uniform mat3 u_normal_from_local;
uniform vec4 u_eye;
uniform vec4 u_base_color;
uniform float u_metallic;
uniform float u_dielectric_f0;
uniform float u_phong_exponent;

out vec3 v_radiance;

void main() {
    vec4 world = u_world_from_local * vec4(a_position, 1.0);
    vec3 n = normalize(u_normal_from_local * a_normal);
    vec3 wo = normalize(u_eye.xyz - world.xyz * u_eye.w);
    vec3 diffuse = u_base_color.rgb * ((1.0 - u_metallic) / kPi);
    vec3 specular = mix(vec3(u_dielectric_f0), u_base_color.rgb, u_metallic) *
                    ((u_phong_exponent + 2.0) / (2.0 * kPi));
    v_radiance = vec3(0.0);
#if LIGHTS > 0
    for (int i = 0; i < LIGHT_COUNT; ++i) {
        vec3 irradiance;
        vec3 wi = light_direction(i, world.xyz, irradiance);
        float mirror = max(dot(reflect(-wi, n), wo), 1e-6);
        v_radiance += irradiance * max(dot(n, wi), 0.0) *
                      (diffuse + specular * pow(mirror, u_phong_exponent));
    }
#endif
    gl_Position = u_clip_from_world * world;
}
