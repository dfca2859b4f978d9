// Flags and help of rows of the parameter table, for the commands that take some of them.
#pragma once

#include <string>

#include "burnish/parameters.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace burnish::cli {

// The placeholder of the value in the help: "NUMBER".
std::string value_name(const Parameter& parameter);

// One line of help: meaning, unit, choices, range and default.
std::string help_of(const Parameter& parameter);

// Adds the flag of the parameter `name`. `values` receives its value; it must outlive the command.
CLI::Option* add_parameter_flag(CLI::App& command, std::string_view name, ParameterValues& values);

}  // namespace burnish::cli
