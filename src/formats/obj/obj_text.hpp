// Preprocesses an OBJ file: keeps the lines that are read, before the parser runs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace burnish {

struct ObjText {
    std::string geometry;  // v, vn, vt, f, usemtl and s lines only
    // Names after usemtl; usemtl lines in `geometry` hold indices into this.
    std::vector<std::string> materials;
    std::vector<std::string> libraries;  // file names after mtllib
    bool has_smoothing = false;          // the file has s lines
    // For lines that describe elements that are not drawn, and for numbers that are none.
    std::vector<std::string> warnings;
};

// Joins continued lines and sorts the lines. Throws Error naming `file` and the line for positions
// and faces that cannot be read (ObjNumbers).
ObjText sort_obj_lines(std::string_view text, const std::string& file);

// `text` without the mark of UTF-8 at its start.
std::string_view without_utf8_mark(std::string_view text);

// `text` without blanks at both ends.
std::string_view trimmed(std::string_view text);

}  // namespace burnish
