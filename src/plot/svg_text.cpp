#include "plot/svg_text.hpp"

#include <algorithm>
#include <cctype>

#include "core/utf8.hpp"

namespace burnish::plot {
namespace {

// Length of the UTF-8 character at the start of `text`; 0 where there is none that XML takes: U+FFFE
// and U+FFFF may not stand in it.
std::size_t character_length(std::string_view text) {
    const bool last = text.starts_with("\xEF\xBF\xBE") || text.starts_with("\xEF\xBF\xBF");
    return last ? 0 : utf8_length(text);
}

bool is_element_name(std::string_view name) {
    const auto plain = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
    };
    return !name.empty() && std::isalpha(static_cast<unsigned char>(name.front())) != 0 &&
           std::all_of(name.begin(), name.end(), plain);
}

}  // namespace

std::string valid_utf8(std::string_view text) {
    std::string valid;
    while (!text.empty()) {
        const std::size_t length = character_length(text);
        if (length == 0) {
            valid += "\uFFFD";
        } else if (length == 1 && (static_cast<unsigned char>(text[0]) < 0x20 || text[0] == 0x7F)) {
            valid += ' ';
        } else {
            valid += text.substr(0, length);
        }
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return valid;
}

std::string xml_escaped(std::string_view text) {
    std::string escaped;
    for (const char c : valid_utf8(text)) {
        switch (c) {
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '&':
                escaped += "&amp;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            default:
                escaped += c;
        }
    }
    return escaped;
}

std::vector<TextPart> parts_of(std::string_view text) {
    const std::string valid = valid_utf8(text);
    std::vector<TextPart> parts;
    const auto add = [&](std::string_view piece, int level) {
        if (!piece.empty()) parts.push_back({std::string(piece), level});
    };
    std::string_view rest = valid;
    while (!rest.empty()) {
        const std::size_t lower = rest.find("_{"), upper = rest.find("^{");
        const std::size_t at = std::min(lower, upper);
        const std::size_t end = at == rest.npos ? at : rest.find('}', at);
        if (end == rest.npos) {
            add(rest, 0);
            break;
        }
        add(rest.substr(0, at), 0);
        add(rest.substr(at + 2, end - at - 2), at == upper ? 1 : -1);
        rest.remove_prefix(end + 1);
    }
    return parts;
}

std::string without_markup(std::string_view text) {
    std::string plain;
    for (const TextPart& part : parts_of(text))
        plain += (part.level > 0 ? "^" : part.level < 0 ? "_" : "") + part.text;
    return plain;
}

std::string svg_header(std::string_view title, std::string_view description,
                       const std::map<std::string, std::string>& metadata) {
    constexpr std::string_view kOurs = "burnish:";
    std::string text;
    if (!title.empty()) text += "<title>" + xml_escaped(without_markup(title)) + "</title>\n";
    if (!description.empty())
        text += "<desc>" + xml_escaped(without_markup(description)) + "</desc>\n";
    text += "<metadata xmlns:burnish=\"urn:burnish\">\n";
    for (const auto& [name, value] : metadata) {
        const std::string_view own =
            name.starts_with(kOurs) ? std::string_view(name).substr(kOurs.size()) : "";
        if (is_element_name(own)) {
            text += "<burnish:" + std::string(own) + ">" + xml_escaped(value) +
                    "</burnish:" + std::string(own) + ">\n";
        } else {
            text += "<burnish:entry name=\"" + xml_escaped(name) + "\">" + xml_escaped(value) +
                    "</burnish:entry>\n";
        }
    }
    return text + "</metadata>\n";
}

}  // namespace burnish::plot
