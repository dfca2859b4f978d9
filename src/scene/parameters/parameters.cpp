#include "burnish/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "burnish/error.hpp"
#include "burnish/shading_names.hpp"
#include "core/text.hpp"
#include "image/image_io.hpp"

namespace burnish {

std::string flag_of(std::string_view name) {
    std::string flag = "--" + std::string(name);
    std::replace(flag.begin(), flag.end(), '_', '-');
    return flag;
}

namespace {

using Kind = ParameterKind;

// The start of an error line: `where` itself when it already ends in the parameter's name (a flag,
// a key path of a scene file), else `where` and the name, else the flag.
std::string place_of(std::string_view name, std::string_view where) {
    const std::string flag = flag_of(name);
    if (where.empty()) return flag;
    const std::string_view dashed = std::string_view(flag).substr(2);
    if (where.ends_with(name) || where.ends_with(dashed)) return std::string(where);
    return fmt::format("{}: {}", where, name);
}

// The whole of `text` as one finite number; a leading '+' is welcome, blanks are not.
std::optional<double> parse_real(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    double value = 0.0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (status != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

std::optional<int> parse_integer(std::string_view text) {
    int value = 0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (status != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::optional<bool> parse_boolean(std::string_view text) {
    if (text == "true" || text == "on" || text == "yes" || text == "1") return true;
    if (text == "false" || text == "off" || text == "no" || text == "0") return false;
    return std::nullopt;
}

std::optional<glm::vec3> parse_triple(std::string_view text) {
    glm::vec3 value(0.0f);
    for (int i = 0; i < 3; ++i) {
        const std::size_t comma = text.find(',');
        if ((comma == std::string_view::npos) != (i == 2)) return std::nullopt;
        const std::optional<double> component = parse_real(text.substr(0, comma));
        if (!component) return std::nullopt;
        value[i] = static_cast<float>(*component);
        if (i < 2) text.remove_prefix(comma + 1);
    }
    return value;
}

// "#rrggbb" is what pickers and web pages show: sRGB, decoded here once.
std::optional<glm::vec3> parse_color(std::string_view text) {
    if (!text.starts_with('#')) return parse_triple(text);
    std::uint32_t code = 0;
    const char* end = text.data() + text.size();
    const auto [stop, status] = std::from_chars(text.data() + 1, end, code, 16);
    if (text.size() != 7 || status != std::errc{} || stop != end) return std::nullopt;
    const auto channel = [code](int shift) {
        return linear_from_srgb(static_cast<float>((code >> shift) & 0xffu) / 255.0f);
    };
    return glm::vec3(channel(16), channel(8), channel(0));
}

bool in_range(const Parameter& p, double value) {
    return value >= p.low && value <= p.high;
}

bool in_range(const Parameter& p, const glm::vec3& v) {
    return in_range(p, static_cast<double>(v.x)) && in_range(p, static_cast<double>(v.y)) &&
           in_range(p, static_cast<double>(v.z));
}

bool is_valid(const Parameter& p, std::string_view text) {
    switch (p.kind) {
        case Kind::real: {
            const std::optional<double> value = parse_real(text);
            return value && in_range(p, *value);
        }
        case Kind::integer: {
            const std::optional<int> value = parse_integer(text);
            return value && in_range(p, *value);
        }
        case Kind::boolean:
            return parse_boolean(text).has_value();
        case Kind::choice:
            return std::find(p.choices.begin(), p.choices.end(), text) != p.choices.end();
        case Kind::color: {
            const std::optional<glm::vec3> value = parse_color(text);
            return value && in_range(p, *value);
        }
        case Kind::vector: {
            const std::optional<glm::vec3> value = parse_triple(text);
            return value && in_range(p, *value);
        }
        case Kind::text:
            return !text.empty() && text.find('\0') == std::string_view::npos;
    }
    return false;
}

std::string expectation(const Parameter& p) {
    const std::string range = fmt::format("from {:g} to {:g}", p.low, p.high);
    switch (p.kind) {
        case Kind::real:
            return "a number " + range;
        case Kind::integer:
            return fmt::format("a whole number from {:.0f} to {:.0f}", p.low, p.high);
        case Kind::boolean:
            return "true or false";
        case Kind::choice:
            return fmt::format("one of {}", fmt::join(p.choices, " "));
        case Kind::color:
            return "r,g,b (linear, each " + range + ") or #rrggbb";
        case Kind::vector:
            return "x,y,z, each " + range;
        case Kind::text:
            return "a text that is not empty";
    }
    return {};
}

// What may have been meant, in brackets.
std::string hint_for(const Parameter& p, std::string_view text) {
    const std::string_view instead = p.name == "brdf" ? instead_of_undrawn(text) : "";
    if (!instead.empty()) return fmt::format(" ({})", instead);
    const std::string_view nearest = nearest_name(p.choices, text);
    return nearest.empty() ? std::string() : fmt::format(" (did you mean '{}'?)", nearest);
}

// Ways of saying the same thing; who says it later replaces what was said before.
using Names = std::vector<std::string_view>;
const std::vector<std::vector<Names>>& alternatives() {
    static const Names scratch = {"scratch", "scratch_direction"};
    static const Names weave = {"weave",       "weave_yarns", "weave_crimp",
                                "weave_bulge", "weave_gap",   "weave_twist",
                                "weave_fuzz",  "warp_color",  "weft_color"};
    static const std::vector<std::vector<Names>> all = {
        {{"alpha_x", "alpha_y"}, {"e_x", "e_y"}, {"cosine_exponent"}, {"roughness", "anisotropy"}},
        {{"normal_map"}, scratch, weave},
        {{"tabulated"}, scratch, weave}};
    return all;
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
    if (!is_valid(parameter, text)) {
        throw UsageError(place_of(name, where), "", expectation(parameter),
                         shown(text) + hint_for(parameter, text));
    }
    values_.insert_or_assign(std::string(name), std::string(text));
}

bool ParameterValues::is_set(std::string_view name) const {
    return values_.contains(name);
}

bool ParameterValues::has_value(std::string_view name) const {
    return is_set(name) || !parameter_of(name, "").default_text.empty();
}

std::string_view ParameterValues::value_of(std::string_view name) const {
    const auto found = values_.find(name);
    if (found != values_.end()) return found->second;
    const Parameter& parameter = parameter_of(name, "");
    if (parameter.default_text.empty())
        throw UsageError(flag_of(name), "", expectation(parameter), "nothing");
    return parameter.default_text;
}

double ParameterValues::real(std::string_view name) const {
    return parse_real(value_of(name)).value();
}

int ParameterValues::integer(std::string_view name) const {
    return parse_integer(value_of(name)).value();
}

bool ParameterValues::boolean(std::string_view name) const {
    return parse_boolean(value_of(name)).value();
}

int ParameterValues::choice(std::string_view name) const {
    return index_of_name(parameter_of(name, "").choices, value_of(name), name, "");
}

glm::vec3 ParameterValues::vec3(std::string_view name) const {
    return parse_color(value_of(name)).value();
}

std::string ParameterValues::text(std::string_view name) const {
    return std::string(value_of(name));
}

void ParameterValues::merge(const ParameterValues& other) {
    for (const std::vector<Names>& ways : alternatives()) {
        for (const Names& chosen : ways) {
            const auto is_in_other = [&](std::string_view name) { return other.is_set(name); };
            if (std::none_of(chosen.begin(), chosen.end(), is_in_other)) continue;
            for (const Names& replaced : ways) {
                if (&replaced == &chosen) continue;
                for (const std::string_view name : replaced) {
                    const auto found = values_.find(name);
                    if (found != values_.end()) values_.erase(found);
                }
            }
        }
    }
    for (const auto& [name, text] : other.values_) values_.insert_or_assign(name, text);
}

}  // namespace burnish
