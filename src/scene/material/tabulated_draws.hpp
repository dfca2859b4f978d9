// Drawing half vectors from a distribution that is a table.
#pragma once

#include <vector>

#include "burnish/ndf_grid.hpp"

namespace burnish {

// How half vectors of one table are drawn: evenly within cells, of which each is drawn as often as
// its light weighs, and its neighbours' (values are read between cells), and a little besides.
struct TabulatedDraws {
    std::vector<float> cells;    // per cell: share of its ring so far
    std::vector<float> density;  // per cell: of draws, per steradian
    std::vector<float> rings;    // share so far, ends at 1
};
TabulatedDraws tabulated_draws(const NdfGrid& grid, const float* table);

}  // namespace burnish
