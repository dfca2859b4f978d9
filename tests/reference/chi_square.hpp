// Whether a surface draws directions by the density that it states.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "reference/owen_points.hpp"
#include "reference/point_surface.hpp"

namespace burnish::test {

inline constexpr int kRows = 8, kColumns = 16;  // bins of the sphere, of equal area
inline constexpr float kTwoPiF = 2.0f * std::numbers::pi_v<float>;

inline glm::vec3 direction(float row, float column) {
    const float z = 1.0f - 2.0f * row, phi = kTwoPiF * column;
    const float r = std::sqrt(std::max(1.0f - z * z, 0.0f));
    return {r * std::cos(phi), r * std::sin(phi), z};
}

inline int bin_of(const glm::vec3& w) {
    const float turns = std::atan2(w.y, w.x) / kTwoPiF;
    const int row = std::min(static_cast<int>((0.5f - 0.5f * w.z) * kRows), kRows - 1);
    const int column =
        std::min(static_cast<int>((turns - std::floor(turns)) * kColumns), kColumns - 1);
    return row * kColumns + column;
}

// Shares of the bins by the midpoint rule.
inline std::vector<double> expected_shares(const PointSurface& surface) {
    constexpr int kFine = 40;
    std::vector<double> shares(kRows * kColumns, 0.0);
    const double area = 4.0 * std::numbers::pi / (kRows * kColumns * kFine * kFine);
    for (int row = 0; row < kRows * kFine; ++row)
        for (int column = 0; column < kColumns * kFine; ++column) {
            const glm::vec3 w = direction((static_cast<float>(row) + 0.5f) / (kRows * kFine),
                                          (static_cast<float>(column) + 0.5f) / (kColumns * kFine));
            shares[static_cast<std::size_t>(row / kFine * kColumns + column / kFine)] +=
                static_cast<double>(surface.pdf(w)) * area;
        }
    return shares;
}

// Pearson's statistic of independent draws over bins of 5 and more, in standard deviations of its distribution.
inline double chi_square_sigmas(const PointSurface& surface) {
    constexpr std::uint32_t kDraws = 40000;
    std::vector<double> drawn(kRows * kColumns, 0.0);
    double thrown = kDraws;
    for (std::uint32_t i = 0; i < kDraws; ++i) {
        const auto xi = owen_point(0, i);  // of sets of its own: independent
        if (const auto s = surface.sample({xi[0], xi[1], xi[2]})) {
            drawn[static_cast<std::size_t>(bin_of(s->wi))] += 1.0;
            thrown -= 1.0;
        }
    }
    const std::vector<double> shares = expected_shares(surface);
    double statistic = 0.0, all = 0.0, rest_drawn = thrown, rest_expected = 0.0;
    int bins = 0;
    for (std::size_t i = 0; i < shares.size(); ++i) {
        const double expected = shares[i] * kDraws;
        all += expected;
        if (expected < 5.0) {
            rest_drawn += drawn[i];
            rest_expected += expected;
            continue;
        }
        statistic += (drawn[i] - expected) * (drawn[i] - expected) / expected;
        ++bins;
    }
    // What is thrown away and what falls into small bins together is one more bin.
    rest_expected += kDraws - all;
    if (rest_expected > 5.0) {
        statistic += (rest_drawn - rest_expected) * (rest_drawn - rest_expected) / rest_expected;
        ++bins;
    }
    return (statistic - (bins - 1)) / std::sqrt(2.0 * (bins - 1));
}

}  // namespace burnish::test
