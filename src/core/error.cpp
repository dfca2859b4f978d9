#include "burnish/error.hpp"

#include <cstddef>

namespace burnish {
namespace {

constexpr std::size_t kShownBytes = 60;

bool is_control(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte < 0x20 || byte == 0x7F;
}

bool is_utf8_continuation(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

std::string with_controls_as_spaces(std::string text) {
    for (char& c : text) {
        if (is_control(c)) c = ' ';
    }
    return text;
}

std::string joined(std::string_view where, std::string_view key, std::string_view expected,
                   std::string_view found) {
    std::string line;
    const auto append = [&line](std::string_view separator, std::string_view word,
                                std::string_view part) {
        if (part.empty()) return;
        if (!line.empty()) line += separator;
        line += word;
        line += part;
    };
    append("", "", where);
    append(": ", "", key);
    append(": ", "expected ", expected);
    append(expected.empty() ? ": " : ", ", "found ", found);
    return line;
}

}  // namespace

Error::Error(const std::string& line) : std::runtime_error(with_controls_as_spaces(line)) {}

Error::Error(std::string_view where, std::string_view key, std::string_view expected,
             std::string_view found)
    : Error(joined(where, key, expected, found)) {}

std::string shown(std::string_view text) {
    std::size_t length = text.size();
    if (length > kShownBytes) {
        length = kShownBytes;
        while (length > 0 && is_utf8_continuation(text[length])) --length;
    }
    std::string result = "\"";
    for (const char c : text.substr(0, length)) result += is_control(c) ? '?' : c;
    result += length < text.size() ? "...\"" : "\"";
    return result;
}

std::string one_line(std::string_view text) {
    std::string result;
    for (const char c : text) {
        const bool space = is_control(c) || c == ' ';
        if (!space) {
            result += c;
        } else if (!result.empty() && result.back() != ' ') {
            result += ' ';
        }
    }
    if (!result.empty() && result.back() == ' ') result.pop_back();
    return result;
}

}  // namespace burnish
