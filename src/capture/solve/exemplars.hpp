// Exemplars: the distributions that all points of a sample share, each point turned by its own
// angle. Found by masked, rotation-aware k-means on partial distributions; docs/theory/capture-model.md.
#pragma once

#include <cstdint>
#include <vector>

#include "burnish/progress.hpp"
#include "capture/solve/rotation_match.hpp"
#include "scene/material/tabulated_material.hpp"

namespace burnish {

struct Exemplars {
    NdfGrid grid;
    int count = 0;
    std::vector<float> D;        // count x cells; each Int D (n.h) dw = 1 over what is known
    std::vector<float> weights;  // count x cells, 0 to 1: how well a cell is known
    std::vector<float> areas;    // count x kAreaGrid cells
    std::vector<NdfOrigin> origin;

    float* table(int index) { return D.data() + static_cast<std::ptrdiff_t>(index) * grid.cells(); }
    const float* table(int index) const {
        return D.data() + static_cast<std::ptrdiff_t>(index) * grid.cells();
    }
    float* weight(int index) {
        return weights.data() + static_cast<std::ptrdiff_t>(index) * grid.cells();
    }
    const float* weight(int index) const {
        return weights.data() + static_cast<std::ptrdiff_t>(index) * grid.cells();
    }
    const float* area(int index) const {
        return areas.data() + static_cast<std::ptrdiff_t>(index) * kAreaGrid.cells();
    }
    MaskedTables tables() const { return {D, weights, static_cast<std::size_t>(count)}; }
};

struct PointTurn {
    int exemplar = -1;   // -1: matched none
    float shift = 0.0f;  // columns
    float residual = 1.0f;
};

struct ClusterSettings {
    int exemplars = 64;  // at most
    int rounds = 6;      // of Lloyd's iteration
    std::uint64_t seed = 1;
};

// `points`: partial distributions. Returns at most `exemplars` tables, fewer where several would be
// the same within the points' own spread; `turns` receives where each point went.
Exemplars cluster_points(const NdfGrid& grid, const MaskedTables& points,
                         const ClusterSettings& settings, std::vector<PointTurn>& turns,
                         const Progress& progress);

// The matches of every point with its best exemplars, best first; `most` of them.
std::vector<std::vector<PointTurn>> best_turns(const RotationMatcher& matcher,
                                               const MaskedTables& points, std::size_t most);

// `table` turned by `shift` columns (counter-clockwise), linear between columns.
void turn_table(const NdfGrid& grid, const float* table, float shift, float* out);

}  // namespace burnish
