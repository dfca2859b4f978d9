// The flags of the commands that draw a scene: what, in which light, and a flag for every row of the parameter table.
#pragma once

#include <string>

#include "burnish/stage.hpp"

namespace CLI {
class App;
}

namespace burnish::cli {

struct SceneFlags {
    StageRequest stage;
    std::string size;  // --size
};

// `flags` receives the values; it must outlive the command. `needs_input`: the model must be named.
void add_scene_flags(CLI::App& command, SceneFlags& flags, bool needs_input = true);
// The flags for the parameters.
void add_scene_parameter_flags(CLI::App& command, SceneFlags& flags);
// What the flags ask for, once they are parsed. Throws UsageError.
StageRequest stage_request(const SceneFlags& flags);

}  // namespace burnish::cli
