// The lines of an OBJ file that are read, before any parser sees them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

struct ObjText {
    std::string geometry;                // v, vn, vt, f, usemtl and s lines alone
    std::vector<std::string> materials;  // names after usemtl; the lines above say their number
    std::vector<std::string> libraries;  // file names after mtllib
    bool has_smoothing = false;          // there are s lines
    std::vector<std::string> warnings;   // of lines that describe something that is not drawn
};

// Joins continued lines and sorts the lines. Throws Error naming `file` and the line for faces with
// more than 255 corners (the parser counts them in a byte).
ObjText sort_obj_lines(std::string_view text, const std::string& file);

// `text` without blanks at both ends.
std::string_view trimmed(std::string_view text);

}  // namespace burnish
