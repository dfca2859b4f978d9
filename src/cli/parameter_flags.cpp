#include "cli/parameter_flags.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdint>
#include <vector>

namespace burnish::cli {
namespace {

// A range such as "0.001 to 1.5". Empty for parameters without a range, and for positions, whose
// range is only a technical limit.
std::string range_of(const Parameter& parameter) {
    const bool is_coefficients = parameter.kind == ParameterKind::vector && parameter.unit.empty();
    const bool has_range = parameter.kind == ParameterKind::real ||
                           parameter.kind == ParameterKind::integer ||
                           parameter.kind == ParameterKind::color || is_coefficients;
    if (!has_range) return "";
    const auto plain = [](double number) {  // never 1e+06
        return std::abs(number) >= 1.0 ? fmt::format("{:.10g}", number)
                                       : fmt::format("{:g}", number);
    };
    const bool each = parameter.kind == ParameterKind::color || is_coefficients;
    return (each ? "each " : "") + plain(parameter.low) + " to " + plain(parameter.high);
}

}  // namespace

std::string value_name(const Parameter& parameter) {
    switch (parameter.kind) {
        case ParameterKind::real:
            return "NUMBER";
        case ParameterKind::integer:
            return "INTEGER";
        case ParameterKind::choice:
            return "NAME";
        case ParameterKind::color:
            return "COLOR";
        case ParameterKind::vector:
            return "X,Y,Z";
        case ParameterKind::text:
            return std::string(parameter.names);
        case ParameterKind::boolean:
            return "";
    }
    return "";
}

std::string help_of(const Parameter& parameter) {
    std::string text(parameter.help);
    if (!parameter.unit.empty()) text += fmt::format(" [{}]", parameter.unit);
    if (!parameter.choices.empty()) text += fmt::format(": {}", fmt::join(parameter.choices, ", "));
    std::vector<std::string> facts;
    if (const std::string range = range_of(parameter); !range.empty()) facts.push_back(range);
    if (!parameter.default_text.empty())
        facts.push_back(fmt::format("default {}", parameter.default_text));
    if (!facts.empty()) text += fmt::format(" ({})", fmt::join(facts, "; "));
    return text;
}

CLI::Option* add_parameter_flag(CLI::App& command, std::string_view name, ParameterValues& values) {
    const Parameter& parameter = *find_parameter(name);
    const std::string flag = flag_of(parameter.name);
    const auto set = [&values, key = std::string(name), flag](const std::string& text) {
        values.set(key, text, flag);
    };
    if (parameter.kind == ParameterKind::boolean) {
        // "--shadows", which is the text "true", and "--shadows=false".
        const auto text = std::make_shared<std::string>();
        return command.add_flag(flag, *text, help_of(parameter))
            ->each([set, text](const std::string& value) { set(value); });
    }
    return command.add_option_function<std::string>(flag, set, help_of(parameter))
        ->type_name(value_name(parameter));
}

}  // namespace burnish::cli
