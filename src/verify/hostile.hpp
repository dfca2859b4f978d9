// Frames and directions that break careless code, and a count of what comes out broken.
#pragma once

#include <cstddef>

namespace burnish::verify {

struct HostileCounts {
    int broken_f32 = 0;  // values that are NaN, infinite or negative
    int broken_f64 = 0;
    std::size_t combinations = 0;  // of each precision
};

// D, the value of every model with half vectors and of four cosine lobes, the density and the sample, for
// perturbed normals and directions at the horizon, at the poles, and a subnormal number beside them. The models
// take the lobe of `mdf`, or their own of the same alphas.
HostileCounts hostile_counts(int mdf, double p0, double p1, int method);

}  // namespace burnish::verify
