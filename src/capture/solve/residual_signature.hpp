// Residuals of an exemplar on each of its points, and a test of whether the points form two groups.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "capture/solve/point_fit.hpp"

namespace burnish {

// Coarse enough that a few hundred samples fill its cells.
inline constexpr NdfGrid kSignature = {8, 24};

// One number for each cell of kSignature, ring by ring.
using Signature = std::array<float, 8 * 24>;

// A point's residuals in the frame of its exemplar. Each cell is divided by its standard error, so
// that noise is about equal in all cells. Cells without samples are 0.
void residual_signature(const ExemplarTables& tables, const PointSamples& samples,
                        const PointFitter& fitter, const PointFit& fit, Signature& out);

// The variance share, 0 to 1, of the largest principal component of the signatures (by power
// iteration). `place` receives the coordinate of each signature along it, relative to the mean.
double main_variation(const std::vector<const Signature*>& signatures, std::vector<float>& place);

}  // namespace burnish
