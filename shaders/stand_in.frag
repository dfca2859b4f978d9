// A simple picture of any surface, drawn while the program of its material is compiled: Lambert, Blinn and Phong of the
// mean roughness, and one look-up of the environment along the mirror's direction. LIT_BY_ENVIRONMENT: there is one.
#include "shaders/lib/lights.glsl"
#include "shading/frame.glsl"
#ifdef LIT_BY_ENVIRONMENT
#include "shaders/lib/environment.glsl"
#endif

in vec3 v_position;
in vec3 v_normal;

uniform vec4 u_eye;
uniform vec4 u_base_color;
uniform float u_metallic;
uniform float u_dielectric_f0;
uniform vec3 u_emissive;
uniform float u_phong_exponent;

layout(location = 0) out vec4 o_radiance;

void main() {
    vec3 wo = normalize(u_eye.xyz - v_position * u_eye.w);
    vec3 n = normalize(v_normal);
    n = dot(n, wo) < 0.0 ? -n : n;
    vec3 diffuse = u_base_color.rgb * (1.0 - u_metallic);
    vec3 specular = mix(vec3(u_dielectric_f0), u_base_color.rgb, u_metallic);
    vec3 radiance = u_emissive;
#if LIGHTS > 0
    // The lobe about the half vector is four times as wide in the light's direction.
    float peak = (u_phong_exponent + 2.0) / (8.0 * kPi);
    for (int i = 0; i < LIGHT_COUNT; ++i) {
        vec3 irradiance;
        vec3 wi = light_direction(i, v_position, irradiance);
        float lobe = peak * pow(max(dot(n, normalize(wi + wo)), 1e-6), u_phong_exponent);
        radiance += irradiance * max(dot(n, wi), 0.0) * (diffuse / kPi + specular * lobe);
    }
#endif
#ifdef LIT_BY_ENVIRONMENT
    float alpha2 = 2.0 / (u_phong_exponent + 2.0);
    radiance += diffuse * environment_irradiance(n);
    radiance += specular * environment_radiance(reflect(-wo, n), environment_lod(kPi * alpha2));
#endif
    float coverage = clamp(u_base_color.a, 0.0, 1.0);
    o_radiance = vec4(clamp(radiance, 0.0, 65504.0) * coverage, coverage);
}
