// What every command shares: the flags that come before all others, and the words it was called
// with.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "burnish/progress.hpp"

namespace CLI {
class App;
}

namespace burnish::cli {

// Cancelled by Ctrl-C and SIGTERM: the one of this program.
const CancelToken& interrupt_token();

class Session {
  public:
    Session(int argc, const char* const* argv);

    // The command as it can be typed into a shell again, for the metadata of what it makes.
    const std::string& command_line() const { return command_line_; }

    // Shows the progress of one piece of work as --progress asks, until the last copy is gone;
    // Ctrl-C cancels it.
    Progress progress() const;

    void add_options(CLI::App& app);

  private:
    std::string command_line_;
    std::string progress_mode_ = "auto";
};

// Everything at once, every write checked: a full disk is an error for printed text as well.
void print(const std::string& text);

// Warnings to standard error, a line each; then the paths of what was written.
void print_report(const std::vector<std::string>& warnings,
                  const std::vector<std::filesystem::path>& written);

}  // namespace burnish::cli
