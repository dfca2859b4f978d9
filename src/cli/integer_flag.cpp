#include "cli/integer_flag.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>

#include "burnish/error.hpp"

namespace burnish::cli {

int whole_number(const std::string& text, IntegerRange range, const std::string& flag) {
    int value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, status] = std::from_chars(text.data(), end, value);
    if (status == std::errc{} && stop == end && value >= range.low && value <= range.high)
        return value;
    throw UsageError(flag, "", fmt::format("a whole number from {} to {}", range.low, range.high),
                     shown(text));
}

CLI::Option* add_integer(CLI::App& command, const std::string& flag, int& target,
                         IntegerRange range, const std::string& help) {
    return command
        .add_option_function<std::string>(
            flag,
            [&target, flag, range](const std::string& text) {
                target = whole_number(text, range, flag);
            },
            fmt::format("{} ({} to {})", help, range.low, range.high))
        ->type_name("N");
}

CLI::Option* add_gl_device(CLI::App& command, int& target) {
    return add_integer(command, "--gl-device", target, {0, 255},
                       "GL device by its number in `burnish info --devices`")
        ->type_name("NUMBER");
}

}  // namespace burnish::cli
