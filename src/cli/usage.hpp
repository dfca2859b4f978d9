// Error messages for a wrong command line.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "burnish/error.hpp"

namespace CLI {
class App;
class FormatterBase;
class ParseError;
}  // namespace CLI

namespace burnish::cli {

// The message for a command line that CLI11 could not parse. For an unknown command or flag it
// suggests the nearest existing one.
UsageError usage_error(const CLI::App& root, const CLI::ParseError& error);

// Throws UsageError for a flag that takes a value and has another flag behind it. Before parsing:
// CLI11 would take that flag for the value.
void require_values(const CLI::App& root, int argc, const char* const* argv);

// Help texts with two blanks or a new line between a flag and its text.
std::shared_ptr<CLI::FormatterBase> help_formatter();

// Makes `app` throw UsageError when it is called without a subcommand.
void require_command(CLI::App& app);

// A line for each flag that was given more than once, after parsing; the last one holds.
std::vector<std::string> repeated_flags(const CLI::App& root);

}  // namespace burnish::cli
