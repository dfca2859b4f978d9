// The text of a material library: its keys as the parser spells them, and those of each material.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace burnish {

// The keys of a material with the rest of their lines. Keys are spelled as in MtlText.
using MtlKeys = std::map<std::string, std::string>;

struct MtlText {
    // With every known key in the letters that the parser knows (some programs write MAP_KD), and
    // the options of maps before the picture's name, with all of their numbers.
    std::string text;
    std::map<std::string, MtlKeys> materials;  // by name
    // A material, and what its file says that is no number, or none in the range of its key: "Pr: 3
    // is not from 0 to 1: 1 is used". What is used stands in `text` and `materials`.
    std::vector<std::pair<std::string, std::string>> remarks;
};

MtlText read_mtl_text(std::string_view text);

// A key that says something of the look that is not drawn. Keys without a meaning here (Ka, illum)
// and values that say "none" (Pc 0) are none.
bool is_lost_mtl_key(const std::string& key, const std::string& value);

}  // namespace burnish
