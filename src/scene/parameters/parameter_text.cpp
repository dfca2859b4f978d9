#include "scene/parameters/parameter_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>

#include "burnish/error.hpp"
#include "burnish/image_io.hpp"

namespace burnish {
namespace {

using Kind = ParameterKind;

// The whole of `text` as one finite number. A leading '+' is allowed, blanks are not.
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

// "#rrggbb", as color pickers and web pages show it, is sRGB; it is decoded here only.
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

// Wraps an optional value in an optional variant.
template <typename Value>
std::optional<ParameterValue> any_of(const std::optional<Value>& value) {
    if (!value) return std::nullopt;
    return ParameterValue(*value);
}

bool in_range(const Parameter& p, double value) {
    return std::isfinite(value) && value >= p.low && value <= p.high;
}

// The index of the alternative of ParameterValue that a kind takes.
std::size_t index_of(Kind kind) {
    switch (kind) {
        case Kind::real:
            return 0;
        case Kind::integer:
            return 1;
        case Kind::boolean:
            return 2;
        case Kind::choice:
            return 3;
        case Kind::color:
        case Kind::vector:
            return 4;
        case Kind::text:
            return 5;
    }
    return std::variant_npos;
}

// Visitor by the type of a value: whether the parameter accepts it.
struct Validity {
    const Parameter& p;
    bool operator()(double value) const { return in_range(p, value); }
    bool operator()(int value) const { return in_range(p, value); }
    bool operator()(bool) const { return true; }
    bool operator()(ParameterChoice value) const {
        return value.index >= 0 && value.index < std::ssize(p.choices);
    }
    bool operator()(const glm::vec3& v) const {
        return in_range(p, static_cast<double>(v.x)) && in_range(p, static_cast<double>(v.y)) &&
               in_range(p, static_cast<double>(v.z));
    }
    bool operator()(const std::string& text) const {
        return !text.empty() && text.find('\0') == std::string::npos;
    }
};

// Visitor by the type of a value: its text. Numbers have the fewest digits that round-trip.
struct Wording {
    std::span<const std::string_view> choices;
    std::string operator()(double value) const { return fmt::format("{}", value); }
    std::string operator()(int value) const { return fmt::format("{}", value); }
    std::string operator()(bool value) const { return value ? "true" : "false"; }
    std::string operator()(ParameterChoice value) const {
        const auto index = static_cast<std::size_t>(value.index);
        return index < choices.size() ? std::string(choices[index])
                                      : fmt::format("choice {}", value.index);
    }
    std::string operator()(const glm::vec3& v) const {
        return fmt::format("{},{},{}", v.x, v.y, v.z);
    }
    std::string operator()(const std::string& text) const { return text; }
};

}  // namespace

std::optional<ParameterValue> parse_value(const Parameter& p, std::string_view text) {
    switch (p.kind) {
        case Kind::real:
            return any_of(parse_real(text));
        case Kind::integer:
            return any_of(parse_integer(text));
        case Kind::boolean:
            return any_of(parse_boolean(text));
        case Kind::choice: {
            const auto found = std::find(p.choices.begin(), p.choices.end(), text);
            if (found == p.choices.end()) return std::nullopt;
            return ParameterChoice{static_cast<int>(found - p.choices.begin())};
        }
        case Kind::color:
            return any_of(parse_color(text));
        case Kind::vector:
            return any_of(parse_triple(text));
        case Kind::text:
            return ParameterValue(std::string(text));
    }
    return std::nullopt;
}

bool is_valid(const Parameter& p, const ParameterValue& value) {
    return value.index() == index_of(p.kind) && std::visit(Validity{p}, value);
}

std::string text_of(const Parameter& p, const ParameterValue& value) {
    if (!is_valid(p, value)) throw Error(p.name, "", expectation(p), "another value");
    return std::visit(Wording{p.choices}, value);
}

std::string any_text(const ParameterValue& value) {
    return std::visit(Wording{{}}, value);
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

}  // namespace burnish
