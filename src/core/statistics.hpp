// Order statistics of a few measurements.
#pragma once

#include <vector>

namespace burnish {

// The value below which the share `share` (0..1) of the values lies, interpolated linearly between
// neighboring values. NaN when there are no values.
double quantile(std::vector<double> values, double share);

double median(std::vector<double> values);

// Half the distance between the first and the third quartile. Tables call it the spread.
double half_quartile_distance(const std::vector<double>& values);

}  // namespace burnish
