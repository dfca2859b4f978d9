#include "core/statistics.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

namespace burnish {

double quantile(std::vector<double> values, double share) {
    if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::sort(values.begin(), values.end());
    const double place = std::clamp(share, 0.0, 1.0) * static_cast<double>(values.size() - 1);
    const auto low = static_cast<std::size_t>(place);
    const std::size_t high = std::min(low + 1, values.size() - 1);
    if (values[low] == values[high]) return values[low];  // infinities have no difference
    return values[low] + (place - static_cast<double>(low)) * (values[high] - values[low]);
}

double median(std::vector<double> values) {
    return quantile(std::move(values), 0.5);
}

double half_quartile_distance(const std::vector<double>& values) {
    return 0.5 * (quantile(values, 0.75) - quantile(values, 0.25));
}

}  // namespace burnish
