// The colors of yarns in a WIF file. Private to the reader of drafts.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "burnish/wif.hpp"
#include "formats/wif/wif_text.hpp"

namespace burnish {

// Reads [COLOR PALETTE], [COLOR TABLE], [WARP COLORS], [WEFT COLORS] and the Color of [WARP] and
// [WEFT]. Values are parsed where a drawn yarn needs them.
class WifColors {
  public:
    explicit WifColors(const WifText& text);

    int count() const { return stated_ > 0 ? stated_ : rows_; }  // of the table

    // The number in the table of each yarn, 0 for none, -1 for what is no number; empty when the
    // family ("WARP", "WEFT") has no colors.
    std::vector<int> numbers(std::string_view family, int threads);

    // Linear colors of the yarns that are drawn; a yarn whose color is missing has the one of Color=
    // or is gray. Empty for empty `numbers` and where no yarn has a color. Throws Error for values
    // that are no colors.
    std::vector<glm::vec3> drawn(std::string_view family, const std::vector<int>& numbers,
                                 const WifYarns& yarns);

    // Rows that no drawn yarn can use: "2 rows of [WARP COLORS]".
    std::vector<std::string> passed_over() const;
    const std::vector<std::string>& warnings() const { return warnings_; }

  private:
    bool has(int number) const;  // the table does
    glm::vec3 color(int number);
    void warn_of_missing(std::string_view family, std::span<const int> numbers, bool has_usual);
    glm::vec3 parse(const WifEntry& row) const;
    void read_range();
    void guess_range();

    const WifText& text_;
    WifRows table_;
    std::vector<std::optional<glm::vec3>> known_;  // colors of the table that drawn yarns use
    int rows_ = 0;                                 // of the table
    int stated_ = 0;                               // its Entries; 0: not said
    int black_ = 0, white_ = 255;
    bool has_range_ = false, has_warned_ = false;
    std::vector<std::string> rows_beyond_, warnings_;
};

}  // namespace burnish
