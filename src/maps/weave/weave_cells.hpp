// What a draft says of each crossing of yarns, in the words of shading/surface/weave.glsl.
#pragma once

#include <cstdint>
#include <vector>

#include "burnish/draft.hpp"
#include "burnish/f32.hpp"

namespace burnish {

// `end`, `pick`: any whole numbers; the draft repeats.
f32::WeaveCell weave_cell(const Draft& draft, int end, int pick);

// The cell in five bits: 1 warp_up, 2 warp_start, 4 warp_end, 8 weft_start, 16 weft_end.
std::uint8_t weave_cell_bits(const f32::WeaveCell& cell);
// picks x ends, first pick first.
std::vector<std::uint8_t> weave_bits(const Draft& draft);

// One system of yarns over a repeat: how often it is above and how often it passes from side to
// side, which is all that a mean over many cells needs.
struct WeaveFamily {
    double upper = 0;  // share of the cells in which its yarns are above
    double bends = 0;  // passages from one side to the other, a cell
};

struct WeaveFamilies {
    WeaveFamily weft, warp;
};
WeaveFamilies weave_families(const Draft& draft);

// Share of the area on which the family shows, through gaps between yarns above it too.
double weave_coverage(const WeaveFamily& family, float gap);

// The surface of a family as it is seen, by its slopes in the yarn's own axes.
struct WeaveSlope {
    float along = 0;  // the yarn
    float across = 0;
    float weight = 0;  // all weights add up to 1, unless the family is not seen anywhere: none then
};

// By the midpoint rule of yarn_point, steps_across x steps_along over each kind of piece: above and
// below, bent and not.
std::vector<WeaveSlope> weave_slopes(const WeaveFamily& family, const f32::WeaveShape& shape,
                                     int steps_across, int steps_along);

}  // namespace burnish
