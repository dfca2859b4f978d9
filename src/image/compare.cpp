#include "burnish/compare.hpp"

#include <cmath>
#include <limits>

namespace burnish {

double SquaredError::rmse() const {
    return count > 0 ? std::sqrt(squares / static_cast<double>(count)) : 0.0;
}

double psnr(double rmse, double peak) {
    return rmse > 0.0 ? 20.0 * std::log10(peak / rmse) : std::numeric_limits<double>::infinity();
}

}  // namespace burnish
