#include "stage/cloth_material.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <glm/trigonometric.hpp>
#include <memory>
#include <string>

#include "burnish/error.hpp"
#include "burnish/f32.hpp"
#include "formats/wif/wif.hpp"
#include "maps/weave/draft.hpp"

namespace burnish {

namespace {

constexpr std::string_view kNumbers[] = {"weave_yarns", "weave_crimp", "weave_bulge", "weave_gap",
                                         "weave_twist", "weave_fuzz",  "warp_color",  "weft_color"};

bool is_draft_name(std::string_view name) {
    const auto names = draft_names();
    return std::find(names.begin(), names.end(), name) != names.end();
}

std::shared_ptr<const Draft> draft_named(const std::string& name,
                                         std::vector<std::string>& warnings) {
    if (is_draft_name(name)) return std::make_shared<Draft>(builtin_draft(name));
    std::error_code error;
    // With a dot or a folder it is meant to be a file.
    const bool file = name.find_first_of("./\\") != std::string::npos;
    if (!file && !std::filesystem::is_regular_file(name, error))
        throw UsageError("weave", "",
                         fmt::format("a .wif file, none, or {}", fmt::join(draft_names(), ", ")),
                         shown(name));
    return std::make_shared<Draft>(load_wif(name, warnings));
}

// What the cloth takes the place of.
void clear_for_cloth(Material& material, const ParameterValues& values) {
    material.normal_texture = {};
    material.anisotropy_texture = {};
    material.metallic_roughness_texture = {};
    if (!values.is_set("metallic") && !values.is_set("metal")) {
        material.metallic = 0.0f;
        material.conductor.reset();
    }
    if (!material.alpha && !values.is_set("roughness") && !values.is_set("anisotropy"))
        material.alpha = kClothAlpha;
}

// A pair of the fibres' own, where roughness and anisotropy were given instead.
// KHR_materials_anisotropy stretches across the grooves; here they run along x.
void set_fibre_pair(Material& material) {
    if (material.alpha) return;
    const f32::vec2 alpha =
        f32::alpha_of_roughness(material.roughness, material.anisotropy_strength);
    material.alpha = glm::vec2(alpha.y, alpha.x);
}

void set_numbers(Cloth& cloth, const ParameterValues& values) {
    const auto set = [&](std::string_view name, float& to) {
        if (values.is_set(name)) to = static_cast<float>(values.real(name));
    };
    set("weave_yarns", cloth.yarns);
    set("weave_crimp", cloth.crimp);
    set("weave_bulge", cloth.bulge);
    set("weave_gap", cloth.gap);
    set("weave_fuzz", cloth.fuzz);
    if (values.is_set("weave_twist"))
        cloth.twist = glm::radians(static_cast<float>(values.real("weave_twist")));
    if (values.is_set("warp_color")) cloth.warp_color = values.vec3("warp_color");
    if (values.is_set("weft_color")) cloth.weft_color = values.vec3("weft_color");
}

}  // namespace

bool is_weave_name(std::string_view name) {
    return name == "none" || is_draft_name(name);
}

void apply_cloth(Scene& scene, std::size_t first, std::size_t count,
                 const ParameterValues& values) {
    if (count == 0) return;
    const bool has_other_detail =
        (values.is_set("normal_map") && values.text("normal_map") != "none") ||
        values.is_set("scratch");
    std::shared_ptr<const Draft> draft;
    if (values.is_set("weave")) {
        if (has_other_detail)
            throw UsageError("weave", "", "a weave, a normal_map or a scratch map", "two of them");
        const std::string name = values.text("weave");
        if (name != "none") draft = draft_named(name, scene.warnings);
    }
    bool any = false, colours_hidden = false;
    for (std::size_t i = first; i < first + count; ++i) {
        Material& material = scene.materials[i];
        if (values.is_set("weave") && !draft) material.cloth.reset();
        if (has_other_detail) material.cloth.reset();
        if (draft) {
            if (!material.cloth) material.cloth.emplace();
            clear_for_cloth(material, values);
            material.cloth->draft = draft;
        }
        if (!material.cloth) continue;
        any = true;
        set_fibre_pair(material);
        set_numbers(*material.cloth, values);
        if (material.conductor && (values.is_set("warp_color") || values.is_set("weft_color")))
            colours_hidden = true;
    }
    if (colours_hidden)
        scene.warnings.push_back(
            "warp_color, weft_color: a measured metal has its own colour: nothing changes");
    if (any) return;
    for (const std::string_view name : kNumbers)
        if (values.is_set(name))
            throw UsageError(std::string(name), "", "a weave beside it", "none");
}

}  // namespace burnish
