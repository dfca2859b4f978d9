// Tables of distributions for the tests of this layer. Positions and weights of cells follow the
// description of the grid, and lobes are closed forms, so that nothing depends on the tested code.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "burnish/ndf_grid.hpp"
#include "core/constants.hpp"

namespace burnish::test {

inline std::size_t cell(const NdfGrid& grid, int ring, int column) {
    const int c = ((column % grid.azimuths) + grid.azimuths) % grid.azimuths;
    return static_cast<std::size_t>(ring * grid.azimuths + c);
}

// Rings are equal steps of u = sqrt(2 theta / pi).
inline double theta_at(const NdfGrid& grid, double edge) {
    const double u = edge / grid.rings;
    return kPi / 2 * u * u;
}

// cos(theta) dw of a cell of a ring, cos at its center.
inline double cosine_weight(const NdfGrid& grid, int ring) {
    const double dw = 2 * kPi / grid.azimuths *
                      (std::cos(theta_at(grid, ring)) - std::cos(theta_at(grid, ring + 1)));
    return dw * std::cos(theta_at(grid, ring + 0.5));
}

using DirectionalLobe = std::function<double(double x, double y, double z)>;

// The lobe at the cells' centers, rotated counter-clockwise by `columns` (any real number).
inline std::vector<float> sampled(const NdfGrid& grid, const DirectionalLobe& lobe,
                                  double columns = 0) {
    std::vector<float> out;
    for (int r = 0; r < grid.rings; ++r) {
        const double theta = theta_at(grid, r + 0.5);
        for (int a = 0; a < grid.azimuths; ++a) {
            const double phi = 2 * kPi * (a - columns) / grid.azimuths;
            out.push_back(
                static_cast<float>(lobe(std::sin(theta) * std::cos(phi),
                                        std::sin(theta) * std::sin(phi), std::cos(theta))));
        }
    }
    return out;
}

// Beckmann's and GGX's distributions about a mean slope (Int D (n.h) dw = 1 for both).
inline DirectionalLobe beckmann(double ax, double ay, double lean_x = 0, double lean_y = 0) {
    return [=](double x, double y, double z) {
        if (z <= 1e-9) return 0.0;
        const double p = (x / z - lean_x) / ax, q = (y / z - lean_y) / ay;
        return std::exp(-(p * p + q * q)) / (kPi * ax * ay * z * z * z * z);
    };
}
inline DirectionalLobe ggx(double ax, double ay, double lean_x = 0, double lean_y = 0) {
    return [=](double x, double y, double z) {
        if (z <= 1e-9) return 0.0;
        const double p = (x / z - lean_x) / ax, q = (y / z - lean_y) / ay;
        const double s = 1 + p * p + q * q;
        return 1 / (kPi * ax * ay * z * z * z * z * s * s);
    };
}

class Random {
  public:
    explicit Random(std::uint32_t seed) : engine_(seed) {}
    double uniform(double low = 0, double high = 1) {
        return low + (high - low) * (static_cast<double>(engine_()) / 4294967296.0);
    }
    int below(int count) { return static_cast<int>(uniform(0, count)); }

  private:
    std::mt19937 engine_;
};

}  // namespace burnish::test
