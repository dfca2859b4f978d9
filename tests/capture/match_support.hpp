// Matches by the definition, one rotation after another in double precision, and makes tables to
// match.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "capture/solve/rotation_match.hpp"
#include "table_support.hpp"

namespace burnish::test {

struct Table {
    std::vector<float> value, weight;
};

struct AtRotation {
    double residual = 1, scale = 0, overlap = 0;
};

// The match at one rotation by the definition: column a - shift of the exemplar lies on column a of
// the point.
inline AtRotation by_definition(const NdfGrid& grid, const Table& point, const Table& exemplar,
                                int shift, double least_overlap) {
    double A = 0, B = 0, X = 0, O = 0, m_sum = 0, n_sum = 0;
    for (int r = 0; r < grid.rings; ++r) {
        const double w = cosine_weight(grid, r);
        for (int a = 0; a < grid.azimuths; ++a) {
            const std::size_t p = cell(grid, r, a), e = cell(grid, r, a - shift);
            const double m = static_cast<double>(point.weight[p]);
            const double n = static_cast<double>(exemplar.weight[e]);
            m_sum += w * m;
            n_sum += w * n;
            if (m == 0 || n == 0) continue;
            const double T = static_cast<double>(point.value[p]);
            const double C = static_cast<double>(exemplar.value[e]);
            A += w * m * n * T * T;
            B += w * m * n * C * C;
            X += w * m * n * T * C;
            O += w * m * n;
        }
    }
    AtRotation out;
    const double smaller = std::min(m_sum, n_sum);
    out.overlap = smaller > 0 ? O / smaller : 0;
    if (out.overlap < least_overlap || !(A > 0) || !(B > 0)) return {1, 0, out.overlap};
    out.scale = X / B;
    out.residual = (A - X * X / B) / A;
    return out;
}

struct Best {
    AtRotation at;
    int shift = 0;
};

inline Best best_by_definition(const NdfGrid& grid, const Table& point, const Table& exemplar,
                               double least_overlap) {
    Best best;
    best.at.residual = 2;
    for (int s = 0; s < grid.azimuths; ++s) {
        const AtRotation at = by_definition(grid, point, exemplar, s, least_overlap);
        if (at.residual < best.at.residual) best = {at, s};
    }
    return best;
}

inline double columns_between(double a, double b, double columns) {
    const double d = std::fmod(std::fmod(a - b, columns) + columns, columns);
    return std::min(d, columns - d);
}

enum class Mask { full, holes, half, soft, near_empty, one_cell, empty };
inline constexpr Mask kMasks[] = {Mask::full,       Mask::holes,    Mask::half, Mask::soft,
                                  Mask::near_empty, Mask::one_cell, Mask::empty};

inline Table random_table(const NdfGrid& grid, Mask mask, Random& random) {
    Table out;
    const double middle = random.uniform(0, grid.azimuths);
    const int chosen = random.below(grid.cells());
    for (int i = 0; i < grid.cells(); ++i) {
        const int a = i % grid.azimuths;
        double w = 1;
        switch (mask) {
            case Mask::full:
                break;
            case Mask::holes:
                w = random.uniform() < 0.7 ? 1 : 0;
                break;
            case Mask::half: {
                const double away = std::abs(a - middle);
                w = std::min(away, grid.azimuths - away) < 0.3 * grid.azimuths ? 1 : 0;
                break;
            }
            case Mask::soft:
                w = std::max(0.0, random.uniform(-0.3, 1));
                break;
            case Mask::near_empty:
                w = random.uniform() < 0.02 ? 0.5 : 0;
                break;
            case Mask::one_cell:
                w = i == chosen ? 1 : 0;
                break;
            case Mask::empty:
                w = 0;
                break;
        }
        out.value.push_back(static_cast<float>(random.uniform(0.1, 2)));
        out.weight.push_back(static_cast<float>(w));
    }
    return out;
}

// A coarse pattern with noise: residuals differ clearly between rotations, as for real tables.
inline Table patterned(const NdfGrid& grid, Mask mask, Random& random) {
    Table out = random_table(grid, mask, random);
    const double phase = random.uniform(0, 2 * kPi), skew = random.uniform(0, 2 * kPi);
    for (int r = 0; r < grid.rings; ++r) {
        for (int a = 0; a < grid.azimuths; ++a) {
            const double phi = 2 * kPi * a / grid.azimuths;
            const double wave = std::exp(std::cos(phi - phase) + 0.7 * std::cos(2 * phi - skew));
            out.value[cell(grid, r, a)] *= static_cast<float>(wave);
        }
    }
    return out;
}

struct Pile {
    std::vector<float> values, weights;
    std::size_t count = 0;
    void add(const Table& table) {
        values.insert(values.end(), table.value.begin(), table.value.end());
        weights.insert(weights.end(), table.weight.begin(), table.weight.end());
        ++count;
    }
    MaskedTables tables(std::size_t first, std::size_t number, const NdfGrid& grid) const {
        const auto cells = static_cast<std::size_t>(grid.cells());
        return {std::span(values).subspan(first * cells, number * cells),
                std::span(weights).subspan(first * cells, number * cells), number};
    }
    MaskedTables tables() const { return {values, weights, count}; }
};

inline Pile pile_of(const std::vector<Table>& tables) {
    Pile out;
    for (const Table& table : tables) out.add(table);
    return out;
}

using Matches = std::vector<std::vector<RotationMatch>>;

inline Matches all_matches(const RotationMatcher& matcher, const MaskedTables& points) {
    Matches out(points.count);
    std::vector<int> times(points.count, 0);
    std::mutex mutex;
    matcher.match(points, [&](std::size_t point, std::span<const RotationMatch> matches) {
        const std::lock_guard lock(mutex);
        out.at(point).assign(matches.begin(), matches.end());
        ++times.at(point);
    });
    for (const int t : times) EXPECT_EQ(t, 1) << "points are not taken once each";
    return out;
}

inline RotationMatch one_match(const NdfGrid& grid, const Table& point, const Table& exemplar) {
    RotationMatcher matcher(grid);
    const Pile e = pile_of({exemplar}), p = pile_of({point});
    matcher.set_exemplars(e.tables());
    return all_matches(matcher, p.tables()).at(0).at(0);
}

inline Table rotated(const NdfGrid& grid, const Table& table, int columns) {
    Table out = table;
    for (int r = 0; r < grid.rings; ++r) {
        for (int a = 0; a < grid.azimuths; ++a) {
            out.value[cell(grid, r, a + columns)] = table.value[cell(grid, r, a)];
            out.weight[cell(grid, r, a + columns)] = table.weight[cell(grid, r, a)];
        }
    }
    return out;
}

// Tolerance of residuals: single precision and A - X^2/B add a few roundings of sums of thousands
// of terms.
inline constexpr double kResidualRounding = 2e-4;

inline const NdfGrid kGrids[] = {{32, 96}, {16, 32}, {8, 24}};
inline std::string name_of_grid(const testing::TestParamInfo<NdfGrid>& instance) {
    return std::to_string(instance.param.rings) + "x" + std::to_string(instance.param.azimuths);
}

}  // namespace burnish::test
