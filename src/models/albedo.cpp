#include "models/albedo.hpp"

#include <array>

#include "core/even_points.hpp"

namespace burnish {

double directional_albedo(const BrdfModel& model, std::span<const double, kMostBrdfParameters> p,
                          Direction<double> wi, int points) {
    double sum = 0;
    for (int k = 0; k < points; ++k) {
        const std::array<double, 3> xi = even_point(k);
        double density = 0;
        const Direction<double> wo = model.sampler_f64.sample(p, wi, xi, density);
        if (density > 0 && wo.z > 0) sum += model.value_f64(p, wi, wo) * wo.z / density;
    }
    return sum / points;
}

}  // namespace burnish
