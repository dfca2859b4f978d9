#include "burnish/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "burnish/error.hpp"
#include "burnish/shading_names.hpp"
#include "core/text.hpp"
#include "scene/parameters/parameter_text.hpp"

namespace burnish {

const Parameter* find_parameter(std::string_view name) {
    for (const Parameter& parameter : parameter_table())
        if (parameter.name == name) return &parameter;
    return nullptr;
}

std::string flag_of(std::string_view name) {
    std::string flag = fmt::format("--{}", name);
    std::replace(flag.begin(), flag.end(), '_', '-');
    return flag;
}

namespace {

using Kind = ParameterKind;

// The start of an error line. It is `where` when that already ends in the parameter's name (a flag,
// a key path of a scene file); `where` and the name otherwise; the flag when `where` is empty.
std::string place_of(std::string_view name, std::string_view where) {
    std::string flag = flag_of(name);
    if (where.empty()) return flag;
    const std::string_view dashed = std::string_view(flag).substr(2);
    if (where.ends_with(name) || where.ends_with(dashed)) return std::string(where);
    return fmt::format("{}: {}", where, name);
}

// A suggestion for a misspelt choice, in brackets; empty without one.
std::string hint_for(const Parameter& p, std::string_view text) {
    const std::string_view instead = p.name == "brdf" ? instead_of_undrawn(text) : "";
    if (!instead.empty()) return fmt::format(" ({})", instead);
    const std::string_view nearest = nearest_name(p.choices, text);
    return nearest.empty() ? std::string() : fmt::format(" (did you mean '{}'?)", nearest);
}

// The parameter and those that belong to it.
using Names = std::vector<std::string_view>;
Names with_its_own(std::string_view name) {
    Names names{name};
    for (const Parameter& parameter : parameter_table())
        if (parameter.belongs_to == name) names.push_back(parameter.name);
    return names;
}

// Groups of parameters that exclude each other: setting one group unsets the others.
const std::vector<std::vector<Names>>& alternatives() {
    static const Names scratch = with_its_own("scratch"), weave = with_its_own("weave"),
                       height = with_its_own("height_map");
    static const std::vector<std::vector<Names>> all = {
        {{"alpha_x", "alpha_y"}, {"e_x", "e_y"}, {"cosine_exponent"}, {"roughness", "anisotropy"}},
        {{"f0"}, {"ior"}},
        {{"normal_map"}, height, scratch, weave},
        {{"weave_yarns"}, {"weave_yarns_per_cm"}},
        {{"uv_scale"}, {"physical_size", "maps_tile_mm"}},
        {{"tabulated"}, scratch, weave}};
    return all;
}

std::string_view name_of(Kind kind) {
    switch (kind) {
        case Kind::real:
            return "a number";
        case Kind::integer:
            return "a whole number";
        case Kind::boolean:
            return "a switch";
        case Kind::choice:
            return "a choice of names";
        case Kind::color:
            return "a color";
        case Kind::vector:
            return "a vector";
        case Kind::text:
            return "a text";
    }
    return "";
}

const Parameter& parameter_of(std::string_view name, std::string_view where) {
    if (const Parameter* parameter = find_parameter(name)) return *parameter;
    std::vector<std::string_view> names;
    for (const Parameter& p : parameter_table()) names.push_back(p.name);
    const std::string_view nearest = nearest_name(names, name);
    throw UsageError(fmt::format(
        "{}{}unknown parameter {}{}", where, where.empty() ? "" : ": ", shown(name),
        nearest.empty() ? std::string() : fmt::format("; did you mean '{}'?", nearest)));
}

}  // namespace

void ParameterValues::set(std::string_view name, std::string_view text, std::string_view where) {
    const Parameter& parameter = parameter_of(name, where);
    std::optional<ParameterValue> value = parse_value(parameter, text);
    if (!value || !is_valid(parameter, *value)) {
        throw UsageError(place_of(name, where), "", expectation(parameter),
                         shown(text) + hint_for(parameter, text));
    }
    values_.insert_or_assign(std::string(name), std::move(*value));
}

void ParameterValues::set_value(std::string_view name, const ParameterValue& value,
                                std::string_view where) {
    const Parameter& parameter = parameter_of(name, where);
    const int* whole = std::get_if<int>(&value);
    const ParameterValue typed =
        parameter.kind == Kind::real && whole ? ParameterValue(static_cast<double>(*whole)) : value;
    if (!is_valid(parameter, typed))
        throw UsageError(place_of(name, where), "", expectation(parameter), shown(any_text(value)));
    values_.insert_or_assign(std::string(name), typed);
}

void ParameterValues::erase(std::string_view name) {
    const auto found = values_.find(name);
    if (found != values_.end()) values_.erase(found);
}

bool ParameterValues::is_set(std::string_view name) const {
    return values_.contains(name);
}

bool ParameterValues::has_value(std::string_view name) const {
    return is_set(name) || parameter_of(name, "").default_value.has_value();
}

const ParameterValue& ParameterValues::value_of(std::string_view name,
                                                std::span<const Kind> kinds) const {
    const Parameter& parameter = parameter_of(name, "");
    if (!kinds.empty() && std::find(kinds.begin(), kinds.end(), parameter.kind) == kinds.end())
        throw Error("parameter", name, name_of(kinds.front()), name_of(parameter.kind));
    const auto found = values_.find(name);
    if (found != values_.end()) return found->second;
    if (!parameter.default_value)
        throw UsageError(flag_of(name), "", expectation(parameter), "nothing");
    return *parameter.default_value;
}

double ParameterValues::real(std::string_view name) const {
    static constexpr Kind kKinds[] = {Kind::real, Kind::integer};
    const ParameterValue& value = value_of(name, kKinds);
    const int* whole = std::get_if<int>(&value);
    return whole ? static_cast<double>(*whole) : std::get<double>(value);
}

int ParameterValues::integer(std::string_view name) const {
    static constexpr Kind kKinds[] = {Kind::integer};
    return std::get<int>(value_of(name, kKinds));
}

bool ParameterValues::boolean(std::string_view name) const {
    static constexpr Kind kKinds[] = {Kind::boolean};
    return std::get<bool>(value_of(name, kKinds));
}

int ParameterValues::choice(std::string_view name) const {
    static constexpr Kind kKinds[] = {Kind::choice};
    return std::get<ParameterChoice>(value_of(name, kKinds)).index;
}

glm::vec3 ParameterValues::vec3(std::string_view name) const {
    static constexpr Kind kKinds[] = {Kind::vector, Kind::color};
    return std::get<glm::vec3>(value_of(name, kKinds));
}

std::string ParameterValues::text(std::string_view name) const {
    return text_of(parameter_of(name, ""), value_of(name, {}));
}

void ParameterValues::merge(const ParameterValues& other) {
    for (const std::vector<Names>& ways : alternatives()) {
        for (const Names& chosen : ways) {
            const auto is_in_other = [&](std::string_view name) { return other.is_set(name); };
            if (std::none_of(chosen.begin(), chosen.end(), is_in_other)) continue;
            for (const Names& replaced : ways) {
                if (&replaced == &chosen) continue;
                for (const std::string_view name : replaced) erase(name);
            }
        }
    }
    for (const auto& [name, value] : other.values_) values_.insert_or_assign(name, value);
}

void require_one_roughness(const ParameterValues& values, bool as_flags) {
    const auto set_among = [&](std::initializer_list<std::string_view> names) {
        std::string list;
        for (const std::string_view name : names) {
            if (!values.is_set(name)) continue;
            if (!list.empty()) list += ' ';
            list += as_flags ? flag_of(name) : std::string(name);
        }
        return list;
    };
    const std::string alphas = set_among({"alpha_x", "alpha_y"});
    const std::string exponents = set_among({"e_x", "e_y"});
    const std::string cosine = set_among({"cosine_exponent"});
    std::string all;
    int ways = 0;
    for (const std::string& way : {alphas, exponents, cosine}) {
        if (way.empty()) continue;
        all += (all.empty() ? "" : " and ") + way;
        ++ways;
    }
    if (ways < 2) return;
    throw UsageError(all + " say the same thing: give one pair only");
}

}  // namespace burnish
