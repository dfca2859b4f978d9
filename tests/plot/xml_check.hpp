// Is a text well-formed XML, as far as our SVG files go: one root, elements closed in order, quoted
// attributes that are named once, known entities, UTF-8.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace burnish::test {

struct XmlElement {
    std::string name;
    std::map<std::string, std::string> attributes;
    std::string text;  // of the element and everything in it
};

// All elements in the order of their ends. Throws std::runtime_error saying what is wrong where.
std::vector<XmlElement> parse_xml(const std::string& text);

}  // namespace burnish::test
