// What `burnish COMMAND --help` prints, taken apart.
#pragma once

#include <string>
#include <vector>

namespace burnish::test {

struct HelpRow {
    std::string name;  // "-o,--output FILE REQUIRED"
    std::string text;
};

struct HelpGroup {
    std::string title;  // "Options", "Camera (default: ...)"
    std::vector<HelpRow> rows;
};

struct HelpText {
    std::string summary;
    std::string usage;              // "burnish render [OPTIONS] input"
    std::vector<HelpGroup> groups;  // all but "Subcommands"
    std::vector<std::string> commands;
    std::string footer;  // as it is printed, without blank lines at its ends
};

HelpText parse_help(const std::string& printed);

// Standard output of a command line. Throws std::runtime_error when the command fails.
std::string output_of(const std::string& command);

}  // namespace burnish::test
