// Points that fill a cube evenly, however many are taken.
#pragma once

#include <array>
#include <cmath>

namespace burnish {

// The i-th in [0, 1)^3: Roberts' R2 sequence ("The Unreasonable Effectiveness of Quasirandom
// Sequences", 2018) and the golden ratio, from the middle.
inline std::array<double, 3> even_point(int i) {
    return {std::fmod(0.5 + 0.7548776662466927 * i, 1.0),
            std::fmod(0.5 + 0.5698402909980532 * i, 1.0),
            std::fmod(0.5 + 0.6180339887498949 * i, 1.0)};
}

}  // namespace burnish
