// The commands of the program. Each cmd_<verb>.cpp defines one function, which adds a subcommand to
// `parent` with flags, help and a callback that calls jobs/ and prints.
#pragma once

namespace CLI {
class App;
}

namespace burnish::cli {

class Session;

void add_mdf_command(CLI::App& parent, Session& session);
void add_brdf_command(CLI::App& parent, Session& session);
void add_brdf_fit_command(CLI::App& brdf, Session& session);  // `brdf fit`
void add_info_command(CLI::App& parent, Session& session);
void add_bench_command(CLI::App& parent, Session& session);
void add_render_command(CLI::App& parent, Session& session);
void add_trace_command(CLI::App& parent, Session& session);
void add_export_command(CLI::App& parent, Session& session);
void add_gallery_command(CLI::App& parent, Session& session);
void add_scratch_command(CLI::App& parent, Session& session);
void add_view_command(CLI::App& parent, Session& session);
// Replaces this program by the window when the first word is "view"; returns otherwise.
void start_view_if_asked(int argc, const char* const* argv);
void add_verify_command(CLI::App& parent, Session& session);
void add_weave_command(CLI::App& parent, Session& session);
void add_capture_command(CLI::App& parent, Session& session);
void add_capture_simulate_command(CLI::App& capture, Session& session);
void add_capture_directions_command(CLI::App& capture, Session& session);
void add_capture_fit_command(CLI::App& capture, Session& session);
void add_capture_relight_command(CLI::App& capture, Session& session);  // `capture relight`
void add_capture_export_command(CLI::App& capture, Session& session);   // `capture export`
void add_capture_report_command(CLI::App& capture, Session& session);   // `capture report`

}  // namespace burnish::cli
