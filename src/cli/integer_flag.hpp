// Flags for whole numbers, checked in our words.
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

// Throws UsageError naming the flag for anything but a whole number of the range.
int whole_number(const std::string& text, IntegerRange range, const std::string& flag);

// `target`, which must outlive the command, receives it. The range stands behind the help.
CLI::Option* add_integer(CLI::App& command, const std::string& flag, int& target,
                         IntegerRange range, const std::string& help);

// --gl-device
CLI::Option* add_gl_device(CLI::App& command, int& target);

}  // namespace burnish::cli
