// How much of the light a surface sends back.
#pragma once

#include <span>

#include "burnish/brdf_models.hpp"

namespace burnish {

// Share of the light from `wi` (unit, wi.z > 0) that leaves: the integral of f cos over wo, by the
// model's own sampler (in which the roles of the two directions are swapped) on a sequence of even
// points (Roberts' R2). With 8192 points the error is below 0.002 for bounded models to 85 degrees.
double directional_albedo(const BrdfModel& model, std::span<const double, kMostBrdfParameters> p,
                          Direction<double> wi, int points = 1 << 13);

}  // namespace burnish
