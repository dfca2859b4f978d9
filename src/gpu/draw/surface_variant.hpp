// The variant of the surface shader that a draw needs. Everything known before shading is a
// #define, so that branches on it fold away. One program per variant.
#pragma once

#include <string>

#include "burnish/scene.hpp"

namespace burnish::gpu {

struct SurfaceVariant {
    Method method = Method::none;
    Mdf mdf = Mdf::ggx;
    Brdf brdf = Brdf::microfacet;
    bool conserve = false;
    bool conductor = false;
    bool fresnel_curve = false;  // a conductor under a film
    bool metal = false;          // no diffuse term
    bool compensated = false;    // with the light that facets reflect more than once
    bool lobe_from_texture = false;
    bool grooves_along_x = true;  // unless lobe_from_texture
    bool turned = false;          // the stretch is not along the tangent
    bool base_color_map = false;
    bool metallic_roughness_map = false;
    bool normal_map = false;
    bool normal_map_xy = false;   // two channels: z follows from unit length
    bool normal_moments = false;  // the normal map holds slopes and their variances
    bool occlusion_map = false;
    bool emissive_map = false;
    bool anisotropy_map = false;
    bool specular_factors = false;  // KHR_materials_specular changes the interface
    bool specular_map = false;
    bool specular_color_map = false;
    bool coat = false;
    bool coat_tint = false;
    bool coat_map = false;
    bool coat_roughness_map = false;
    bool coat_normal_map = false;
    bool coat_normal_map_xy = false;  // as normal_map_xy and normal_moments
    bool coat_normal_moments = false;
    bool sheen = false;
    bool sheen_color_map = false;
    bool sheen_roughness_map = false;
    bool cloth = false;
    bool cloth_colors = false;  // its draft has a color per yarn
    bool tabulated = false;
    bool uv_per_texture = false;
    bool vertex_color = false;
    AlphaMode alpha_mode = AlphaMode::opaque;
    int lights = 0;  // with light_count_at_run_time: capacity
    bool light_count_at_run_time = false;
    int area_lights = 0;  // with light_count_at_run_time: capacity
    bool area_textures = false;
    bool position = false;  // a light needs the position of the surface
    int shadow_maps = 0;
    int image_light = 0;      // 0 off, 1 importance, 2 bent normal, 3 prefiltered
    bool visibility = false;  // vertices know what they see of the environment
    bool view = false;        // a SurfaceView in place of the radiance
    bool furnace = false;     // and that is the albedo, in a white environment

    // Whether gbuffer.frag stores all that shading needs.
    bool can_resolve() const {
        return alpha_mode == AlphaMode::opaque && !vertex_color && !uv_per_texture;
    }

    bool operator==(const SurfaceVariant&) const = default;

    std::string defines() const;  // lines for assemble_stage, and the key of the program
};

}  // namespace burnish::gpu
