// How far measured or rendered values are from those they should be: root mean square error (RMSE)
// and peak signal-to-noise ratio (PSNR). Each caller says which peak its ratio is relative to:
// figures of different peaks cannot be compared. All functions are pure and may be called from any
// thread.
#pragma once

#include <cstddef>

#include "burnish/api.hpp"

namespace BURNISH_API burnish {

// A sum of squared differences. Sums of parts of the values can be made apart and merged; the
// caller merges in a fixed order where the result must not depend on the number of threads.
struct SquaredError {
    double squares = 0.0;
    std::size_t count = 0;

    void add(double difference) {
        squares += difference * difference;
        ++count;
    }
    void merge(const SquaredError& other) {
        squares += other.squares;
        count += other.count;
    }
    // In the units of the differences; 0 when nothing was added.
    double rmse() const;
};

// 20 log10(peak / rmse) in decibels. `peak`: the value that the ratio takes as full signal, in the
// units of `rmse`. Infinity for an RMSE of 0, whatever the peak: both sides agree everywhere.
double psnr(double rmse, double peak);

}  // namespace burnish
