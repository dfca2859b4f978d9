// Flags for whole numbers, with our error messages.
#pragma once

#include <string>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace burnish::cli {

struct IntegerRange {
    int low, high;
};

// Parses a whole number within the range; throws UsageError naming the flag for anything else.
int whole_number(const std::string& text, IntegerRange range, const std::string& flag);

// `target` receives the value; it must outlive the command. The help text ends with the range.
CLI::Option* add_integer(CLI::App& command, const std::string& flag, int& target,
                         IntegerRange range, const std::string& help);

// --gl-device
CLI::Option* add_gl_device(CLI::App& command, int& target);

}  // namespace burnish::cli
