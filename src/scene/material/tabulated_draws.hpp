// Drawing half vectors from a distribution that is a table.
#pragma once

#include <vector>

#include "burnish/ndf_grid.hpp"

namespace burnish {

// How half vectors of one table are drawn. The density of draws in a cell is proportional to the
// mean of D over the cell and its neighbors (values are interpolated between cells) times the
// cosine, plus a small uniform part. Draws are uniform within a cell.
struct TabulatedDraws {
    std::vector<float> cells;    // per cell: cumulative share of its ring
    std::vector<float> density;  // per cell: density of draws, per steradian
    std::vector<float> rings;    // per ring: cumulative share, ends at 1
};
TabulatedDraws tabulated_draws(const NdfGrid& grid, const float* table);

}  // namespace burnish
