// The shafts that each end is on and that each pick moves. Private to the reader of drafts.
#pragma once

#include <bitset>
#include <string>
#include <unordered_map>
#include <vector>

#include "formats/wif/wif_text.hpp"

namespace burnish {

inline constexpr int kMostShafts = 4096;  // a Jacquard loom has one per end
inline constexpr int kMostTreadles = 4096;

using Shafts = std::bitset<kMostShafts + 1>;  // bit 0 is unused: shafts count from 1

// One family of yarns: the set of each, by its number among the different sets.
class ShaftSets {
  public:
    explicit ShaftSets(int yarns) : of_(static_cast<std::size_t>(yarns)) { number_of(Shafts()); }

    void set(std::size_t yarn, const Shafts& shafts) { of_[yarn] = number_of(shafts); }
    std::size_t yarns() const { return of_.size(); }
    int number(std::size_t yarn) const { return of_[yarn]; }  // 0: no shaft
    const Shafts& at(std::size_t yarn) const { return sets_[static_cast<std::size_t>(of_[yarn])]; }
    const std::vector<Shafts>& different() const { return sets_; }
    Shafts all() const;  // of all yarns

  private:
    int number_of(const Shafts& shafts);

    std::vector<int> of_;
    std::vector<Shafts> sets_;
    std::unordered_map<Shafts, int> numbers_;
};

struct WifShafts {
    ShaftSets ends, picks;  // yarns count from 0
    int shafts = 0;         // what the file says, else the largest number that is used
    int treadles = 0;       // likewise
    bool has_liftplan = false;
    std::vector<std::string> passed_over;  // "4 rows of [TIEUP]"
    std::vector<std::string> warnings;
};

// Reads [THREADING], and [LIFTPLAN] or [TIEUP] with [TREADLING]. docs/reference/drafts.md states the
// rules. Throws Error for what is missing, broken or contradicts itself in a drawn crossing.
WifShafts read_wif_shafts(const WifText& text, int ends, int picks);

}  // namespace burnish
