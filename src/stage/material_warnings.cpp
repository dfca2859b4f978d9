#include "stage/material_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "burnish/draft.hpp"
#include "burnish/error.hpp"
#include "burnish/f32.hpp"
#include "burnish/material_assets.hpp"
#include "core/text.hpp"
#include "stage/map_textures.hpp"
#include "stage/material_parameters.hpp"

namespace burnish {
namespace {

// Parameters that a tabulated material supplies itself.
constexpr std::string_view kHidden[] = {"mdf",
                                        "brdf",
                                        "alpha_x",
                                        "alpha_y",
                                        "e_x",
                                        "e_y",
                                        "cosine_exponent",
                                        "roughness",
                                        "anisotropy",
                                        "ks",
                                        "lafortune_c",
                                        "metallic",
                                        "base_color",
                                        "metal",
                                        "oxide",
                                        "f0",
                                        "ior",
                                        "specular",
                                        "specular_color",
                                        "base_color_map",
                                        "roughness_map",
                                        "glossiness_map",
                                        "metallic_map",
                                        "anisotropy_map"};

// Whether the lobe looks the same however it is turned.
bool is_round(const Material& m) {
    if (tabulated_of(m)) return false;
    if (m.brdf == Brdf::phong) return true;
    if (m.brdf == Brdf::lafortune) return m.lafortune_c.x == m.lafortune_c.y;
    if (const GltfLobe* lobe = gltf_lobe_of(m)) return lobe->anisotropy_strength == 0.0f;
    const std::optional<glm::vec2> alpha = stated_alpha(m);
    return alpha && alpha->x == alpha->y;
}

bool bends_normals(const Material& m) {
    return m.normal_texture || cloth_of(m) || tabulated_of(m);
}

// Whether every yarn has a color of its own.
bool colors_its_yarns(const Cloth& cloth) {
    return (cloth.warp_color || !cloth.draft->warp_colors.empty()) &&
           (cloth.weft_color || !cloth.draft->weft_colors.empty());
}

// Whether `name` is set on some material, but on none for which `uses` is true.
template <typename Uses>
bool is_idle(const std::vector<Material>& materials, const std::vector<ParameterValues>& values,
             std::string_view name, Uses uses) {
    bool any = false;
    for (std::size_t i = 0; i < materials.size(); ++i) {
        if (!values[i].is_set(name)) continue;
        if (uses(materials[i], values[i])) return false;
        any = true;
    }
    return any;
}

// What a measured metal and the metalness 1 leave without effect.
template <typename Warn>
void append_idle_of_metals(const Warn& warn_if_idle) {
    using Values = const ParameterValues&;
    const auto no_conductor = [](const Material& m, Values) { return !m.conductor; };
    const std::string_view own = "a measured metal (--metal) has its own color";
    warn_if_idle("base_color", own, no_conductor);
    warn_if_idle("base_color_map", own, [](const Material& m, Values) {
        return !m.conductor || m.alpha_mode != AlphaMode::opaque;
    });
    warn_if_idle("metallic_map", "a measured metal (--metal) is metallic", no_conductor);
    warn_if_idle("oxide", "only a measured metal (--metal) has one",
                 [](const Material& m, Values) { return m.conductor.has_value(); });
    for (const std::string_view name : {"f0", "ior", "specular", "specular_color"})
        warn_if_idle(name, "a metal has its reflectance from its color",
                     [](const Material& m, Values) {
                         return !m.conductor && (m.metallic < 1.0f || m.metallic_roughness_texture);
                     });
}

// What a layer that is not there leaves without effect.
template <typename Warn>
void append_idle_of_layers(const Warn& warn_if_idle) {
    using Values = const ParameterValues&;
    for (const std::string_view name : {"coat_roughness", "coat_tint", "coat_normal_map"})
        warn_if_idle(name, "there is no coat (--coat 1)",
                     [](const Material& m, Values) { return has_coat(m); });
    warn_if_idle("sheen_roughness", "there is no sheen (--sheen-color)",
                 [](const Material& m, Values) { return has_sheen(m); });
}

template <typename Warn>
void append_idle_of_cloth(const Warn& warn_if_idle) {
    using Values = const ParameterValues&;
    const auto is_cloth = [](const Material& m, Values) { return cloth_of(m) != nullptr; };
    const auto is_no_cloth = [](const Material& m, Values) { return cloth_of(m) == nullptr; };
    for (const Parameter& parameter : parameter_table())
        if (parameter.belongs_to == "weave")
            warn_if_idle(parameter.name, "there is no weave", is_cloth);
    for (const std::string_view map :
         {"roughness_map", "glossiness_map", "metallic_map", "anisotropy_map"})
        warn_if_idle(map, "the yarns of a weave have a lobe of their own", is_no_cloth);
    warn_if_idle("base_color", "the yarns have colors of their own (--warp-color, --weft-color)",
                 [](const Material& m, Values) {
                     const Cloth* cloth = cloth_of(m);
                     return !cloth || m.conductor || !colors_its_yarns(*cloth);
                 });
}

void append_idle(const Scene& scene, const std::vector<ParameterValues>& values,
                 std::vector<std::string>& warnings) {
    const auto warn_if_idle = [&](std::string_view name, std::string_view line, auto uses) {
        if (is_idle(scene.materials, values, name, uses))
            append_once(warnings, fmt::format("{}: {}: nothing changes", name, line));
    };
    using Values = const ParameterValues&;
    warn_if_idle("ks", "only phong or lafortune asks for it",
                 [](const Material& m, Values) { return !has_half_vectors(m.brdf); });
    warn_if_idle("lafortune_c", "only lafortune asks for it",
                 [](const Material& m, Values) { return m.brdf == Brdf::lafortune; });
    warn_if_idle("mdf", "the reflection model has a distribution of its own",
                 [](const Material& m, Values) {
                     const int brdf = static_cast<int>(m.brdf);
                     return f32::brdf_mdf(brdf, static_cast<int>(Mdf::ggx)) !=
                            f32::brdf_mdf(brdf, static_cast<int>(Mdf::beckmann));
                 });
    warn_if_idle("conserve", "only the deform methods ask for it",
                 [](const Material& m, Values) { return is_deformation(m.method); });
    warn_if_idle("single_scattering", "only microfacet and microfacet-separable have another form",
                 [](const Material& m, Values) {
                     Material compensated = m;
                     compensated.single_scattering = false;
                     return is_compensated(compensated);
                 });
    for (const std::string_view name : {"method", "process"})
        warn_if_idle(name, "there is no normal map",
                     [](const Material& m, Values) { return bends_normals(m); });
    warn_if_idle("anisotropy_rotation", "the lobe is isotropic",
                 [](const Material& m, Values) { return !is_round(m); });
    for (const std::string_view name :
         {"roughness", "anisotropy", "roughness_map", "glossiness_map", "orm_map"})
        warn_if_idle(name, "the pair set beside it holds",
                     [](const Material&, Values v) { return !roughness_pair(v, std::nullopt); });
    const auto has_normals = [](const Material& m, Values) {
        return static_cast<bool>(m.normal_texture) && cloth_of(m) == nullptr;
    };
    for (const std::string_view name : {"normal_scale", "flip_green", "normal_filter"})
        warn_if_idle(name, "there is no normal map", has_normals);
    warn_if_idle(
        "metallic", "a measured metal (--metal) is metallic",
        [](const Material& m, Values v) { return !m.conductor || v.real("metallic") == 1.0; });
    append_idle_of_metals(warn_if_idle);
    warn_if_idle("height_scale", "there is no height_map", [](const Material&, Values v) {
        return names_one(v, "height_map") || names_one(v, "maps");
    });
    const auto has_maps = [](const Material&, Values v) {
        return names_maps(v) || names_one(v, "normal_map");
    };
    warn_if_idle("maps_tile_mm", "there are no maps", has_maps);
    warn_if_idle("physical_size",
                 "there are no scratches, maps or measured material (a weave takes "
                 "weave_yarns_per_cm)",
                 [&](const Material& m, Values v) {
                     return has_maps(m, v) || v.is_set("scratch") || names_one(v, "tabulated");
                 });
    warn_if_idle("scratch_direction", "there is no scratch map",
                 [](const Material&, Values v) { return v.is_set("scratch"); });
    warn_if_idle("scratch_direction", "the lobe is isotropic",
                 [](const Material& m, Values v) { return !follows_scratches(v) || !is_round(m); });
    warn_if_idle("uv_scale", "there are no maps (a weave takes weave_yarns)",
                 [](const Material& m, Values v) {
                     return names_maps(v) || tabulated_of(m) || (m.normal_texture && !cloth_of(m));
                 });
    append_idle_of_cloth(warn_if_idle);
    append_idle_of_layers(warn_if_idle);
}

void append_hidden(const Scene& scene, const std::vector<ParameterValues>& values,
                   std::vector<std::string>& warnings) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        const Material& material = scene.materials[i];
        const ParameterValues& set = values[i];
        if (cloth_of(material) && material.conductor &&
            (set.is_set("warp_color") || set.is_set("weft_color")))
            append_once(warnings,
                        "warp_color, weft_color: a measured metal has its own color: nothing "
                        "changes");
        const Cloth* cloth = cloth_of(material);
        if (cloth && material.conductor && set.is_set("metal") &&
            !(cloth->draft->warp_colors.empty() && cloth->draft->weft_colors.empty()))
            append_once(warnings,
                        "metal: every yarn is of this metal: the colors of the draft are not drawn "
                        "(--metal none draws them)");
        if (!tabulated_of(material)) continue;
        std::vector<std::string_view> hidden;
        for (const std::string_view name : kHidden)
            if (set.is_set(name)) hidden.push_back(name);
        if (hidden.empty()) continue;
        append_once(warnings, fmt::format("{}: a tabulated material has a lobe and colors of its "
                                          "own: nothing changes",
                                          fmt::join(hidden, ", ")));
    }
}

