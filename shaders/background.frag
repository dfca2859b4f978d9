// Draws the environment as background.
#include "shading"
#include "shaders/lib/output.glsl"
#include "shaders/lib/environment.glsl"

in vec2 v_ndc;
uniform vec3 u_ray_center;  // ray of the middle of the tile; orthographic: the view direction
uniform vec3 u_ray_x;       // half the width of the tile
uniform vec3 u_ray_y;
uniform float u_background_lod;

layout(location = 0) out vec4 o_radiance;

void main() {
    vec3 ray = u_ray_center + u_ray_x * v_ndc.x + u_ray_y * v_ndc.y;
    o_radiance = vec4(finite_radiance(environment_radiance(normalize(ray), u_background_lod)), 1.0);
}
