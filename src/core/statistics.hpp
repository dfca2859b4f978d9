// Order statistics of a few measurements.
#pragma once

#include <vector>

namespace burnish {

// Value below which `share` (0..1) of the values lie, between neighbours linearly. Not a number
// when there are none.
double quantile(std::vector<double> values, double share);

double median(std::vector<double> values);

// Half the distance between the quartiles: what tables call the spread.
double half_quartile_distance(std::vector<double> values);

}  // namespace burnish
