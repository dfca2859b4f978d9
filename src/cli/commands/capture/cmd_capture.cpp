// burnish capture: from photographs to materials.
#include <CLI/CLI.hpp>

#include "cli/commands/commands.hpp"
#include "cli/usage.hpp"

namespace burnish::cli {

void add_capture_command(CLI::App& parent, Session& session) {
    CLI::App* capture = parent.add_subcommand("capture", "Materials from photographs");
    require_command(*capture);
    add_capture_directions_command(*capture, session);
    add_capture_simulate_command(*capture, session);
    add_capture_fit_command(*capture, session);
    add_capture_relight_command(*capture, session);
    add_capture_export_command(*capture, session);
    add_capture_report_command(*capture, session);
}

}  // namespace burnish::cli
