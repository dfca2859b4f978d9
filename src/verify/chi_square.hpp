// Chi-square of samples against their density, on cells of the sphere.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "verify/sphere.hpp"

namespace burnish::verify {

// Upper tail of chi-square by Wilson and Hilferty's cube-root normal approximation.
inline double chi_square_p_value(double statistic, int degrees) {
    const double k = degrees;
    const double z = (std::cbrt(statistic / k) - (1 - 2 / (9 * k))) / std::sqrt(2 / (9 * k));
    return 0.5 * std::erfc(z / std::sqrt(2.0));
}

inline constexpr int kRings = 24;
inline constexpr int kSectors = 32;

inline double ring_edge(int i) {
    return kPi * std::pow(static_cast<double>(i) / kRings, 1.5);
}

using Density = std::function<double(vec3)>;
// The zero vector: a draw that is thrown away.
using Draw = std::function<vec3(double xi0, double xi1, double select)>;

inline std::vector<double> expected_counts(const Density& density, const Axes& axes, double total) {
    constexpr int kSub = 12;
    std::vector<double> cells(kRings * kSectors);
    for (int i = 0; i < kRings * kSub; ++i) {
        const int ring = i / kSub;
        const double width = (ring_edge(ring + 1) - ring_edge(ring)) / kSub;
        const double theta = ring_edge(ring) + (i % kSub + 0.5) * width;
        for (int j = 0; j < kSectors * kSub; ++j) {
            const double phi = 2 * kPi * (j + 0.5) / (kSectors * kSub);
            const double area = std::sin(theta) * width * 2 * kPi / (kSectors * kSub);
            cells[static_cast<std::size_t>(ring * kSectors + j / kSub)] +=
                total * area * density(axes.at(theta, phi));
        }
    }
    return cells;
}

// p-value of chi-square for draws against their density; the density's integral beside it. `axes`:
// the pole of the cells, which crowd around it.
inline double sampler_p_value(const Density& density, const Draw& draw, const Axes& axes,
                              unsigned seed, double& density_integral) {
    constexpr int kSamples = 100000;
    const std::vector<double> expected = expected_counts(density, axes, kSamples);
    std::vector<double> found(expected.size());
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int k = 0; k < kSamples; ++k) {
        const double xi0 = uniform(generator), xi1 = uniform(generator),
                     select = uniform(generator);
        const vec3 h = draw(xi0, xi1, select);
        if (h.x == 0 && h.y == 0 && h.z == 0) {
            continue;
        }
        const double theta = std::acos(std::clamp(f64::dot(h, axes.n), -1.0, 1.0));
        const int ring =
            std::min(static_cast<int>(std::pow(theta / kPi, 1 / 1.5) * kRings), kRings - 1);
        const double phi = std::atan2(f64::dot(h, axes.b), f64::dot(h, axes.t));
        const int sector = static_cast<int>((phi < 0 ? phi + 2 * kPi : phi) / (2 * kPi) * kSectors);
        found[static_cast<std::size_t>(ring * kSectors + std::min(sector, kSectors - 1))] += 1;
    }
    double statistic = 0, pooled_expected = 0, pooled_found = 0;
    int degrees = -1;
    density_integral = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        density_integral += expected[i] / kSamples;
        pooled_expected += expected[i];
        pooled_found += found[i];
        if (pooled_expected < 10) {
            continue;
        }  // a cell needs a handful for the statistic to hold
        statistic += std::pow(pooled_found - pooled_expected, 2) / pooled_expected;
        pooled_expected = pooled_found = 0;
        ++degrees;
    }
    return chi_square_p_value(statistic, degrees);
}

}  // namespace burnish::verify
