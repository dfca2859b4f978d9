// Flags that correct or complete a rig file, for commands that read stacks, and flags for the
// contents of a new rig, for commands that make one.
#pragma once

#include <string>

#include "burnish/rig.hpp"

namespace CLI {
class App;
}

namespace burnish::cli {

// "linear" or "srgb"; throws UsageError naming the flag.
RigResponse parse_response(const std::string& text, const char* flag);

// Must outlive the command.
class RigFlags {
  public:
    void add_to(CLI::App& command);
    void add_to_new(CLI::App& command);  // for a new rig: no --flip-y
    RigOverrides overrides() const;      // throws UsageError

  private:
    std::string response_, camera_;
    double width_mm_ = 0.0, intensity_ = 0.0;
    bool flip_y_ = false, by_order_ = false, skip_missing_ = false;
};

}  // namespace burnish::cli
