#include "markdown.hpp"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <regex>
#include <stdexcept>

namespace burnish::test {
namespace {

bool is_word(char c) {
    const auto u = static_cast<unsigned char>(c);
    return std::isalnum(u) != 0 || c == '_' || u >= 0x80;
}

std::string lower(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

bool is_blank(const std::string& text) {
    return text.find_first_not_of(" \t") == std::string::npos;
}

std::string without_code(const std::string& line) {
    return std::regex_replace(line, std::regex("`[^`]*`"), "");
}

}  // namespace

Page read_page(const std::filesystem::path& file) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error("cannot read " + file.string());
    Page page{file, {}, {}};
    bool fenced = false, indented = false, blank_before = true;
    std::string text;
    for (int number = 1; std::getline(in, text); ++number) {
        page.all.push_back({number, text});
        const std::size_t start = text.find_first_not_of(' ');
        if (start != std::string::npos && text.compare(start, 3, "```") == 0) {
            fenced = !fenced;
            blank_before = false;
            continue;
        }
        // Four spaces after a blank line start a block of code, unless a list goes on there.
        const bool deep = text.starts_with("    ");
        const bool item = start != std::string::npos &&
                          std::string("-*0123456789").find(text[start]) != std::string::npos;
        indented = deep && !item && (indented || blank_before);
        blank_before = is_blank(text) || (indented && blank_before);
        if (!fenced && !indented) page.prose.push_back({number, text});
    }
    return page;
}

std::vector<std::string> links_of(const std::string& line) {
    static const std::regex link(R"(\]\(([^()\s]+)\))");
    std::vector<std::string> targets;
    const std::string text = without_code(line);
    for (std::sregex_iterator at(text.begin(), text.end(), link), end; at != end; ++at)
        targets.push_back((*at)[1]);
    return targets;
}

std::vector<std::string> code_spans_of(const std::string& line) {
    static const std::regex span("`([^`]+)`");
    std::vector<std::string> spans;
    for (std::sregex_iterator at(line.begin(), line.end(), span), end; at != end; ++at)
        spans.push_back((*at)[1]);
    return spans;
}

std::string github_anchor(const std::string& heading) {
    std::string anchor;
    for (const char c : lower(heading)) {
        if (is_word(c) || c == '-') anchor += c;
        if (c == ' ') anchor += '-';
    }
    return anchor;
}

std::string mkdocs_anchor(const std::string& heading) {
    std::string anchor;
    for (const char c : lower(heading)) {
        const bool gap = c == ' ' || c == '-';
        if (gap && (anchor.empty() || anchor.back() != '-')) anchor += '-';
        if (is_word(c) && static_cast<unsigned char>(c) < 0x80) anchor += c;
    }
    return anchor;
}

std::vector<std::string> headings_of(const Page& page) {
    static const std::regex heading("^#{1,6} +(.*)$");
    static const std::regex link(R"(\[([^\]]*)\]\([^)]*\))");
    std::vector<std::string> texts;
    for (const PageLine& line : page.prose) {
        std::smatch match;
        if (!std::regex_match(line.text, match, heading)) continue;
        std::string text = std::regex_replace(match[1].str(), link, "$1");
        text.erase(std::remove(text.begin(), text.end(), '`'), text.end());
        texts.push_back(text);
    }
    return texts;
}

int columns_of(const std::string& line) {
    return static_cast<int>(std::count_if(line.begin(), line.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    }));
}

}  // namespace burnish::test
