// Exemplars: the distributions shared by all points of a sample, each point with its own rotation.
// They are found by masked, rotation-aware k-means on partial distributions
// (docs/theory/capture-model.md).
#pragma once

#include <cstdint>
#include <vector>

#include "burnish/progress.hpp"
#include "burnish/tabulated_material.hpp"
#include "capture/solve/rotation_match.hpp"

namespace burnish {

struct Exemplars {
    NdfGrid grid;
    int count = 0;
    std::vector<float> D;           // count x cells; each Int D (n.h) dw = 1 over the known cells
    std::vector<float> weights;     // count x cells, 0 (unknown) to 1
    std::vector<float> areas;       // count x kAreaGrid cells; empty until tables are completed
    std::vector<NdfOrigin> origin;  // count x cells

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

    // Appends exemplar `index` of `from`, which has the same grid: D, weights and, if present,
    // areas. Its cells count as extrapolated until complete_exemplars. Returns its new index.
    int append(const Exemplars& from, int index);
};

// A candidate exemplar of a point, and its rotation for that point.
struct Candidate {
    int exemplar = -1;      // -1: none
    float shift = 0.0f;     // rotation in columns of the grid, counter-clockwise
    float residual = 1.0f;  // of the match (RotationMatch::residual), 0 to 1
};

struct ClusterSettings {
    int exemplars = 64;  // at most
    int rounds = 6;      // of Lloyd's iteration
    std::uint64_t seed = 1;
};

// `points`: partial distributions. Returns at most `exemplars` tables; tables that are equal within
// the spread of their points are merged. `assigned` receives the exemplar and rotation of each
// point. Deterministic for a seed, for any number of threads.
Exemplars cluster_points(const NdfGrid& grid, const MaskedTables& points,
                         const ClusterSettings& settings, std::vector<Candidate>& assigned,
                         const Progress& progress);

// The `most` best exemplars of every point, each at its best rotation, in increasing order of
// residuals.
std::vector<std::vector<Candidate>> best_candidates(const RotationMatcher& matcher,
                                                    const MaskedTables& points, std::size_t most);

// Writes `table`, rotated counter-clockwise by `shift` columns, to `out`; linear between columns.
// Both have grid.cells() values and must not overlap.
void rotate_table(const NdfGrid& grid, const float* table, float shift, float* out);

}  // namespace burnish
