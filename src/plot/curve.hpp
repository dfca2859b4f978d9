// A function of one variable as a polyline that misses none of the spikes that the caller names.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "burnish/plot/canvas.hpp"

namespace burnish::plot {

// (x, f(x)) for x from `low` to `high`, rising. Starts from 240 even places and places that crowd
// geometrically about every hint (a peak may be as narrow as 1e-6 of the range), then halves
// intervals whose middle is off the straight line by more than 0.2 % of the largest |f|, or, for
// logarithmic axes, by more than 3 % of the value there.
std::vector<Point> sampled_curve(const std::function<double(double)>& f, double low, double high,
                                 std::span<const double> hints);

}  // namespace burnish::plot
