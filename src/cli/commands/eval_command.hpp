// The flags that `mdf eval` and `brdf eval` share.
#pragma once

#include <functional>
#include <string>

#include "jobs/models/eval.hpp"

namespace CLI {
class App;
}

namespace burnish::cli {

class Session;

// Adds the subcommand `eval` to `parent`. `columns` is the part of its help on the columns that it
// reads and adds; `colors`: with the flag --rgb.
void add_eval_command(CLI::App& parent, Session& session, const std::string& description,
                      const std::string& columns, bool colors,
                      std::function<void(const EvalRequest&, const Progress&)> evaluate);

}  // namespace burnish::cli
