// burnish capture: from pictures of a sample to its material.
#include <CLI/CLI.hpp>

#include "cli/commands.hpp"
#include "cli/usage.hpp"

namespace burnish::cli {

void add_capture_command(CLI::App& parent, Session& session) {
    CLI::App* capture = parent.add_subcommand("capture", "Measured surfaces");
    require_command(*capture);
    add_capture_relight_command(*capture, session);
    add_capture_export_command(*capture, session);
}

}  // namespace burnish::cli
