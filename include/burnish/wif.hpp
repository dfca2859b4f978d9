// Weaving drafts from WIF files (Weaving Information File 1.1, Ravi Nielsen and others, 1997), and
// back. docs/reference/drafts.md says what is read, what is passed over, and how open points are decided.
//
// Threads: any number may call these functions at a time. Lifetime: what they return refers to
// nothing else.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/draft.hpp"

namespace BURNISH_API burnish {

// A draft with what the file says of the loom.
struct WifFile {
    Draft draft;
    int shafts = 0, treadles = 0;
    int colors = 0;             // of the colour table
    bool rising_shed = true;    // the loom lifts the shafts that are named; else it lowers them
    bool has_liftplan = false;  // else a tie-up and treadling
    std::vector<std::string> warnings;
};

// Throws Error naming file, section, key and line for what is broken, contradictory or beyond the
// limits; nothing is allocated by a number that has not been checked.
WifFile read_wif(const std::filesystem::path& path);

// The draft alone; adds to `warnings`.
Draft load_wif(const std::filesystem::path& path, std::vector<std::string>& warnings);

// Told by its name (.wif), so that a broken one is refused as what it is, or by content: a file
// that starts with [WIF].
bool is_wif_file(const std::filesystem::path& path);

// The draft as a file for weaving programs: a lift plan, one shaft for each different end.
// Colours are rounded to 8 bits. The draft must hold (check_draft).
std::string wif_text(const Draft& draft);

}  // namespace burnish
