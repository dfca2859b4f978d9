// burnish: the command line. Parses, calls jobs/, prints. Every failure is one line on standard
// error.
#include <signal.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <sstream>
#include <string>

#include "burnish/error.hpp"
#include "burnish/progress.hpp"
#include "burnish/version.hpp"
#include "cli/commands/commands.hpp"
#include "cli/session.hpp"
#include "cli/usage.hpp"

namespace burnish::cli {
namespace {

// Exit codes of the program.
constexpr int kDone = 0, kFailure = 1, kUsage = 2, kInterrupted = 130;

void on_interrupt(int) {
    interrupt_token().cancel();
}

void set_signal(int number, void (*handler)(int), int flags) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = flags;
    sigemptyset(&action.sa_mask);
    sigaction(number, &action, nullptr);
}

void set_signals() {
    interrupt_token();  // created now: a signal handler must not create it
    // Ctrl-C interrupts blocking reads and writes; a second one ends the program at once.
    constexpr int kOnce = static_cast<int>(SA_RESETHAND);
    set_signal(SIGINT, on_interrupt, kOnce);
    set_signal(SIGTERM, on_interrupt, kOnce);
    // A write to a closed pipe or beyond a file-size limit must return an error, not kill the
    // program.
    set_signal(SIGPIPE, SIG_IGN, 0);
    set_signal(SIGXFSZ, SIG_IGN, 0);
}

void add_commands(CLI::App& app, Session& session) {
    add_render_command(app, session);
    add_trace_command(app, session);
    add_view_command(app, session);
    add_gallery_command(app, session);
    add_scratch_command(app, session);
    add_weave_command(app, session);
    add_capture_command(app, session);
    add_export_command(app, session);
    add_info_command(app, session);
    add_mdf_command(app, session);
    add_brdf_command(app, session);
    add_verify_command(app, session);
    add_bench_command(app, session);
}

void run(int argc, const char* const* argv) {
    Session session(argc, argv);
    CLI::App app("Renders anisotropic surfaces under fine detail, and evaluates the maths behind.",
                 "burnish");
    app.formatter(help_formatter());  // of the commands, too
    app.fallthrough();                // --progress may follow the command
    app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
    app.set_version_flag("--version", "burnish " + std::string(version()));
    session.add_options(app);
    require_command(app);
    add_commands(app, session);

    require_values(app, argc, argv);
    try {
        app.parse(argc, argv);
        for (const std::string& line : repeated_flags(app))
            std::fprintf(stderr, "burnish: warning: %s\n", line.c_str());
    } catch (const CLI::Success& request) {  // --help, --version
        std::ostringstream text;
        app.exit(request, text, text);
        print(text.str());
    } catch (const CLI::ParseError& error) {
        throw usage_error(app, error);
    }
}

int complain(const std::string& line, int exit_code) {
    std::fprintf(stderr, "burnish: %s\n", line.c_str());
    return exit_code;
}

}  // namespace
}  // namespace burnish::cli

int main(int argc, char** argv) {
    using namespace burnish::cli;
    try {
        set_signals();
        // Suppress Mesa's warnings on standard error about devices that it cannot open. Those of
        // our own contexts are in Context::warnings.
        setenv("EGL_LOG_LEVEL", "fatal", 0);
        start_view_if_asked(argc, argv);
        run(argc, argv);
        return kDone;
    } catch (const burnish::UsageError& error) {
        return complain(error.what(), kUsage);
    } catch (const burnish::Interrupted& error) {
        return complain(error.what(), kInterrupted);
    } catch (const std::bad_alloc&) {
        return complain("not enough memory", kFailure);
    } catch (const std::exception& error) {
        return complain(burnish::one_line(error.what()), kFailure);
    }
}
