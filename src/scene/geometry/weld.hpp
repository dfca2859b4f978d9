// Finding equal vertices.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <vector>

namespace burnish {

// Bits of a float such that equal numbers have equal bits.
inline std::uint32_t weld_bits(float value) {
    return std::bit_cast<std::uint32_t>(value == 0.0f ? 0.0f : value);  // -0 is 0
}

struct Welding {
    std::vector<std::uint32_t> ids;  // class number of each item
    std::uint32_t classes = 0;       // number of classes; numbers are in order of first appearance
};

// Classes of equal keys. `key(i, out)` writes the words of item i.
template <std::size_t kWords, class Key>
Welding weld(std::size_t count, const Key& key) {
    constexpr std::uint32_t kEmpty = ~std::uint32_t{0};
    using Words = std::uint32_t[kWords];
    // Open addressing, at most half full.
    const std::size_t slots = std::bit_ceil(2 * count + 1);
    std::vector<std::uint32_t> table(slots, kEmpty);  // a member of the class in this slot
    Welding welding;
    welding.ids.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        Words words;
        key(i, words);
        std::uint64_t hash = 0x9E3779B97F4A7C15u;
        for (const std::uint32_t word : words) {
            hash = (hash ^ word) * 0xD6E8FEB86659FD93u;
            hash ^= hash >> 32;
        }
        std::size_t slot = static_cast<std::size_t>(hash) & (slots - 1);
        for (;; slot = (slot + 1) & (slots - 1)) {
            if (table[slot] == kEmpty) {
                table[slot] = static_cast<std::uint32_t>(i);
                welding.ids[i] = welding.classes++;
                break;
            }
            Words other;
            key(table[slot], other);
            if (std::equal(std::begin(words), std::end(words), std::begin(other))) {
                welding.ids[i] = welding.ids[table[slot]];
                break;
            }
        }
    }
    return welding;
}

}  // namespace burnish
