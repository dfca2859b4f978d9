// Which yarns of a file are drawn: its used part, its repeat, or a part of a draft that is too large.
// Private to the reader of drafts.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "burnish/wif.hpp"
#include "formats/wif/wif_shafts.hpp"

namespace burnish {

// The smallest p with sequence[i] == sequence[i + p] for every i that has both; the length when no
// smaller one is there, 0 for an empty sequence. Linear in time.
int smallest_period(std::span<const int> sequence);

// The classes of yarns that look alike in the whole cloth: ends that are up at the same picks, and
// picks that lift the same ends. Yarns of different shafts may look alike; that is found where the
// different sets of ends and of picks cross at most kMostDraftCells times.
struct YarnClasses {
    std::vector<int> ends, picks;  // by yarn
};
YarnClasses yarn_classes(const ShaftSets& ends, const ShaftSets& picks);

// Cuts yarns without a shaft off both sides; nothing when all of them are.
WifYarns used_yarns(const ShaftSets& sets);

// Sets `repeat` and `drawn` of both families, whose `first` and `used` are set. `alike` gives numbers
// of yarns that look alike, with their colors.
//
// A side of more than kWholeYarns yarns is cut to one repeat where it is a whole number of them: the
// cloth stays the same. A draft that is still too large is cut to repeats that leave a rest, then to
// the largest part that is drawn.
inline constexpr int kWholeYarns = 256;
void choose_drawn(WifYarns& warp, WifYarns& weft, const YarnClasses& alike);

}  // namespace burnish
