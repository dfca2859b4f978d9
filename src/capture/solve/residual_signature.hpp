// What an exemplar leaves unexplained of each of its points, and whether that falls into two kinds.
#pragma once

#include <cstddef>
#include <vector>

#include "capture/solve/point_fit.hpp"

namespace burnish {

inline constexpr NdfGrid kSignature = {8, 24};

// Writes kSignature.cells() numbers: a point's residuals in the exemplar's frame, in units of what
// its samples decide there, so that noise is about as large in every cell.
void residual_signature(const ExemplarTables& tables, const PointSamples& samples,
                        const PointFitter& fitter, const PointFit& fit, float* out);

// The direction in which the members' signatures vary most (power iteration), as its share of all
// their variance; `side` receives each member's place along it.
double main_variation(const std::vector<float>& signatures, const std::vector<std::size_t>& members,
                      std::vector<float>& side);

}  // namespace burnish
