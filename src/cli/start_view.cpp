// burnish view: starts the window, a program of its own, in place of this one.
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/error.hpp"
#include "cli/commands/commands.hpp"
#include "cli/session.hpp"

namespace burnish::cli {
namespace {

namespace fs = std::filesystem;

// Beside this program.
fs::path view_program() {
    std::error_code error;
    return fs::read_symlink("/proc/self/exe", error).parent_path() / "burnish-view";
}

void start_view(const std::vector<std::string>& words) {
    const fs::path program = view_program();
    std::error_code error;
    if (!fs::exists(program, error))
        throw Error("burnish view", "",
                    "burnish-view beside burnish (make view; packages libglfw3-dev, libimgui-dev)",
                    "none in " + program.parent_path().string());
    std::vector<std::string> all{program.string()};
    all.insert(all.end(), words.begin(), words.end());
    std::vector<char*> arguments;
    for (std::string& word : all) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execv(program.c_str(), arguments.data());
    throw Error(program.string(), "", "a program that starts", std::strerror(errno));
}

}  // namespace

// All words after "view" are those of burnish-view, --help among them, so that they are not parsed here.
void start_view_if_asked(int argc, const char* const* argv) {
    if (argc < 2 || std::string_view(argv[1]) != "view") return;
    start_view({argv + 2, argv + argc});
}

// For the list of commands.
void add_view_command(CLI::App& parent, Session&) {
    parent.add_subcommand("view", "Show a model, scene or material in a window")->callback([] {
        start_view({});
    });
}

}  // namespace burnish::cli
