// Where a point's normal points, from its highlight alone: the middle of its partial distribution.
#pragma once

#include <vector>

#include "capture/solve/exemplar_search.hpp"
#include "capture/solve/partial_ndf.hpp"

namespace burnish {

// The slope (x, y), in the table's frame, about which a distribution lies: the middle of the
// paraboloid through log D where D is above a third of its largest. 0 along an axis of it that
// bends less than `least_bend` (second derivative of -log D by the slope).
std::array<float, 2> peak_slope(const NdfGrid& grid, const float* table, const float* weights,
                                double least_bend);

// The normal that has this slope in the frame of `normal`, at most 20 degrees from +z.
Vec3f tilted_normal(const Vec3f& normal, const std::array<float, 2>& slope);

// A normal for the pixel, at most 20 degrees from +z, that its partial distribution lies about
// where it is narrow; `work`, `table` and `weights` end in its frame. Grooves and yarns lie about
// their normal; of a distribution that leans the normal is off by that.
Vec3f peak_normal(const SampleContext& context, const PartialNdfSolver& solver, std::size_t pixel,
                  const float* values, PixelWork& work, PartialNdfWork& partial, float* table,
                  float* weights);

}  // namespace burnish
