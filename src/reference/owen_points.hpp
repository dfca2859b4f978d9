// Random numbers of a path: Sobol points (1967), four numbers at a time, scrambled as Owen has it by a hash (Burley,
// "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020). Every number is a function of seed, pixel, sample and group
// alone: it does not depend on the thread that asks, nor on what was drawn before.
#pragma once

#include <array>
#include <cstdint>

namespace burnish {

// A hash of two words.
std::uint32_t mixed_bits(std::uint32_t a, std::uint32_t b);

// The four coordinates of point `index` of one scrambled set, in [0, 1). The first 2^k points of a set are stratified
// in all pairs of coordinates.
std::array<float, 4> owen_point(std::uint32_t index, std::uint32_t set);

class PathPoints {
  public:
    PathPoints(std::uint32_t seed, std::uint32_t pixel, std::uint32_t sample)
        : set_(mixed_bits(mixed_bits(seed, 0x9e3779b9U), pixel)), sample_(sample) {}

    // Sets of different groups are independent of one another.
    std::array<float, 4> group(std::uint32_t number) const {
        return owen_point(sample_, mixed_bits(set_, number));
    }

  private:
    std::uint32_t set_, sample_;
};

}  // namespace burnish
