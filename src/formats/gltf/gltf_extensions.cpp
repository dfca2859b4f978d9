#include "formats/gltf/gltf_extensions.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "burnish/error.hpp"

namespace burnish {
namespace {

using enum GltfSupport;

constexpr GltfExtension kExtensions[] = {
    {"KHR_draco_mesh_compression"},
    {"KHR_lights_punctual"},
    {"KHR_materials_anisotropy"},
    {"KHR_materials_clearcoat"},
    {"KHR_materials_emissive_strength"},
    {"KHR_materials_ior"},
    {"KHR_materials_sheen"},
    {"KHR_materials_specular"},
    {"KHR_mesh_quantization"},
    {"KHR_texture_transform"},
    {"EXT_mesh_gpu_instancing"},
    {"EXT_meshopt_compression"},
    {"EXT_texture_avif"},
    {"EXT_texture_webp"},
    {"KHR_materials_unlit", approximated,
     "the surface emits its base color and reflects nothing; exposure and tone map change it"},
    {"KHR_animation_pointer", ignored, "nothing moves"},
    {"KHR_materials_diffuse_transmission", ignored, "no light comes through the surface"},
    {"KHR_materials_dispersion", ignored, "colors are not dispersed"},
    {"KHR_materials_iridescence", ignored, "the thin film is not drawn"},
    {"KHR_materials_pbrSpecularGlossiness", ignored,
     "the metallic-roughness values are used instead",
     "gltf-transform metalrough IN.glb OUT.glb converts the file"},
    {"KHR_materials_transmission", ignored, "the surface is drawn opaque"},
    {"KHR_materials_variants", ignored, "only the default materials are drawn"},
    {"KHR_materials_volume", ignored, "the inside does not absorb light"},
    {"KHR_texture_basisu", ignored, "a PNG or JPEG version is used where the texture has one",
     "gltf-transform ktxdecompress IN.glb OUT.glb makes PNG of KTX2", true},
    {"EXT_lights_image_based", ignored, "the file's own environment is not used",
     "--env names another"},
    {"MSFT_lod", ignored, "the finest level is always drawn"},
    {"MSFT_texture_dds", ignored, "a PNG or JPEG version is used where the texture has one",
     "convert the DDS files to PNG", true},
    {"KHR_xmp", harmless},
    {"KHR_xmp_json_ld", harmless},
    {"FB_ngon_encoding", harmless},
    {"GOOGLE_texture_settings", harmless},
};

const GltfExtension* known(std::string_view name) {
    const auto* found = std::find_if(std::begin(kExtensions), std::end(kExtensions),
                                     [&](const GltfExtension& one) { return one.name == name; });
    return found == std::end(kExtensions) ? nullptr : found;
}

bool contains(const std::vector<std::string>& names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

std::span<const GltfExtension> gltf_extensions() {
    return kExtensions;
}

bool is_gltf_extension_read(std::string_view name) {
    const GltfExtension* one = known(name);
    return one != nullptr &&
           (one->support == drawn || one->support == approximated || one->of_textures);
}

std::string_view gltf_extension_remedy(std::string_view name) {
    const GltfExtension* one = known(name);
    return one == nullptr ? std::string_view() : one->remedy;
}

void check_gltf_extensions(const std::vector<std::string>& used,
                           const std::vector<std::string>& required, GltfReport& report) {
    for (const std::string& name : required) {
        const GltfExtension* one = known(name);
        if (one != nullptr && one->support != ignored) continue;
        const std::string_view remedy = gltf_extension_remedy(name);
        report.fail("extensionsRequired", "extensions that burnish reads",
                    remedy.empty() ? shown(name) : fmt::format("{}; {}", shown(name), remedy));
    }
    for (const std::string& name : used) {
        const GltfExtension* one = known(name);
        if (contains(required, name)) continue;
        if (one == nullptr)
            report.warn(fmt::format("{}: not read, what it describes is left out", shown(name)));
        else if (one->support == ignored && !one->of_textures)
            report.warn(fmt::format("{}: {}{}{}", name, one->effect,
                                    one->remedy.empty() ? "" : "; ", one->remedy));
    }
}

}  // namespace burnish
