// Text as XML, and valid UTF-8 from any bytes. Private to the canvas.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace burnish::plot {

// Bytes that are no UTF-8 become U+FFFD, control characters spaces.
std::string valid_utf8(std::string_view text);

// The same, escaped for an attribute or the text of an element.
std::string xml_escaped(std::string_view text);

// A part of a text such as "h_{x}": level 0 on the line, 1 raised, -1 lowered.
struct TextPart {
    std::string text;
    int level = 0;
};
std::vector<TextPart> parts_of(std::string_view text);
std::string without_markup(std::string_view text);

// <title>, <desc> and <metadata>, in which "burnish:command" is an element of that name; other
// names become <burnish:entry name="...">.
std::string svg_header(std::string_view title, std::string_view description,
                       const std::map<std::string, std::string>& metadata);

}  // namespace burnish::plot
