// Error messages for a wrong command line.
#pragma once

#include <string>
#include <vector>

#include "burnish/error.hpp"

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace burnish::cli {

// The message for a command line that CLI11 could not parse. For an unknown command or flag it
// suggests the nearest existing one.
UsageError usage_error(const CLI::App& root, const CLI::ParseError& error);

// Makes `app` throw UsageError when it is called without a subcommand.
void require_command(CLI::App& app);

// A line for each flag that was given more than once, after parsing; the last one holds.
std::vector<std::string> repeated_flags(const CLI::App& root);

}  // namespace burnish::cli
