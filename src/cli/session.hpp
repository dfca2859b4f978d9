// State that every command shares: the global flags and the words of the command line.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "burnish/progress.hpp"

namespace CLI {
class App;
}

namespace burnish::cli {

// The program's token, which Ctrl-C and SIGTERM cancel.
const CancelToken& interrupt_token();

class Session {
  public:
    Session(int argc, const char* const* argv);

    // The command line in a form that a shell accepts, for the metadata of output files.
    const std::string& command_line() const { return command_line_; }

    // Shows the progress of one piece of work in the mode of --progress, for the lifetime of the
    // returned object and its copies; Ctrl-C cancels the work.
    Progress progress() const;

    void add_options(CLI::App& app);

  private:
    std::string command_line_;
    std::string progress_mode_ = "auto";
};

// Prints the whole text and checks every write: a full disk is an error for printed text too.
void print(const std::string& text);

// Prints warnings and notes to standard error, one line each, then the paths of the written files.
void print_report(const std::vector<std::string>& warnings,
                  const std::vector<std::filesystem::path>& written,
                  const std::vector<std::string>& notes = {});

}  // namespace burnish::cli
