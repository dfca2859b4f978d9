// The normal of a point: from its highlight alone, and from all its samples once its exemplar is
// known.
#pragma once

#include <array>

#include "capture/solve/partial_ndf.hpp"
#include "capture/solve/point_fit.hpp"
#include "capture/solve/sample_context.hpp"

namespace burnish {

// Largest tilt of a normal from +z, in radians (20 degrees): samples are nearly flat, and from
// beyond it half of the lights of a dome would stand below the horizon.
inline constexpr float kMostTilt = 0.35f;

// The slope (x, y), in the frame of the table, about which a distribution lies: the middle of the
// paraboloid through log D where D is above a third of its largest value. Along an axis of the
// paraboloid that bends less than `least_bend` (second derivative of -log D by the slope) it is 0.
std::array<float, 2> peak_slope(const NdfGrid& grid, const float* table, const float* weights,
                                double least_bend);

// The normal that has this slope in the frame of `normal`, at most kMostTilt from +z.
Vec3f tilted_normal(const Vec3f& normal, const std::array<float, 2>& slope);

// A normal for the pixel, at most kMostTilt from +z, about which its partial distribution lies
// along the axes in which it is narrow; `work`, `table` and `weights` end in the frame of that
// normal. Grooves and yarns lie about their normal; where a distribution leans, the normal is off
// by its lean. `values`: lights x 3.
Vec3f peak_normal(const SampleContext& context, const PartialNdfSolver& solver, std::size_t pixel,
                  const float* values, PixelWork& work, PartialNdfWork& partial, float* table,
                  float* weights);

// A pixel whose exemplar is known.
struct KnownPixel {
    const SampleContext& context;
    std::size_t pixel;
    const float* values;  // lights x 3
    float eta;
    ExemplarTables tables;  // of its exemplar
};

// The normal near `normal`, at most kMostTilt from +z, with which the exemplar at rotation
// fit.shift explains the pixel's samples best. `work` ends with the samples in its frame, `fit`
// with the rotation that is best there.
Vec3f refined_normal(const KnownPixel& known, Vec3f normal, PixelWork& work, PointFit& fit);

}  // namespace burnish
