// What is said when the command itself is wrong.
#pragma once

#include "burnish/error.hpp"

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace burnish::cli {

// The one line for a command line that CLI11 could not parse; an unknown command or flag suggests
// the nearest that there is.
UsageError usage_error(const CLI::App& root, const CLI::ParseError& error);

// Makes `app` ask for one of its subcommands when it is called without.
void require_command(CLI::App& app);

}  // namespace burnish::cli
