#include "cli/session.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string_view>

#include "cli/progress_display.hpp"
#include "core/output_stream.hpp"
#include "core/text.hpp"

namespace burnish::cli {
const CancelToken& interrupt_token() {
    static const CancelToken token;
    return token;
}

Session::Session(int argc, const char* const* argv) {
    // Without the folder: the installation path is irrelevant to the result.
    command_line_ = argc > 0 ? std::filesystem::path(argv[0]).filename().string() : "burnish";
    for (int i = 1; i < argc; ++i) command_line_ += " " + shell_quoted(argv[i]);
}

Progress Session::progress() const {
    const auto names = progress_mode_names();
    const auto mode = static_cast<ProgressMode>(
        index_of_name(names, progress_mode_, "way to show progress", "--progress"));
    const auto display = std::make_shared<ProgressDisplay>(mode);
    return {[display](std::string_view stage, double done) { display->show(stage, done); },
            interrupt_token()};
}

void Session::add_options(CLI::App& app) {
    app.add_option("--progress", progress_mode_,
                   "how to show progress on standard error: auto (a bar on a terminal, after a "
                   "second), bar, json (one object a line) or off")
        ->type_name("MODE");
}

void print(const std::string& text) {
    OutputStream output = OutputStream::standard_output(Progress(interrupt_token()));
    output.write(text);
    output.finish();
}

void print_report(const std::vector<std::string>& warnings,
                  const std::vector<std::filesystem::path>& written,
                  const std::vector<std::string>& notes) {
    for (const std::string& note : notes) std::fprintf(stderr, "burnish: note: %s\n", note.c_str());
    for (const std::string& warning : warnings)
        std::fprintf(stderr, "burnish: warning: %s\n", warning.c_str());
    std::string text;
    for (const auto& path : written) text += path.string() + '\n';
    print(text);
}

}  // namespace burnish::cli
