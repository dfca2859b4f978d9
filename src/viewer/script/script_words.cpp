#include "viewer/script/script_words.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "burnish/error.hpp"
#include "core/text.hpp"

namespace burnish::viewer {
namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

std::string place_of_line(int number) {
    return fmt::format("line {}", number);
}

// The word that begins at `at`, which moves behind it.
std::string take_word(std::string_view line, std::size_t& at, const std::string& name, int number) {
    std::string word;
    if (line[at] != '"') {
        while (at < line.size() && !is_blank(line[at])) word += line[at++];
        return word;
    }
    for (++at; at < line.size() && line[at] != '"'; ++at) {
        const bool escape = line[at] == '\\' && at + 1 < line.size() &&
                            (line[at + 1] == '"' || line[at + 1] == '\\');
        word += line[escape ? ++at : at];
    }
    if (at >= line.size())
        throw Error(name, place_of_line(number), "a closing quotation mark", "the end of the line");
    ++at;
    if (at < line.size() && !is_blank(line[at]))
        throw Error(name, place_of_line(number), "a blank behind a quoted word",
                    shown(line.substr(at)));
    return word;
}

bool is_comment(std::string_view line, std::size_t at, bool first) {
    return line[at] == '#' && (first || at + 1 == line.size() || is_blank(line[at + 1]));
}

ScriptLine line_of(std::string_view line, const std::string& name, int number) {
    ScriptLine out;
    out.number = number;
    std::size_t at = 0, end = 0;
    const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
    for (;;) {
        while (at < line.size() && is_blank(line[at])) ++at;
        if (at == line.size() || is_comment(line, at, out.words.empty())) break;
        out.words.push_back(take_word(line, at, name, number));
        end = at;
    }
    if (!out.words.empty()) out.text = line.substr(begin, end - begin);
    return out;
}

}  // namespace

std::vector<ScriptLine> script_lines(std::string_view text, const std::string& name) {
    std::vector<ScriptLine> lines;
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    for (int number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.ends_with('\r')) line.remove_suffix(1);
        for (const char c : line)
            if (static_cast<unsigned char>(c) < 0x20 && c != '\t')
                throw Error(name, place_of_line(number), "text", "a control character");
        ScriptLine read = line_of(line, name, number);
        if (!read.words.empty()) lines.push_back(std::move(read));
    }
    return lines;
}

std::optional<double> number_of(std::string_view text) {
    double value = 0.0;
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

void WordReader::fail(std::string_view expected, std::string_view found) const {
    throw Error(name_, place_of_line(line_.number), expected, found);
}

const std::string& WordReader::word(std::string_view what) {
    if (!more()) fail(what, "the end of the line");
    if (peek().empty()) fail(what, "an empty word");
    return line_.words[at_++];
}

int WordReader::one_of(std::span<const std::string_view> names, std::string_view what) {
    const std::string expected = fmt::format("{} ({})", what, fmt::join(names, " "));
    const std::string& found = word(expected);
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == found) return static_cast<int>(i);
    const std::string_view nearest = nearest_name(names, found);
    fail(expected, nearest.empty() ? shown(found)
                                   : fmt::format("{}; did you mean '{}'?", shown(found), nearest));
}

double WordReader::number(std::string_view what, double low, double high) {
    const std::string expected = fmt::format("{}, a number from {:g} to {:g}", what, low, high);
    const std::string& found = word(expected);
    const std::optional<double> value = number_of(found);
    if (!value || *value < low || *value > high) fail(expected, shown(found));
    return *value;
}

int WordReader::whole(std::string_view what, int low, int high) {
    const std::string expected = fmt::format("{}, a whole number from {} to {}", what, low, high);
    const std::string& found = word(expected);
    int value = 0;
    const auto [end, error] = std::from_chars(found.data(), found.data() + found.size(), value);
    if (error != std::errc() || end != found.data() + found.size() || value < low || value > high)
        fail(expected, shown(found));
    return value;
}

std::vector<std::string> WordReader::rest() {
    std::vector<std::string> words;
    while (more()) words.push_back(word("a word that is not empty"));
    return words;
}

void WordReader::end() {
    if (more()) fail("the end of the line", shown(peek()));
}

}  // namespace burnish::viewer
