// The crossings of a draft in the terms of shading/surface/weave.glsl.
#pragma once

#include <cstdint>
#include <vector>

#include "burnish/draft.hpp"
#include "burnish/f32.hpp"

namespace burnish {

// Repeats of a draft of `yarns` ends or picks that a tile shows where nobody says how many: at least
// 16 yarns a side.
constexpr int usual_repeats(int yarns) {
    constexpr int kUsualYarns = 16;
    return (kUsualYarns + yarns - 1) / yarns;
}

// The cell at any whole numbers `end`, `pick`; the draft repeats.
f32::WeaveCell weave_cell(const Draft& draft, int end, int pick);

// The cell in five bits: 1 warp_up, 2 warp_start, 4 warp_end, 8 weft_start, 16 weft_end.
std::uint8_t weave_cell_bits(const f32::WeaveCell& cell);
// picks x ends, first pick first.
std::vector<std::uint8_t> weave_bits(const Draft& draft);

// One system of yarns over a repeat: the fraction of cells on top and the number of passages
// between sides. Means over many cells need nothing else.
struct WeaveFamily {
    double upper = 0;  // fraction of the cells in which its yarns are on top
    double bends = 0;  // passages between the sides per cell
};

struct WeaveFamilies {
    WeaveFamily weft, warp;
};
WeaveFamilies weave_families(const Draft& draft);

// Fraction of the area on which the family is visible, including through gaps between the yarns
// above it.
double weave_coverage(const WeaveFamily& family, float gap);

// A sample of the visible surface of a family: slopes in the yarn's axes, and a weight.
struct WeaveSlope {
    float along = 0;  // the yarn
    float across = 0;
    float weight = 0;  // all weights add up to 1; no samples for an invisible family
};

// Samples by the midpoint rule of yarn_point, steps_across x steps_along on each kind of piece:
// above and below, bent and not.
std::vector<WeaveSlope> weave_slopes(const WeaveFamily& family, const f32::WeaveShape& shape,
                                     int steps_across, int steps_along);

}  // namespace burnish
