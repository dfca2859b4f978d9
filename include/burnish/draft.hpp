// Weave drafts: which yarn lies on top where two yarns cross, and the yarns' colours.
//
// Warp yarns (ends) run along the bitangent, up the texture square, weft yarns (picks) along u. u
// grows with the number of the end. The first pick is at the bottom, as weavers draw it: at v = 1,
// as v runs down.
//
// Threads and lifetime: plain values; copies are independent, and any number of threads may read
// one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/api.hpp"

namespace BURNISH_API burnish {

// One repeat, which goes on in both directions.
struct Draft {
    std::string name;                    // "twill-2-2", or the title of a file
    int ends = 0, picks = 0;             // warp yarns (columns) and weft yarns (rows), >= 1
    std::vector<std::uint8_t> warp_up;   // picks x ends, first pick first; 1: the warp is on top
    std::vector<glm::vec3> warp_colors;  // one an end, linear; empty: the material's colour holds
    std::vector<glm::vec3> weft_colors;  // one a pick, or empty likewise

    bool is_warp_up(int end, int pick) const {
        return warp_up[static_cast<std::size_t>(pick) * static_cast<std::size_t>(ends) +
                       static_cast<std::size_t>(end)] != 0;
    }
};

inline constexpr int kMostDraftYarns = 4096;              // ends or picks of a repeat
inline constexpr std::int64_t kMostDraftCells = 1 << 22;  // ends times picks

// plain, twill-2-1, twill-2-2, twill-3-1, herringbone, satin-5, satin-8, basket: one textbook
// repeat each (docs/reference/drafts.md), without colours.
std::span<const std::string_view> draft_names();

// Throws UsageError "<where>: unknown weave 'x'; did you mean 'y'? ..." for another name.
Draft builtin_draft(std::string_view name, std::string_view where = "weave");

// Throws Error "<what>: <key>: expected ..., found ..." unless the sizes are within the limits, the
// lists as long as the sizes say, the cells 0 or 1 and the colours finite and not negative.
void check_draft(const Draft& draft, std::string_view what);

// The same for the sizes alone, before anything is allocated by them.
void check_draft_size(std::int64_t ends, std::int64_t picks, std::string_view what);

// Figures of the face of the cloth.
struct DraftFigures {
    double warp_share = 0.0;     // of the cells, 0..1
    int longest_warp_float = 0;  // picks that a warp yarn passes over in one go
    int longest_weft_float = 0;  // ends that a weft yarn passes over in one go
    int loose_ends = 0;          // warp yarns that never change sides: nothing holds them
    int loose_picks = 0;         // weft yarns likewise; both count as floats of one repeat
};
DraftFigures draft_figures(const Draft& draft);

}  // namespace burnish
