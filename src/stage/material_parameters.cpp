#include "stage/material_parameters.hpp"

#include <fmt/format.h>

#include <cmath>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <utility>

#include "burnish/conductors.hpp"
#include "burnish/error.hpp"
#include "burnish/f32.hpp"
#include "burnish/f64.hpp"
#include "stage/map_textures.hpp"

namespace burnish {

bool follows_scratches(const ParameterValues& values) {
    return values.is_set("scratch") &&
           static_cast<ScratchDirection>(values.choice("scratch_direction")) ==
               ScratchDirection::follow;
}

namespace {

float real_of(const ParameterValues& values, std::string_view name) {
    return static_cast<float>(values.real(name));
}

bool sets_gltf_roughness(const ParameterValues& values) {
    return values.is_set("roughness") || values.is_set("anisotropy");
}

void require_consistent(const ParameterValues& values) {
    require_one_roughness(values, false);
    if (values.is_set("scratch") && values.is_set("normal_map"))
        throw UsageError("scratch", "", "a scratch map or a normal_map, not both", "both");
    const bool weave = names_one(values, "weave"), scratch = values.is_set("scratch");
    if (values.is_set("ior") && values.is_set("f0"))
        throw UsageError("ior", "", "an ior or an f0, which says the same, not both", "both");
    if (names_one(values, "roughness_map") && names_one(values, "glossiness_map"))
        throw UsageError("glossiness_map", "", "no roughness_map beside it", "both");
    if (names_one(values, "height_map") && (weave || scratch || names_one(values, "normal_map")))
        throw UsageError("height_map", "", "no normal_map, scratch map or weave beside it", "both");
    if (weave && (scratch || names_one(values, "normal_map")))
        throw UsageError("weave", "", "a weave, a normal_map or a scratch map", "two of them");
    if (names_one(values, "tabulated") && (weave || scratch))
        throw UsageError("tabulated", "", "no weave or scratch map beside it", "both");
}

void apply_model(Material& material, const ParameterValues& values) {
    if (values.is_set("mdf")) material.mdf = static_cast<Mdf>(values.choice("mdf"));
    if (values.is_set("brdf")) material.brdf = static_cast<Brdf>(values.choice("brdf"));
    if (values.is_set("process")) {
        material.process = static_cast<Process>(values.choice("process"));
        material.method = method_of(*material.process);
    }
    if (values.is_set("method")) material.method = static_cast<Method>(values.choice("method"));
    if (values.is_set("conserve")) material.conserve = values.boolean("conserve");
    if (values.is_set("single_scattering"))
        material.single_scattering = values.boolean("single_scattering");
    if (values.is_set("ks")) material.ks = real_of(values, "ks");
    if (values.is_set("lafortune_c")) material.lafortune_c = values.vec3("lafortune_c");
    if (values.is_set("anisotropy_rotation"))
        material.anisotropy_rotation = glm::radians(real_of(values, "anisotropy_rotation"));
    if (values.is_set("double_sided")) material.double_sided = values.boolean("double_sided");
}

// A metal without a name, from the extras of a glTF, has no measured oxide.
void apply_oxide(Material& material, float thickness_nm) {
    if (!material.conductor) return;
    material.conductor->oxide.reset();
    if (thickness_nm <= 0.0f) return;
    const std::string_view metal = conductor_name(*material.conductor);
    if (metal.empty())
        throw UsageError("oxide", "", "one of the metals of --metal", "a metal of the model's own");
    material.conductor->oxide = oxide_film(metal, thickness_nm);
}

void apply_color(Material& material, const ParameterValues& values) {
    if (values.is_set("base_color"))
        material.base_color = glm::vec4(values.vec3("base_color"), material.base_color.a);
    if (values.is_set("metallic")) material.metallic = real_of(values, "metallic");
    if (values.is_set("f0")) material.dielectric_f0 = real_of(values, "f0");
    if (values.is_set("ior")) {
        const double n = values.real("ior"), root = (n - 1.0) / (n + 1.0);
        material.dielectric_f0 = static_cast<float>(root * root);
    }
    if (values.is_set("specular")) material.specular = real_of(values, "specular");
    if (values.is_set("specular_color")) material.specular_color = values.vec3("specular_color");
    if (values.is_set("metal")) {
        material.conductor.reset();
        if (names_one(values, "metal")) {
            material.conductor = conductor_preset(values.text("metal"));
            if (!values.is_set("metallic")) material.metallic = 1.0f;
        }
    }
    if (values.is_set("oxide")) apply_oxide(material, real_of(values, "oxide"));
}

// --- sets of maps -------------------------------------------------------------------------------

TextureUse use_of(int texture) {
    TextureUse use;
    use.texture = texture;
    return use;
}

// Maps hold absolute values, so that their factors become 1; parameters set beside them multiply.
void apply_map_colors(Material& material, const MapTextures& maps) {
    if (maps.base_color >= 0) {
        material.base_color = glm::vec4(1.0f);
        material.base_color_texture = use_of(maps.base_color);
        material.conductor.reset();
        if (maps.has_opacity && material.alpha_mode == AlphaMode::opaque)
            material.alpha_mode = AlphaMode::mask;
    }
    if (maps.occlusion >= 0) {
        material.occlusion_texture = use_of(maps.occlusion);
        material.occlusion_strength = 1.0f;
    }
    if (maps.emissive >= 0) {
        material.emissive_texture = use_of(maps.emissive);
        material.emissive = glm::vec3(1.0f);
    }
}

void apply_map_lobe(Material& material, const MapTextures& maps) {
    if (maps.metallic_roughness < 0 && maps.anisotropy < 0 && !maps.whole) return;
    const GltfLobe* stated = gltf_lobe_of(material);
    GltfLobe lobe = stated ? *stated : GltfLobe{};
    if (maps.whole) {
        material.anisotropy_texture = material.metallic_roughness_texture = TextureUse{};
        lobe = GltfLobe{};
        if (!maps.has_metallic) material.metallic = 0.0f;
    }
    if (maps.metallic_roughness >= 0)
        material.metallic_roughness_texture = use_of(maps.metallic_roughness);
    if (maps.has_roughness) lobe.roughness = 1.0f;
    if (maps.has_metallic) material.metallic = 1.0f;
    if (maps.anisotropy >= 0) {
        material.anisotropy_texture = use_of(maps.anisotropy);
        material.anisotropy_rotation = 0.0f;
        lobe.anisotropy_strength = 1.0f;
    }
    material.lobe = lobe;
}

void apply_maps(Material& material, const ParameterValues& values, const MaterialAssets& assets) {
    if (!names_maps(values)) return;
    const MapTextures maps = assets.maps(values);
    apply_map_colors(material, maps);
    apply_map_lobe(material, maps);
    if (maps.normal < 0 && !maps.whole) return;
    material.normal_texture = use_of(maps.normal);
    material.normal_scale = 1.0f;
    material.flip_green = maps.directx;
}

// --- the lobe -----------------------------------------------------------------------------------

// The lobe of the base material, without the cloth or the table that the values remove.
MaterialLobe kept_lobe(const Material& base, const ParameterValues& values) {
    const bool weave = names_one(values, "weave"), scratch = values.is_set("scratch");
    if (const Cloth* cloth = cloth_of(base)) {
        const bool replaced = scratch || names_one(values, "normal_map");
        if (replaced || (values.is_set("weave") && !weave)) return AlphaLobe{cloth->alpha};
    }
    if (tabulated_of(base) && (values.is_set("tabulated") || weave || scratch)) return GltfLobe{};
    return base.lobe;
}

// Fibers run along x, where KHR_materials_anisotropy stretches across the grooves.
glm::vec2 fiber_alpha(const GltfLobe& lobe) {
    const f32::vec2 alpha = f32::alpha_of_roughness(lobe.roughness, lobe.anisotropy_strength);
    return {alpha.y, alpha.x};
}

void apply_roughness(Material& material, const ParameterValues& values) {
    if (tabulated_of(material)) return;
    Cloth* cloth = std::get_if<Cloth>(&material.lobe);
    if (const auto pair = roughness_pair(values, stated_alpha(material))) {
        if (cloth) {
            cloth->alpha = *pair;
        } else {
            material.lobe = AlphaLobe{*pair};
        }
        return;
    }
    if (!sets_gltf_roughness(values)) return;
    const GltfLobe* stated = gltf_lobe_of(material);
    GltfLobe lobe = stated ? *stated : GltfLobe{};
    if (values.is_set("roughness")) lobe.roughness = real_of(values, "roughness");
    if (values.is_set("anisotropy")) lobe.anisotropy_strength = real_of(values, "anisotropy");
    if (cloth) {
        cloth->alpha = fiber_alpha(lobe);
    } else {
        material.lobe = lobe;
    }
}

void apply_cloth_numbers(Cloth& cloth, const ParameterValues& values) {
    static constexpr std::pair<std::string_view, float Cloth::*> kNumbers[] = {
        {"weave_yarns", &Cloth::yarns},
        {"weave_crimp", &Cloth::crimp},
        {"weave_bulge", &Cloth::bulge},
        {"weave_gap", &Cloth::gap},
        {"weave_fuzz", &Cloth::fuzz}};
    for (const auto& [name, member] : kNumbers)
        if (values.is_set(name)) cloth.*member = real_of(values, name);
    if (values.is_set("weave_twist")) cloth.twist = glm::radians(real_of(values, "weave_twist"));
    if (values.is_set("warp_color")) cloth.warp_color = values.vec3("warp_color");
    if (values.is_set("weft_color")) cloth.weft_color = values.vec3("weft_color");
}

// A new cloth is not metallic and its fibers have the alpha of Cloth, unless the values or a
// roughness pair of the material override them.
void apply_weave(Material& material, const ParameterValues& values, const MaterialAssets& assets) {
    if (names_one(values, "weave")) {
        const Cloth* before = cloth_of(material);
        Cloth cloth = before ? *before : Cloth{};
        cloth.draft = assets.draft(values.text("weave"));
        const GltfLobe* gltf = gltf_lobe_of(material);
        if (const auto alpha = stated_alpha(material)) cloth.alpha = *alpha;
        if (gltf && sets_gltf_roughness(values)) cloth.alpha = fiber_alpha(*gltf);
        material.lobe = cloth;
        if (!values.is_set("metallic") && !values.is_set("metal")) {
            material.metallic = 0.0f;
            material.conductor.reset();
        }
    }
    if (Cloth* cloth = std::get_if<Cloth>(&material.lobe)) apply_cloth_numbers(*cloth, values);
}

// --- normal maps and scratch maps ---------------------------------------------------------------

// The anisotropy map stores the direction of stretch, across the groove. The material's grooves run
// along its smaller alpha, so the map is rotated by 90 degrees when that is alpha_x.
void follow_grooves(Material& material, const ParameterValues& values, int texture) {
    material.anisotropy_texture = TextureUse{};
    material.anisotropy_texture.texture = texture;
    const float rotation = values.is_set("anisotropy_rotation")
                               ? glm::radians(real_of(values, "anisotropy_rotation"))
                               : 0.0f;
    const auto* lobe = std::get_if<AlphaLobe>(&material.lobe);
    const bool along_x = lobe && lobe->alpha.x < lobe->alpha.y;
    material.anisotropy_rotation = rotation + (along_x ? 0.5f * std::numbers::pi_v<float> : 0.0f);
}

void apply_detail(Material& material, const ParameterValues& values, const MaterialAssets& assets) {
    const bool normal_map = values.is_set("normal_map"), scratch = values.is_set("scratch");
    if (normal_map || scratch) {
        const MaterialAssets::ScratchMaps maps =
            scratch ? assets.scratch(values.text("scratch")) : MaterialAssets::ScratchMaps{};
        material.normal_texture = TextureUse{};
        material.normal_texture.texture =
            scratch ? maps.normal : assets.normal_map(values.text("normal_map"));
        material.normal_scale = 1.0f;
        material.flip_green = false;
        if (follows_scratches(values)) follow_grooves(material, values, maps.anisotropy);
    }
    if (values.is_set("normal_scale")) material.normal_scale = real_of(values, "normal_scale");
    if (values.is_set("flip_green")) material.flip_green = values.boolean("flip_green");
    if (values.is_set("normal_filter"))
        material.normal_filter = static_cast<NormalFilter>(values.choice("normal_filter"));
    if (!values.is_set("uv_scale")) return;
    const float s = real_of(values, "uv_scale");
    const glm::mat3 scale(s, 0.0f, 0.0f, 0.0f, s, 0.0f, 0.0f, 0.0f, 1.0f);
    material.normal_texture.transform = scale * material.normal_texture.transform;
    if (follows_scratches(values))
        material.anisotropy_texture.transform = material.normal_texture.transform;
    if (!names_maps(values)) return;
    // A set of maps is scaled as a whole.
    const MapTextures maps = assets.maps(values);
    for (TextureUse* use :
         {&material.base_color_texture, &material.metallic_roughness_texture,
          &material.occlusion_texture, &material.anisotropy_texture, &material.emissive_texture})
        for (const int index : {maps.base_color, maps.metallic_roughness, maps.occlusion,
                                maps.anisotropy, maps.emissive})
            if (*use && use->texture == index && use->transform == glm::mat3(1.0f))
                use->transform = scale;
}

// --- layers -------------------------------------------------------------------------------------

void apply_layers(Material& material, const ParameterValues& values, const MaterialAssets& assets) {
    Coat& coat = material.coat;
    if (values.is_set("coat")) coat.strength = real_of(values, "coat");
    if (values.is_set("coat_roughness")) coat.roughness = real_of(values, "coat_roughness");
    if (values.is_set("coat_tint")) coat.tint = values.vec3("coat_tint");
    if (values.is_set("coat_normal_map")) {
        coat.normal_texture = use_of(assets.normal_map(values.text("coat_normal_map")));
        coat.normal_scale = 1.0f;
        coat.flip_green = false;
        if (values.is_set("uv_scale")) {
            const float s = real_of(values, "uv_scale");
            coat.normal_texture.transform = glm::mat3(s, 0, 0, 0, s, 0, 0, 0, 1);
        }
    }
    if (values.is_set("sheen_color")) material.sheen.color = values.vec3("sheen_color");
    if (values.is_set("sheen_roughness"))
        material.sheen.roughness = real_of(values, "sheen_roughness");
}

}  // namespace

std::optional<glm::vec2> roughness_pair(const ParameterValues& values,
                                        const std::optional<glm::vec2>& base) {
    const auto pair_of = [&](std::string_view x, std::string_view y, auto alpha_of) {
        const bool has_x = values.is_set(x), has_y = values.is_set(y);
        glm::vec2 pair = base.value_or(glm::vec2(0.0f));
        if (has_x) pair.x = static_cast<float>(alpha_of(values.real(x)));
        if (has_y) pair.y = static_cast<float>(alpha_of(values.real(y)));
        if (!base && !has_y) pair.y = pair.x;
        if (!base && !has_x) pair.x = pair.y;
        return pair;
    };
    if (values.is_set("cosine_exponent"))
        return glm::vec2(
            static_cast<float>(f64::alpha_from_cosine_exponent(values.real("cosine_exponent"))));
    if (values.is_set("alpha_x") || values.is_set("alpha_y"))
        return pair_of("alpha_x", "alpha_y", [](double alpha) { return alpha; });
    if (values.is_set("e_x") || values.is_set("e_y"))
        return pair_of("e_x", "e_y", [](double e) { return std::sqrt(2.0 / (e + 2.0)); });
    return std::nullopt;
}

void require_drawable(const Material& material, Method method) {
    const Brdf brdf = drawn_material(material).brdf;
    if (f32::brdf_takes_method(static_cast<int>(brdf), static_cast<int>(method))) return;
    const bool named = material.process && method_of(*material.process) == method;
    const std::string found =
        named ? fmt::format("{} (of process {})", name_of(method), name_of(*material.process))
              : std::string(name_of(method));
    throw UsageError("method", "",
                     fmt::format("a rotation such as follow-grain for brdf {}, which has no half "
                                 "vectors to {}",
                                 name_of(brdf), is_deformation(method) ? "deform" : "move"),
                     found);
}

Material apply_parameters(const Material& base, const ParameterValues& values,
                          const MaterialAssets& assets) {
    require_consistent(values);
    Material material = base;
    material.lobe = kept_lobe(base, values);
    apply_maps(material, values, assets);
    apply_model(material, values);
    apply_color(material, values);
    apply_roughness(material, values);
    apply_detail(material, values, assets);
    apply_layers(material, values, assets);
    apply_weave(material, values, assets);
    if (names_one(values, "tabulated")) {
        const std::string file = values.text("tabulated");
        material.lobe = Tabulated{assets.tabulated(file), file};
    }
    require_drawable(material, material.method);
    return material;
}

}  // namespace burnish
