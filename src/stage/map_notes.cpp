#include "stage/map_notes.hpp"

#include <fmt/format.h>

#include <initializer_list>
#include <optional>
#include <string_view>

#include "burnish/error.hpp"
#include "stage/map_role.hpp"
#include "stage/material_parameters.hpp"

namespace burnish {
namespace {

std::string_view first_set(const ParameterValues& values,
                           std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names)
        if (values.is_set(name)) return name;
    return "";
}

std::string_view first_named(const ParameterValues& values,
                             std::initializer_list<std::string_view> names) {
    for (const std::string_view name : names)
        if (names_one(values, name)) return name;
    return "";
}

// The parameter that holds in place of a map of the folder; "": the map is drawn. As
// apply_parameters does it (docs/guide/materials.md, values beside maps).
std::string_view in_place_of(MapRole role, const ParameterValues& values) {
    switch (role) {
        case MapRole::base_color:
            return first_named(values, {"tabulated", "metal"});
        case MapRole::opacity:
            return first_named(values, {"tabulated"});
        case MapRole::normal:
        case MapRole::normal_directx:
        case MapRole::height:
            if (const auto detail = first_named(values, {"weave", "scratch"}); !detail.empty())
                return detail;
            return first_set(values, {"normal_map"});
        case MapRole::roughness:
        case MapRole::glossiness:
            if (const auto lobe = first_named(values, {"weave", "tabulated"}); !lobe.empty())
                return lobe;
            return first_set(values, {"alpha_x", "alpha_y", "e_x", "e_y", "cosine_exponent"});
        case MapRole::metallic:
            return first_named(values, {"weave", "tabulated", "metal"});
        case MapRole::anisotropy:
            if (const auto lobe = first_named(values, {"weave", "tabulated"}); !lobe.empty())
                return lobe;
            return follows_scratches(values) ? "scratch_direction" : "";
        default:
            return "";
    }
}

std::optional<MapRole> role_named(std::string_view name) {
    for (std::size_t i = 0; i < kMapRoles; ++i)
        if (map_role_name(static_cast<MapRole>(i)) == name) return static_cast<MapRole>(i);
    return std::nullopt;
}

// The channels of a map of several properties that parameters take the place of:
// "roughness (alpha_x holds)".
std::string replaced_channels(MapRole role, const ParameterValues& values) {
    std::string out;
    const auto add = [&](std::string_view channel, std::string_view parameter) {
        if (!parameter.empty())
            out += fmt::format("{}{}: {} holds", out.empty() ? "" : "; ", channel, parameter);
    };
    const auto single = [&](MapRole channel, std::initializer_list<std::string_view> maps) {
        const std::string_view map = first_named(values, maps);
        return map.empty() ? in_place_of(channel, values) : map;
    };
    const MapPacking packing = *packing_of(role);
    if (packing.occlusion >= 0) add("occlusion", first_named(values, {"ao_map"}));
    if (packing.roughness >= 0 || packing.smoothness >= 0)
        add("roughness", single(MapRole::roughness, {"glossiness_map", "roughness_map"}));
    if (packing.metallic >= 0) add("metallic", single(MapRole::metallic, {"metallic_map"}));
    return out;
}

}  // namespace

std::string warning_of_idle_flip(const ParameterValues& values, const MapTextures& maps) {
    const bool drawn = maps.directx && in_place_of(MapRole::normal_directx, values).empty();
    if (!drawn || !values.is_set("flip_green") || !values.boolean("flip_green")) return "";
    return "flip_green: the folder's normal map is drawn as DirectX for its name already "
           "(--flip-green=false draws it as OpenGL): nothing changes";
}

std::vector<std::string> map_notes(const ParameterValues& values, const MapTextures& maps) {
    if (!names_one(values, "maps")) return {};
    std::string taken, replaced;
    for (const auto& [name, file] : maps.files) {
        const MapRole role = role_named(name).value();
        const std::string channels = packing_of(role) ? replaced_channels(role, values) : "";
        const std::string_view other = in_place_of(role, values);
        const std::string entry = fmt::format("{} {}", name, one_line(file));
        if (!other.empty())
            replaced += fmt::format("{}{} ({} holds)", replaced.empty() ? "" : ", ", entry, other);
        else
            taken += fmt::format("{}{}{}", taken.empty() ? "" : ", ", entry,
                                 channels.empty() ? "" : fmt::format(" ({})", channels));
    }
    std::vector<std::string> notes = maps.notes;
    const std::string folder = one_line(values.text("maps"));
    if (!taken.empty()) notes.push_back(fmt::format("maps of {}: {}", folder, taken));
    if (!replaced.empty())
        notes.push_back(fmt::format("maps of {}, not drawn: {}", folder, replaced));
    return notes;
}

}  // namespace burnish
