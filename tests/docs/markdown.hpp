// The little of Markdown that the tests of the pages need: lines outside code blocks, links, code
// spans and the anchors of headings.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace burnish::test {

struct PageLine {
    int number = 0;  // from 1
    std::string text;
};

struct Page {
    std::filesystem::path file;
    std::vector<PageLine> all;    // every line
    std::vector<PageLine> prose;  // lines outside fenced and indented code blocks
};

// Throws std::runtime_error when the file cannot be read.
Page read_page(const std::filesystem::path& file);

// Targets of [text](target) and ![text](target) in a line, code spans left out.
std::vector<std::string> links_of(const std::string& line);

// Contents of `code spans` in a line.
std::vector<std::string> code_spans_of(const std::string& line);

// The anchor of a heading, as GitHub makes it and as Python-Markdown does. They differ where
// punctuation stands between words.
std::string github_anchor(const std::string& heading);
std::string mkdocs_anchor(const std::string& heading);

// The texts of the headings of a page, without # and code marks, links reduced to their texts.
std::vector<std::string> headings_of(const Page& page);

// Columns of a line of UTF-8: code points.
int columns_of(const std::string& line);

}  // namespace burnish::test
