// Flags that say what a rig file gets wrong or cannot know, for the commands that read stacks, or
// what a rig is to hold, for those that make one.
#pragma once

#include <string>

#include "burnish/rig.hpp"

namespace CLI {
class App;
}

namespace burnish::cli {

// Must outlive the command.
class RigFlags {
  public:
    void add_to(CLI::App& command);
    void add_to_new(CLI::App& command);  // for a rig that is made: no --flip-y
    RigOverrides overrides() const;      // throws UsageError

  private:
    std::string response_, camera_;
    double width_mm_ = 0.0;
    bool flip_y_ = false;
};

}  // namespace burnish::cli
