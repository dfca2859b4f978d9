#include "help_text.hpp"

#include <cstdio>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace burnish::test {
namespace {

constexpr std::string_view kUsage = "Usage: ";

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

// A title stands alone, ends in a colon, and rows follow it; "Examples:" of a footer has no rows.
bool is_title(const std::vector<std::string>& lines, std::size_t at) {
    const std::string& line = lines[at];
    if (line.empty() || line[0] == ' ' || line.back() != ':') return false;
    if (line == "Positionals:" || line == "Options:" || line == "Subcommands:") return true;
    return at + 1 < lines.size() && lines[at + 1].starts_with("  -");
}

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \n");
    if (first == std::string::npos) return "";
    return text.substr(first, text.find_last_not_of(" \n") + 1 - first);
}

// "  --name VALUE     text", or the name alone when it is too long, or "          more text".
void add_row_line(HelpGroup& group, const std::string& line) {
    const bool continues = line.starts_with("      ") && !group.rows.empty();
    if (continues) {
        std::string& text = group.rows.back().text;
        text += (text.empty() ? "" : " ") + trimmed(line);
        return;
    }
    const std::string row = trimmed(line);
    const std::size_t gap = row.find("  ");
    group.rows.push_back(
        {row.substr(0, gap), gap == std::string::npos ? "" : trimmed(row.substr(gap))});
}

}  // namespace

HelpText parse_help(const std::string& printed) {
    HelpText help;
    const std::vector<std::string> lines = lines_of(printed);
    bool in_group = false;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string& line = lines[i];
        const bool in_footer = !help.footer.empty();
        if (line.starts_with(kUsage) && help.usage.empty()) {
            help.usage = line.substr(kUsage.size());
        } else if (help.usage.empty()) {
            help.summary += (help.summary.empty() ? "" : " ") + trimmed(line);
        } else if (!in_footer && is_title(lines, i)) {
            help.groups.push_back({line.substr(0, line.size() - 1), {}});
            in_group = true;
        } else if (!in_footer && in_group && line.starts_with("  ")) {
            add_row_line(help.groups.back(), line);
        } else if (in_footer || !line.empty()) {
            help.footer += line + "\n";
        } else {
            in_group = false;
        }
    }
    help.summary = trimmed(help.summary);
    while (help.footer.ends_with("\n\n")) help.footer.pop_back();
    for (auto group = help.groups.begin(); group != help.groups.end();) {
        if (group->title != "Subcommands") {
            ++group;
            continue;
        }
        for (const HelpRow& row : group->rows) help.commands.push_back(row.name);
        group = help.groups.erase(group);
    }
    return help;
}

std::string output_of(const std::string& command) {
    struct Close {
        void operator()(std::FILE* pipe) const {
            if (pipe) pclose(pipe);
        }
    };
    std::unique_ptr<std::FILE, Close> pipe(popen(command.c_str(), "r"));
    if (!pipe) throw std::runtime_error("cannot run " + command);
    std::string text;
    char buffer[4096];
    for (std::size_t n; (n = std::fread(buffer, 1, sizeof buffer, pipe.get())) > 0;)
        text.append(buffer, n);
    if (pclose(pipe.release()) != 0) throw std::runtime_error("failed: " + command);
    return text;
}

}  // namespace burnish::test
