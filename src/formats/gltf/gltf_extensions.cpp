#include "formats/gltf/gltf_extensions.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "burnish/error.hpp"

namespace burnish {
namespace {

constexpr std::string_view kRead[] = {
    "KHR_materials_anisotropy",        "KHR_texture_transform",   "KHR_lights_punctual",
    "KHR_mesh_quantization",           "EXT_meshopt_compression", "KHR_materials_ior",
    "KHR_materials_emissive_strength",
};

struct Loss {
    std::string_view name;
    std::string_view loss;  // empty: no visible loss
};

constexpr Loss kLosses[] = {
    {"KHR_materials_clearcoat", "the coat layer is not drawn"},
    {"KHR_materials_sheen", "the sheen layer is not drawn"},
    {"KHR_materials_transmission", "the surface is drawn opaque"},
    {"KHR_materials_diffuse_transmission", "no light comes through the surface"},
    {"KHR_materials_volume", "the inside does not absorb light"},
    {"KHR_materials_iridescence", "the thin film is not drawn"},
    {"KHR_materials_specular", "strength and tint of the dielectric reflection are left out"},
    {"KHR_materials_dispersion", "colours are not dispersed"},
    {"KHR_materials_unlit", "the surface is lit"},
    {"KHR_materials_variants", "only the default materials are drawn"},
    {"KHR_materials_pbrSpecularGlossiness", "the metallic-roughness values are used instead"},
    {"KHR_draco_mesh_compression", "the uncompressed data are used"},
    {"KHR_texture_basisu", "the textures' PNG or JPEG versions are used"},
    {"EXT_texture_webp", "the textures' PNG or JPEG versions are used"},
    {"EXT_texture_avif", "the textures' PNG or JPEG versions are used"},
    {"MSFT_texture_dds", "the textures' PNG or JPEG versions are used"},
    {"EXT_mesh_gpu_instancing", "each instanced mesh is drawn once"},
    {"EXT_lights_image_based", "the file's own environment is not used"},
    {"KHR_animation_pointer", "nothing moves"},
    {"MSFT_lod", "the finest level is always drawn"},
    {"KHR_xmp_json_ld", ""},
    {"KHR_xmp", ""},
    {"FB_ngon_encoding", ""},
    {"GOOGLE_texture_settings", ""},
};

bool contains(const std::vector<std::string>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

bool is_gltf_extension_read(std::string_view name) {
    return std::find(std::begin(kRead), std::end(kRead), name) != std::end(kRead);
}

void check_gltf_extensions(const std::vector<std::string>& used,
                           const std::vector<std::string>& required, GltfReport& report) {
    for (const std::string& name : required) {
        const bool harmless = std::any_of(std::begin(kLosses), std::end(kLosses), [&](Loss loss) {
            return loss.name == name && loss.loss.empty();
        });
        if (!is_gltf_extension_read(name) && !harmless)
            report.fail("extensionsRequired", "extensions that burnish reads", shown(name));
    }
    for (const std::string& name : used) {
        if (is_gltf_extension_read(name) || contains(required, name)) continue;
        const auto* loss = std::find_if(std::begin(kLosses), std::end(kLosses),
                                        [&](Loss known) { return known.name == name; });
        if (loss == std::end(kLosses))
            report.warn(fmt::format("{}: not read, what it describes is left out", shown(name)));
        else if (!loss->loss.empty())
            report.warn(fmt::format("{}: {}", name, loss->loss));
    }
}

}  // namespace burnish
