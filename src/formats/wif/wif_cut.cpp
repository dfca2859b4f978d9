#include "formats/wif/wif_cut.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <unordered_map>

namespace burnish {

namespace {

// Numbers the rows of a table of bits, `width` long each, so that equal rows have equal numbers.
std::vector<int> row_classes(const std::vector<bool>& table, std::size_t width) {
    std::unordered_map<std::vector<bool>, int> numbers;
    std::vector<int> classes;
    for (auto row = table.begin(); row != table.end(); row += static_cast<std::ptrdiff_t>(width)) {
        std::vector<bool> bits(row, row + static_cast<std::ptrdiff_t>(width));
        const int next = static_cast<int>(numbers.size());
        classes.push_back(numbers.try_emplace(std::move(bits), next).first->second);
    }
    return classes;
}

std::vector<int> classes_of(const ShaftSets& sets, const std::vector<int>& class_of_set) {
    std::vector<int> classes(sets.yarns());
    for (std::size_t i = 0; i < classes.size(); ++i)
        classes[i] = class_of_set[static_cast<std::size_t>(sets.number(i))];
    return classes;
}

std::vector<int> set_numbers(const ShaftSets& sets) {
    std::vector<int> numbers(sets.yarns());
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = sets.number(i);
    return numbers;
}

// Twice is the least that tells a repeat from a draft that ends as it begins.
int repeat_of(const WifYarns& yarns, const std::vector<int>& alike) {
    const int period = smallest_period(std::span<const int>(alike).subspan(
        static_cast<std::size_t>(yarns.first), static_cast<std::size_t>(yarns.used)));
    return 2 * period <= yarns.used ? period : yarns.used;
}

bool is_too_large(const WifYarns& warp, const WifYarns& weft) {
    return warp.drawn > kMostDraftYarns || weft.drawn > kMostDraftYarns ||
           std::int64_t{warp.drawn} * weft.drawn > kMostDraftCells;
}

// The larger side gives way first.
void crop(WifYarns& warp, WifYarns& weft) {
    warp.drawn = std::min(warp.drawn, kMostDraftYarns);
    weft.drawn = std::min(weft.drawn, kMostDraftYarns);
    if (!is_too_large(warp, weft)) return;
    const auto square = static_cast<int>(std::sqrt(static_cast<double>(kMostDraftCells)));
    WifYarns& larger = warp.drawn >= weft.drawn ? warp : weft;
    WifYarns& smaller = warp.drawn >= weft.drawn ? weft : warp;
    smaller.drawn = std::min(smaller.drawn, square);
    larger.drawn = static_cast<int>(kMostDraftCells / smaller.drawn);
}

}  // namespace

int smallest_period(std::span<const int> sequence) {
    // border[i]: the length of the longest part before i that is both its start and its end, as in
    // the search of Knuth, Morris and Pratt (1977).
    std::vector<std::size_t> border(sequence.size() + 1);
    std::size_t length = 0;
    for (std::size_t i = 1; i < sequence.size(); ++i) {
        while (length > 0 && sequence[i] != sequence[length]) length = border[length];
        if (sequence[i] == sequence[length]) ++length;
        border[i + 1] = length;
    }
    return static_cast<int>(sequence.size() - border.back());
}

YarnClasses yarn_classes(const ShaftSets& ends, const ShaftSets& picks) {
    const std::vector<Shafts>&warp = ends.different(), &weft = picks.different();
    if (warp.size() > static_cast<std::size_t>(kMostDraftCells) / weft.size())
        return {set_numbers(ends), set_numbers(picks)};
    std::vector<bool> up(warp.size() * weft.size()), turned(up.size());
    for (std::size_t e = 0; e < warp.size(); ++e)
        for (std::size_t p = 0; p < weft.size(); ++p)
            up[e * weft.size() + p] = turned[p * warp.size() + e] = (warp[e] & weft[p]).any();
    return {classes_of(ends, row_classes(up, weft.size())),
            classes_of(picks, row_classes(turned, warp.size()))};
}

WifYarns used_yarns(const ShaftSets& sets) {
    WifYarns yarns;
    yarns.threads = static_cast<int>(sets.yarns());
    int first = 0, last = yarns.threads - 1;
    while (first <= last && sets.number(static_cast<std::size_t>(first)) == 0) ++first;
    while (first < last && sets.number(static_cast<std::size_t>(last)) == 0) --last;
    const bool none = first > last;
    yarns.first = none ? 0 : first;
    yarns.used = none ? yarns.threads : last - first + 1;
    return yarns;
}

void choose_drawn(WifYarns& warp, WifYarns& weft, const YarnClasses& alike) {
    warp.repeat = repeat_of(warp, alike.ends);
    weft.repeat = repeat_of(weft, alike.picks);
    for (WifYarns* yarns : {&warp, &weft}) {
        const bool whole_repeats = yarns->used % yarns->repeat == 0;
        yarns->drawn = whole_repeats && yarns->used > kWholeYarns ? yarns->repeat : yarns->used;
    }
    for (WifYarns* yarns : {&warp, &weft})
        if (is_too_large(warp, weft)) yarns->drawn = yarns->repeat;
    if (is_too_large(warp, weft)) crop(warp, weft);
}

}  // namespace burnish
