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

// The yarns of one family in the file, and those of them that are the draft.
struct WifYarns {
    int threads = 0;  // in the file
    int first = 0;    // number of the first drawn one, from 0
    int used = 0;     // without the yarns at both sides that are on no shaft
    int repeat = 0;  // the smallest repeat of the used ones, with their colours; `used` without one
    int drawn = 0;   // from the first one
};

// A draft with what the file says of the loom.
struct WifFile {
    Draft draft;
    WifYarns warp, weft;
    int shafts = 0, treadles = 0;
    int colors = 0;             // in the colour table
    bool rising_shed = true;    // the loom lifts the shafts that are named; else it lowers them
    bool has_liftplan = false;  // else a tie-up and treadling
    std::vector<std::string> warnings;
};

// Throws Error naming file, section, key and line for what is broken or contradictory and changes a
// drawn crossing or its colours, and for numbers beyond the limits; nothing is allocated by a number
// that has not been checked. A file of any size within the limits gives a draft that check_draft
// takes: docs/reference/drafts.md says which part of a large one is drawn.
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
