// The analytic lobe that is nearest to a table: two widths and the direction of the groove, for
// programs that cannot draw tables and for maps that people read.
//
// Threads: any number may call these functions at a time. Lifetime: what they return refers to
// nothing else.
#pragma once

#include <vector>

#include "burnish/api.hpp"
#include "burnish/ndf_grid.hpp"
#include "burnish/shading_names.hpp"

namespace BURNISH_API burnish {

struct TabulatedMaterial;

struct LobeFit {
    // Along the groove, the axis of the smaller alpha: radians in [0, pi), counter-clockwise from
    // +x of the table. Means nothing where the alphas are equal.
    double groove = 0.0;
    double alpha_along = 0.0, alpha_across = 0.0;  // of lobe_from_alpha; along <= across
    // Hellinger's distance of the table and the lobe, both scaled to the same mass and weighted by
    // n.h: 0 where they agree, 1 where they have nothing in common.
    double residual = 0.0;
};

// Least squares of the roots of both (so that neither the peak nor the tail decides alone) at the
// cells of the grid. Alphas end at 0.002 and 1.5 (1 for ashikhmin-shirley, whose exponents are 0
// there). `table`: not all 0.
LobeFit fit_lobe(const NdfGrid& grid, const float* table, Mdf mdf);

// Of every exemplar.
std::vector<LobeFit> fit_lobes(const TabulatedMaterial& material, Mdf mdf);

}  // namespace burnish
