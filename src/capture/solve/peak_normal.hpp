// Estimates the normal of a point: from its highlight alone, or from all its samples once its
// exemplar is known.
#pragma once

#include <array>

#include "capture/solve/partial_ndf.hpp"
#include "capture/solve/point_fit.hpp"
#include "capture/solve/sample_context.hpp"

namespace burnish {

// Largest tilt of a normal from +z, in radians (20 degrees). Samples are nearly flat, and at larger
// tilts half of a dome's lights would be below the point's horizon.
inline constexpr float kMostTilt = 0.35f;

// The slope (x, y) of the center of a distribution, in the frame of the table. It is the vertex of
// the paraboloid fitted to log D where D is above a third of its maximum. The slope is 0 along each
// axis of the paraboloid whose curvature (second derivative of -log D by the slope) is below
// `least_bend`.
std::array<float, 2> peak_slope(const NdfGrid& grid, const float* table, const float* weights,
                                double least_bend);

// The normal with this slope in the frame of `normal`, at most kMostTilt from +z.
Vec3f tilted_normal(const Vec3f& normal, const std::array<float, 2>& slope);

// How the search for a point's normal starts.
enum class NormalStart {
    none,       // the sample is flat: the normal is +z
    shading,    // shading_normal
    highlight,  // peak_normal: for points without diffuse light
};

// The first normal of a pixel, and its partial distribution: `work`, `table` and `weights` end in
// the frame of that normal. `values`: lights x 3.
Vec3f first_normal(NormalStart start, const SampleContext& context, const PartialNdfSolver& solver,
                   std::size_t pixel, const float* values, PixelWork& work, PartialNdfWork& partial,
                   float* table, float* weights);

// Estimates the normal of a pixel, at most kMostTilt from +z: the center of its partial
// distribution along the axes in which the distribution is narrow. `work`, `table` and `weights`
// end in the frame of that normal. Distributions of grooves and yarns are centered on their normal;
// a leaning distribution shifts the estimate by its lean. `values`: lights x 3.
Vec3f peak_normal(const SampleContext& context, const PartialNdfSolver& solver, std::size_t pixel,
                  const float* values, PixelWork& work, PartialNdfWork& partial, float* table,
                  float* weights);

// A pixel with a known exemplar.
struct KnownPixel {
    const SampleContext& context;
    std::size_t pixel;
    const float* values;  // lights x 3
    float eta;
    ExemplarTables tables;  // of its exemplar
};

// Finds the normal near `normal`, at most kMostTilt from +z, for which the exemplar at rotation
// fit.shift predicts the pixel's samples best. On return `work` holds the samples in its frame and
// `fit` the best rotation there.
Vec3f refined_normal(const KnownPixel& known, Vec3f normal, PixelWork& work, PointFit& fit);

}  // namespace burnish
