#include "viewer/document/value_in_effect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <string>

#include "burnish/conductors.hpp"
#include "burnish/draft.hpp"
#include "burnish/error.hpp"
#include "burnish/f64.hpp"
#include "burnish/material_assets.hpp"
#include "scene/camera/angles.hpp"
#include "scene/material/material_values.hpp"
#include "viewer/document/json_numbers.hpp"

namespace burnish::viewer {
namespace {

using Value = std::optional<ParameterValue>;

Value find_in(const ParameterValues& values, std::string_view name) {
    const auto found = values.set_values().find(name);
    return found == values.set_values().end() ? Value() : found->second;
}

// --- numbers that people read ---------------------------------------------------------------------

// A number that was derived from floats: six digits are what a float keeps.
double six_digits(double number) {
    return std::stod(fmt::format("{:.6g}", number));
}

double degrees_of(float radians) {
    return six_digits(glm::degrees(static_cast<double>(radians)));
}

// A number that went through a float on its way is the decimal that it came from: 0.3, not
// 0.300000012.
ParameterValue readable(const ParameterValue& value) {
    const auto* number = std::get_if<double>(&value);
    if (number == nullptr || static_cast<double>(static_cast<float>(*number)) != *number)
        return value;
    return decimal_of(static_cast<float>(*number));
}

Value color_of(const std::optional<glm::vec3>& color) {
    return color ? Value(*color) : Value();
}

template <typename Enumeration>
Value choice_of(Enumeration value) {
    return ParameterChoice{static_cast<int>(value)};
}

// --- what a material has --------------------------------------------------------------------------

// The pair as glTF has it: roughness squared is the smaller alpha, which lies along the bitangent, or for
// cloth along the fibers. None where the pair is none of glTF's.
Value of_gltf(const Material& m, bool roughness) {
    if (const GltfLobe* lobe = gltf_lobe_of(m))
        return decimal_of(roughness ? lobe->roughness : lobe->anisotropy_strength);
    const auto alpha = stated_alpha(m);
    if (!alpha) return std::nullopt;
    const bool cloth = cloth_of(m) != nullptr;
    const double wide = static_cast<double>(cloth ? alpha->y : alpha->x);
    const double low = static_cast<double>(cloth ? alpha->x : alpha->y);
    if (wide < low || wide > 1) return std::nullopt;
    if (roughness) return six_digits(std::sqrt(low));
    return low < 1 ? six_digits(std::sqrt((wide - low) / (1 - low))) : 0.0;
}

Value of_roughness(const Material& m, std::string_view name) {
    if (tabulated_of(m)) return std::nullopt;
    if (name == "roughness" || name == "anisotropy") return of_gltf(m, name == "roughness");
    const glm::vec2 pair = alpha_of(m);
    if (name == "cosine_exponent")
        return six_digits(f64::cosine_exponent_from_alpha(static_cast<double>(pair.x),
                                                          static_cast<double>(pair.y)));
    const double alpha = static_cast<double>(name.ends_with("_x") ? pair.x : pair.y);
    if (name.starts_with("alpha_")) return six_digits(alpha);
    if (alpha > 1.0) return std::nullopt;  // wider than the exponent 0
    return six_digits(2.0 / (alpha * alpha) - 2.0);
}

Value of_cloth(const Material& m, const Parameter& p) {
    const Cloth* cloth = cloth_of(m);
    if (p.name == "weave") return cloth && cloth->draft ? cloth->draft->name : std::string("none");
    if (cloth == nullptr) return p.default_value;
    if (p.name == "weave_yarns") return decimal_of(cloth->yarns);
    if (p.name == "weave_crimp") return decimal_of(cloth->crimp);
    if (p.name == "weave_bulge") return decimal_of(cloth->bulge);
    if (p.name == "weave_gap") return decimal_of(cloth->gap);
    if (p.name == "weave_fuzz") return decimal_of(cloth->fuzz);
    if (p.name == "weave_twist") return degrees_of(cloth->twist);
    if (p.name == "warp_color") return color_of(cloth->warp_color);
    if (p.name == "weft_color") return color_of(cloth->weft_color);
    return p.default_value;
}

// A texture that the model or a folder brings has no name of a file that the parameter could state. A
// texture that another parameter brings, such as the normals of scratches, is none of this one.
Value of_texture(const Material& m, const Material& base, const ParameterValues& values,
                 std::string_view name) {
    const bool folder = names_one(values, "maps");
    const auto unless_of = [&](const TextureUse& now, const TextureUse& before, bool in_folder) {
        const bool brought = now && (in_folder || now.texture == before.texture);
        return brought ? Value() : Value(std::string("none"));
    };
    const auto unless = [&](TextureUse Material::*use) {
        return unless_of(m.*use, base.*use, folder);
    };
    if (name == "coat_normal_map")
        return unless_of(m.coat.normal_texture, base.coat.normal_texture, false);
    if (name == "normal_map") return unless(&Material::normal_texture);
    if (name == "base_color_map") return unless(&Material::base_color_texture);
    if (name == "roughness_map" || name == "metallic_map")
        return unless(&Material::metallic_roughness_texture);
    if (name == "ao_map") return unless(&Material::occlusion_texture);
    if (name == "anisotropy_map") return unless(&Material::anisotropy_texture);
    if (name == "emissive_map") return unless(&Material::emissive_texture);
    if (name == "tabulated")
        if (const Tabulated* table = tabulated_of(m)) return table->file;
    return std::string("none");
}

Value of_metal(const Material& m, const Parameter& p) {
    if (!m.conductor) return ParameterChoice{0};
    const auto found = std::ranges::find(p.choices, conductor_name(*m.conductor));
    if (found == p.choices.end()) return std::nullopt;
    return ParameterChoice{static_cast<int>(found - p.choices.begin())};
}

// The refractive index of a reflectance; none: infinite.
Value ior_of_f0(float f0) {
    const double root = std::sqrt(static_cast<double>(f0));
    return root < 1.0 ? Value(six_digits((1.0 + root) / (1.0 - root))) : Value();
}

Value of_layers(const Material& m, std::string_view name) {
    if (name == "coat") return decimal_of(m.coat.strength);
    if (name == "coat_roughness") return decimal_of(m.coat.roughness);
    if (name == "coat_tint") return m.coat.tint;
    if (name == "sheen_color") return m.sheen.color;
    if (name == "sheen_roughness") return decimal_of(m.sheen.roughness);
    if (name == "specular") return decimal_of(m.specular);
    if (name == "specular_color") return m.specular_color;
    if (name == "ior") return ior_of_f0(m.dielectric_f0);
    return std::nullopt;
}

Value of_model(const Material& m, const Parameter& p) {
    const std::string_view name = p.name;
    if (const Value layer = of_layers(m, name)) return layer;
    if (name == "mdf") return choice_of(m.mdf);
    if (name == "brdf") return choice_of(m.brdf);
    if (name == "method") return choice_of(m.method);
    if (name == "process") return m.process ? Value(choice_of(*m.process)) : Value();
    if (name == "normal_filter") return choice_of(m.normal_filter);
    if (name == "conserve") return m.conserve;
    if (name == "single_scattering") return m.single_scattering;
    if (name == "ks") return m.ks ? Value(decimal_of(*m.ks)) : Value();
    if (name == "lafortune_c") return m.lafortune_c;
    if (name == "anisotropy_rotation") return degrees_of(m.anisotropy_rotation);
    if (name == "metallic") return decimal_of(m.metallic);
    if (name == "base_color") return glm::vec3(m.base_color);
    if (name == "metal") return of_metal(m, p);
    if (name == "oxide")
        return m.conductor && m.conductor->oxide ? decimal_of(m.conductor->oxide->thickness_nm)
                                                 : p.default_value;
    if (name == "f0") return decimal_of(m.dielectric_f0);
    if (name == "normal_scale") return decimal_of(m.normal_scale);
    if (name == "flip_green") return m.flip_green;
    if (name == "double_sided") return m.double_sided;
    return p.default_value;
}

// The factor between the coordinates of the texture that is drawn and those that the model has, which
// sizes in meters give too.
double uv_scale_of(const Material& drawn, const Material& base, const ParameterValues& values) {
    const bool replaced = std::ranges::any_of(
        std::initializer_list<std::string_view>{"normal_map", "scratch", "maps", "height_map"},
        [&](std::string_view name) { return values.is_set(name); });
    const auto area = [](const glm::mat3& m) {
        return static_cast<double>(std::abs(m[0][0] * m[1][1] - m[0][1] * m[1][0]));
    };
    const double before = replaced ? 1.0 : area(base.normal_texture.transform);
    const double now = area(drawn.normal_texture.transform);
    return before > 0 ? six_digits(std::sqrt(now / before)) : 1.0;
}

Value of_material(const Stage& stage, const Parameter& p, std::size_t index) {
    const ParameterValues& values = stage.materials.values()[index];
    if (const Value set = find_in(values, p.name)) return readable(*set);
    const Material& m = stage.scene.materials[index];
    static constexpr std::string_view kRoughness[] = {
        "alpha_x", "alpha_y", "e_x", "e_y", "cosine_exponent", "roughness", "anisotropy"};
    if (std::ranges::find(kRoughness, p.name) != std::end(kRoughness))
        return of_roughness(m, p.name);
    if (p.name == "uv_scale") return uv_scale_of(m, stage.materials.base()[index], values);
    if (p.name == "weave" || p.belongs_to == "weave") return of_cloth(m, p);
    if (p.kind == ParameterKind::text)
        return of_texture(m, stage.materials.base()[index], values, p.name);
    return of_model(m, p);
}

// --- the picture ----------------------------------------------------------------------------------

Value of_picture(const Stage& stage, const Parameter& p) {
    if (const Value set = find_in(stage.values, p.name)) return set;
    if (p.group != ParameterGroup::camera || stage.scene.instances.empty()) return p.default_value;
    const Camera& camera = stage.camera;
    const glm::dvec3 away = glm::dvec3(camera.position) - glm::dvec3(camera.target);
    if (p.name == "camera_position") return camera.position;
    if (p.name == "camera_target") return camera.target;
    if (p.name == "camera_distance") return six_digits(glm::length(away));
    if (p.name == "camera_azimuth") return six_digits(angles_of(away).azimuth_deg);
    if (p.name == "camera_elevation") return six_digits(angles_of(away).elevation_deg);
    if (p.name == "camera_fov" && !camera.orthographic) return degrees_of(camera.yfov);
    return p.default_value;
}

const Parameter& parameter_named(std::string_view name) {
    if (const Parameter* parameter = find_parameter(name)) return *parameter;
    ParameterValues().set(name, "", "");  // throws, and suggests the nearest name
    throw UsageError(std::string(name));  // not reached
}

}  // namespace

ValueInEffect value_in_effect(const Document& document, const Stage& stage, std::string_view name,
                              std::optional<int> material) {
    const Parameter& p = parameter_named(name);
    ValueInEffect found;
    if (p.group != ParameterGroup::material || stage.scene.materials.empty()) {
        found.set_here = document.values.is_set(name);
        found.value = of_picture(stage, p);
        return found;
    }
    if (material) {
        const auto own = document.material_values.find(*material);
        found.set_here = own != document.material_values.end() && own->second.is_set(name);
        found.value = of_material(stage, p, static_cast<std::size_t>(*material));
        return found;
    }
    found.set_here = document.values.is_set(name);
    found.value = found.set_here ? find_in(document.values, name) : of_material(stage, p, 0);
    return found;
}

bool materials_differ(const Stage& stage, const Parameter& p) {
    if (p.group != ParameterGroup::material || stage.scene.materials.empty()) return false;
    const Value first = of_material(stage, p, 0);
    for (std::size_t i = 1; i < stage.scene.materials.size(); ++i)
        if (of_material(stage, p, i) != first) return true;
    return false;
}

ParameterValue start_value(const Document& document, const Stage& stage, const Parameter& p,
                           std::optional<int> material) {
    if (const Value value = value_in_effect(document, stage, p.name, material).value) return *value;
    if (p.kind == ParameterKind::real && p.group == ParameterGroup::material &&
        !stage.scene.materials.empty()) {
        const Material& m = stage.scene.materials[static_cast<std::size_t>(material.value_or(0))];
        const glm::dvec2 alpha(alpha_of(m));
        // The round lobe of the same area.
        if (p.name == "roughness") return std::min(std::pow(alpha.x * alpha.y, 0.25), 1.0);
        if (p.name == "ks")
            return six_digits(f64::cosine_lobe_unit_ks(
                static_cast<int>(m.brdf), f64::cosine_exponent_from_alpha(alpha.x, alpha.y)));
    }
    switch (p.kind) {
        case ParameterKind::real:
            return std::clamp(p.low > 0 ? std::sqrt(p.low * p.high) : 0.0, p.low, p.high);
        case ParameterKind::integer:
            return static_cast<int>(p.low);
        case ParameterKind::boolean:
            return false;
        case ParameterKind::choice:
            return ParameterChoice{};
        case ParameterKind::color:
            return glm::vec3(0.5f);
        case ParameterKind::vector:
            return glm::vec3(0.0f);
        case ParameterKind::text:
            return std::string();
    }
    return 0.0;
}

}  // namespace burnish::viewer
