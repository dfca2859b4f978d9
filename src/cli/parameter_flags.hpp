// Flags and help of rows of THE parameter table, for every command that takes some of them.
#pragma once

#include <string>

#include "burnish/parameters.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace burnish::cli {

// What stands behind the flag in its help: "NUMBER".
std::string value_name(const Parameter& parameter);

// One line: what it is, its unit, choices, range and default.
std::string help_of(const Parameter& parameter);

// Adds the flag of the parameter `name`; `values`, which must outlive the command, receives it.
CLI::Option* add_parameter_flag(CLI::App& command, std::string_view name, ParameterValues& values);

}  // namespace burnish::cli
