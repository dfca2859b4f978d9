#include "gpu/draw/surface_variant.hpp"

#include <utility>

#include "burnish/f32.hpp"

namespace burnish::gpu {
namespace {

std::string define(const char* name, int value) {
    return std::string("#define ") + name + " " + std::to_string(value) + "\n";
}

// Whether lights with an area are points to this lobe: tables have no map to the cosine, and where normal-map
// draws the lobe of ashikhmin-shirley or ward, which do not follow slopes, the map folds.
bool is_sampled_by_areas(const SurfaceVariant& v) {
    const int mdf = f32::brdf_mdf(static_cast<int>(v.brdf), static_cast<int>(v.mdf));
    return v.tabulated || (v.method == Method::normal_map && has_half_vectors(v.brdf) &&
                           (mdf == f32::kMdfAshikhminShirley || mdf == f32::kMdfWard));
}

}  // namespace

std::string SurfaceVariant::defines() const {
    const int model = static_cast<int>(brdf);
    std::string lines = define("METHOD", static_cast<int>(method));
    lines += define("MDF", f32::brdf_mdf(model, static_cast<int>(mdf)));
    lines += define("BRDF", model);
    lines += conserve ? "#define CONSERVE true\n" : "#define CONSERVE false\n";
    lines += grooves_along_x ? "#define GROOVES_ALONG_X true\n" : "#define GROOVES_ALONG_X false\n";
    lines += define("LIGHTS", lights);
    lines += define("SHADOW_MAPS", shadow_maps);
    lines += define("IMAGE_LIGHT", image_light);
    if (area_lights > 0) lines += define("AREA_LIGHTS", area_lights);
    const std::pair<bool, const char*> switches[] = {
        {conductor, "CONDUCTOR"},
        {fresnel_curve, "FRESNEL_CURVE"},
        {metal, "METAL"},
        {compensated, "COMPENSATED"},
        {!has_half_vectors(brdf), "COSINE_LOBE"},
        {lobe_from_texture, "LOBE_FROM_TEXTURE"},
        {turned, "TURNED"},
        {base_color_map, "HAS_BASE_COLOR_MAP"},
        {metallic_roughness_map, "HAS_METALLIC_ROUGHNESS_MAP"},
        {normal_map, "HAS_NORMAL_MAP"},
        {normal_map_xy, "NORMAL_MAP_XY"},
        {normal_moments, "NORMAL_MOMENTS"},
        {occlusion_map, "HAS_OCCLUSION_MAP"},
        {emissive_map, "HAS_EMISSIVE_MAP"},
        {anisotropy_map, "HAS_ANISOTROPY_MAP"},
        {specular_factors, "SPECULAR_FACTORS"},
        {specular_map, "HAS_SPECULAR_MAP"},
        {specular_color_map, "HAS_SPECULAR_COLOR_MAP"},
        {coat || sheen, "LAYERS"},
        {coat, "COAT"},
        {coat_tint, "COAT_TINT"},
        {coat_map, "HAS_COAT_MAP"},
        {coat_roughness_map, "HAS_COAT_ROUGHNESS_MAP"},
        {coat_normal_map, "COAT_NORMAL_MAP"},
        {coat_normal_map_xy, "COAT_NORMAL_MAP_XY"},
        {coat_normal_moments, "COAT_NORMAL_MOMENTS"},
        {sheen, "SHEEN"},
        {sheen_color_map, "HAS_SHEEN_COLOR_MAP"},
        {sheen_roughness_map, "HAS_SHEEN_ROUGHNESS_MAP"},
        {cloth, "CLOTH"},
        {cloth_colors, "CLOTH_COLORS"},
        {tabulated, "TABULATED"},
        {uv_per_texture, "UV_PER_TEXTURE"},
        {vertex_color, "VERTEX_COLOR"},
        {light_count_at_run_time, "LIGHT_COUNT_AT_RUN_TIME"},
        {area_textures, "AREA_TEXTURES"},
        {area_lights > 0 && shadow_maps > 0, "AREA_SHADOWS"},
        {area_lights > 0 && is_sampled_by_areas(*this), "AREA_SAMPLED"},
        {position, "POSITION"},
        {visibility, "VISIBILITY"},
        {view, "VIEW"},
        {furnace, "FURNACE"},
        {alpha_mode == AlphaMode::mask, "MASK"},
        {alpha_mode == AlphaMode::blend, "BLEND"},
    };
    for (const auto& [on, name] : switches) {
        if (on) lines += std::string("#define ") + name + "\n";
    }
    return lines;
}

}  // namespace burnish::gpu