void append_other_methods(const Scene& scene, std::vector<std::string>& warnings) {
    for (const Material& m : scene.materials) {
        if (!m.process || m.method == method_of(*m.process)) continue;
        append_once(
            warnings,
            fmt::format("process: {} asks for method {}, but method {} is stated: {} is "
                        "drawn (leave the method out for {})",
                        name_of(*m.process), name_of(method_of(*m.process)), name_of(m.method),
                        name_of(m.method), name_of(method_of(*m.process))));
    }
}

void append_missing_coordinates(const Scene& scene, const std::vector<ParameterValues>& values,
                                std::vector<std::string>& warnings) {
    for (const Instance& instance : scene.instances) {
        if (instance.mesh < 0) continue;
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        const auto index = static_cast<std::size_t>(instance.material);
        const ParameterValues& set = values[index];
        const bool asks = names_one(set, "normal_map") || set.is_set("scratch") ||
                          names_one(set, "weave") || names_one(set, "tabulated");
        if (!asks || !mesh.texcoord0.empty()) continue;
        const Material& m = scene.materials[index];
        const char* detail = cloth_of(m)       ? "weave"
                             : tabulated_of(m) ? "tabulated material"
                                               : "normal map";
        append_once(warnings,
                    fmt::format("mesh {} has no texture coordinates: the {} does not show",
                                shown(mesh.name), detail));
    }
}

}  // namespace

void append_warnings(const Scene& scene, const std::vector<ParameterValues>& values,
                     std::vector<std::string>& warnings) {
    append_idle(scene, values, warnings);
    append_other_methods(scene, warnings);
    append_missing_coordinates(scene, values, warnings);
    append_hidden(scene, values, warnings);
}

}  // namespace burnish
