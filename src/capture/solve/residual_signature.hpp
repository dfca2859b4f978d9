// What an exemplar leaves unexplained of each of its points, and whether that falls into two kinds.
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

// A point's residuals in the frame of its exemplar, each cell in units of what the samples decide
// there, so that noise is about as large in every cell. Cells without samples are 0.
void residual_signature(const ExemplarTables& tables, const PointSamples& samples,
                        const PointFitter& fitter, const PointFit& fit, Signature& out);

// The largest principal component of the signatures (by power iteration), as its share of their
// variance, 0 to 1; `place` receives the place of each signature along it, from the mean.
double main_variation(const std::vector<const Signature*>& signatures, std::vector<float>& place);

}  // namespace burnish
