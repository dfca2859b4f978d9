#include "shading/albedo.hpp"

#include <array>
#include <cmath>

namespace burnish {

double directional_albedo(const BrdfModel& model, std::span<const double, kMostBrdfParameters> p,
                          Direction<double> wi, int points) {
    double sum = 0;
    for (int k = 0; k < points; ++k) {
        const std::array<double, 3> xi = {std::fmod(0.5 + 0.7548776662466927 * k, 1.0),
                                          std::fmod(0.5 + 0.5698402909980532 * k, 1.0),
                                          std::fmod(0.5 + 0.6180339887498949 * k, 1.0)};
        double density = 0;
        const Direction<double> wo = model.sampler_f64.sample(p, wi, xi, density);
        if (density > 0 && wo.z > 0) sum += model.value_f64(p, wi, wo) * wo.z / density;
    }
    return sum / points;
}

}  // namespace burnish
