#include "viewer/document/taken_back.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "burnish/material_assets.hpp"

namespace burnish::viewer {
namespace {

// In the order in which they decide where several are new.
constexpr std::pair<std::string_view, std::string_view> kReasons[] = {
    {"maps", "a folder of maps is a whole material"},
    {"tabulated", "a measured material has a lobe and details of its own"},
    {"weave", "a weave has normals of its own and is not of metal"},
    {"scratch", "scratches take the place of a normal map, a height map or a weave"},
    {"normal_map", "a normal map takes the place of scratches, a height map or a weave"},
    {"height_map", "a height map takes the place of a normal map, scratches or a weave"},
    {"base_color_map", "the map has colors of its own"},
    {"roughness_map", "the map has roughness of its own"},
    {"glossiness_map", "the map has roughness of its own"},
    {"metallic_map", "the map says where the surface is metal"},
    {"orm_map", "the map has roughness of its own"},
    {"ao_map", "the map has occlusion of its own"},
    {"anisotropy_map", "the map has directions of its own"}};

bool is_new(std::string_view name, const ParameterValues& before, const ParameterValues& after) {
    return names_one(after, name) &&
           (!before.is_set(name) || before.text(name) != after.text(name));
}

// Whether something was set: "none" and its like say nothing that could be missed.
bool says_something(const ParameterValues& values, const Parameter& p) {
    const bool can_be_none = p.kind == ParameterKind::text || p.name == "metal";
    return can_be_none ? names_one(values, p.name) : values.is_set(p.name);
}

std::string list_of(const std::vector<std::string>& words) {
    std::string list;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i > 0) list += i + 1 == words.size() ? " and " : ", ";
        list += words[i];
    }
    return list;
}

}  // namespace

std::string line_of_taken_back(const std::vector<ParameterValues>& before,
                               const std::vector<ParameterValues>& after) {
    std::set<std::string_view> taken;
    const std::pair<std::string_view, std::string_view>* reason = std::end(kReasons);
    for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i) {
        reason = std::min(reason, std::ranges::find_if(kReasons, [&](const auto& row) {
                              return is_new(row.first, before[i], after[i]);
                          }));
        for (const Parameter& p : parameter_table())
            if (says_something(before[i], p) && !after[i].is_set(p.name)) taken.insert(p.name);
    }
    if (taken.empty() || reason == std::end(kReasons)) return "";
    std::vector<std::string> names;
    for (const Parameter& p : parameter_table()) {  // in its order, without what belongs to another
        if (!taken.contains(p.name) || taken.contains(p.belongs_to)) continue;
        names.emplace_back(p.name);
        std::ranges::replace(names.back(), '_', ' ');
    }
    return fmt::format("{} {} taken back: {} (Ctrl+Z brings {} back)", list_of(names),
                       names.size() == 1 ? "was" : "were", reason->second,
                       names.size() == 1 ? "it" : "them");
}

}  // namespace burnish::viewer
