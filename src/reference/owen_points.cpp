#include "reference/owen_points.hpp"

namespace burnish {
namespace {

constexpr std::uint32_t reversed(std::uint32_t x) {
    x = ((x >> 1) & 0x55555555U) | ((x & 0x55555555U) << 1);
    x = ((x >> 2) & 0x33333333U) | ((x & 0x33333333U) << 2);
    x = ((x >> 4) & 0x0f0f0f0fU) | ((x & 0x0f0f0f0fU) << 4);
    x = ((x >> 8) & 0x00ff00ffU) | ((x & 0x00ff00ffU) << 8);
    return (x >> 16) | (x << 16);
}

// Of a word with its bits reversed: every bit is flipped by a hash of the bits below it, which were above. The
// permutation of Laine and Karras 2011 with the constants of Burley.
constexpr std::uint32_t scrambled_reversed(std::uint32_t x, std::uint32_t seed) {
    x += seed;
    x ^= x * 0x6c50b47cU;
    x ^= x * 0xb82f1e52U;
    x ^= x * 0xc7afe638U;
    x ^= x * 0x8d22f6e6U;
    return x;
}

using Directions = std::array<std::uint32_t, 32>;

// Direction numbers of a primitive polynomial over GF(2) of this degree whose inner coefficients are the bits of
// `inner`, from the first ones (Bratley and Fox 1988).
constexpr Directions directions(unsigned degree, std::uint32_t inner,
                                std::array<std::uint32_t, 3> first) {
    Directions v{};
    for (unsigned i = 0; i < 32; ++i) {
        if (i < degree) {
            v[i] = first[i] << (31 - i);
            continue;
        }
        v[i] = v[i - degree] ^ (v[i - degree] >> degree);
        for (unsigned k = 1; k < degree; ++k)
            if ((inner >> (degree - 1 - k)) & 1U) v[i] ^= v[i - k];
    }
    return v;
}

// By coordinate, byte of the index and its value; bits reversed.
using Table = std::array<std::array<std::array<std::uint32_t, 256>, 4>, 4>;

// A byte is the sum of its lowest bit and the rest, whose entry stands before it.
constexpr Table table_of_bytes() {
    Directions corput{};
    for (unsigned i = 0; i < 32; ++i) corput[i] = 1U << (31 - i);
    // The first four dimensions of Joe and Kuo 2008.
    const std::array<Directions, 4> all = {corput, directions(1, 0, {1, 0, 0}),
                                           directions(2, 1, {1, 3, 0}),
                                           directions(3, 1, {1, 3, 1})};
    Table table{};
    for (std::size_t d = 0; d < 4; ++d)
        for (std::size_t byte = 0; byte < 4; ++byte)
            for (std::size_t value = 1; value < 256; ++value) {
                std::size_t bit = 0;
                while (((value >> bit) & 1U) == 0) ++bit;
                table[d][byte][value] =
                    table[d][byte][value & (value - 1)] ^ reversed(all[d][8 * byte + bit]);
            }
    return table;
}

constexpr Table kTable = table_of_bytes();

std::uint32_t reversed_sobol(std::uint32_t index, std::size_t coordinate) {
    const auto& bytes = kTable[coordinate];
    return bytes[0][index & 255U] ^ bytes[1][(index >> 8) & 255U] ^ bytes[2][(index >> 16) & 255U] ^
           bytes[3][index >> 24];
}

}  // namespace

std::uint32_t mixed_bits(std::uint32_t a, std::uint32_t b) {
    // The finalizer of MurmurHash3 over both.
    std::uint32_t x = a ^ (b * 0x9e3779b9U + 0x85ebca6bU + (a << 6) + (a >> 2));
    x ^= x >> 16;
    x *= 0x85ebca6bU;
    x ^= x >> 13;
    x *= 0xc2b2ae35U;
    x ^= x >> 16;
    return x;
}

std::array<float, 4> owen_point(std::uint32_t index, std::uint32_t set) {
    const std::uint32_t shuffled = reversed(scrambled_reversed(reversed(index), set));
    std::array<float, 4> point{};
    for (std::size_t d = 0; d < 4; ++d) {
        const std::uint32_t bits = reversed(scrambled_reversed(
            reversed_sobol(shuffled, d), mixed_bits(set, static_cast<std::uint32_t>(d) + 1)));
        // 24 bits: the next float below 1 is the largest.
        point[d] = static_cast<float>(bits >> 8) * 0x1p-24f;
    }
    return point;
}

}  // namespace burnish
