// Lines of a script as words, and words as values.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/error.hpp"

namespace burnish::viewer {

struct ScriptLine {
    int number = 0;                  // from 1
    std::string text;                // without the comment and the blanks around it
    std::vector<std::string> words;  // at least one
};

// The lines that have words. A comment begins with # at the start of a line, and with # and a blank
// behind words ("#ff8800" and "#2" are words). Throws Error for a quotation mark that is not closed
// and for control characters.
std::vector<ScriptLine> script_lines(std::string_view text, const std::string& name);

// The whole of the text as one finite number.
std::optional<double> number_of(std::string_view text);

// Hands out the words of a line in order. Functions throw Error "<name>: line 7: expected ..., found
// ..."; `what` is the expectation ("a file").
class WordReader {
  public:
    WordReader(const std::string& name, const ScriptLine& line) : name_(name), line_(line) {}

    [[noreturn]] void fail(std::string_view expected, std::string_view found) const;

    bool more() const { return at_ < line_.words.size(); }
    const std::string& peek() const { return line_.words[at_]; }
    const std::string& word(std::string_view what);
    // The index of the word in `names`; suggests the nearest one.
    int one_of(std::span<const std::string_view> names, std::string_view what);
    double number(std::string_view what, double low, double high);
    int whole(std::string_view what, int low, int high);
    std::vector<std::string> rest();
    void end();  // throws when there are more words

  private:
    const std::string& name_;
    const ScriptLine& line_;
    std::size_t at_ = 0;
};

// Errors of the parameter table that `work` throws, as errors of the line: "... expected <expected>, found
// <found>".
template <typename Work>
void in_line(const WordReader& words, const Work& work) {
    constexpr std::string_view kExpected = "expected ", kFound = ", found ";
    try {
        work();
    } catch (const UsageError& error) {
        const std::string line = error.what();
        const std::size_t expected = line.find(kExpected), found = line.rfind(kFound);
        if (expected == line.npos || found == line.npos || found < expected)
            words.fail("a value", line);
        const std::size_t begin = expected + kExpected.size();
        words.fail(line.substr(begin, found - begin), line.substr(found + kFound.size()));
    }
}

}  // namespace burnish::viewer
