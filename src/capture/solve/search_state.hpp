// The state of a search for exemplars, and its steps: functions from a state to the next one.
// Private to exemplar_search.cpp, search_*.cpp and their tests.
#pragma once

#include <array>
#include <vector>

#include "capture/solve/exemplar_search.hpp"
#include "capture/solve/exemplar_solve.hpp"
#include "capture/solve/point_fit.hpp"
#include "capture/solve/residual_signature.hpp"

namespace burnish {

// The inputs of a search; no step changes them.
struct SearchInput {
    const SampleContext& context;
    const std::vector<std::size_t>& pixels;  // of the training points
    const std::vector<float>& values;        // pixels x lights x 3
    const ExemplarSearchSettings& settings;
    const Progress& progress;

    const float* values_of(std::size_t point) const {
        return values.data() + point * 3 * context.geometry->lights();
    }
};

// The partial distributions of the training points, points x cells, in the frames of their first
// normals.
struct PartialTables {
    std::vector<float> tables, weights;
    std::size_t count = 0;
    MaskedTables masked() const { return {tables, weights, count}; }
};

// The state of one training point.
struct PointState {
    Vec3f normal{0.0f, 0.0f, 1.0f};
    Candidate assigned;                 // its exemplar and rotation
    PointFit fit;                       // of the assigned exemplar; error 0 before the first round
    std::vector<Candidate> candidates;  // exemplars of this state that were tried or will be
    std::vector<PointFit> trials;       // the fit of each candidate
    Signature signature{};              // of the assigned exemplar's residuals
};

struct SearchState {
    double eta = 0.0;
    Exemplars exemplars;
    CompletionReport completion;
    std::vector<PointState> points;

    ExemplarTables tables_of(int exemplar) const {
        return {exemplars.grid, exemplars.table(exemplar), exemplars.area(exemplar)};
    }
};

// Lists the points of each exemplar in increasing order.
std::vector<std::vector<std::size_t>> members_of(const SearchState& state);
// Mean of PointFit::error, each at most 1, over the points.
double mean_error(const SearchState& state);

// ---- search_rounds.cpp: points and tables are solved for alternately

// Solves for the partial distribution of each point, the input of clustering, and for its first
// normal.
SearchState solve_partial(const SearchInput& input, double eta, PartialTables& partial);
// Assigns its best candidate to every point, then solves for every exemplar from its points and,
// where normals may tilt, centers the exemplars. `match`: finds new candidates by matching partial
// tables; otherwise keeps them.
SearchState solve_round(const SearchInput& input, const PartialTables& partial, SearchState state,
                        bool match);
// Finds the strengths of every point with the exemplar and rotation that it is assigned, after a step
// that assigned others.
SearchState refit_points(const SearchInput& input, SearchState state);
// Solves for every exemplar from the samples of its points, at their fits, and completes the table.
SearchState solve_tables(const SearchInput& input, SearchState state);

// ---- search_changes.cpp: steps that change the set of exemplars. They clear the candidates, which
// refer to exemplars of the previous state, and end by solving for the tables.

// Splits an exemplar if its points form two halves that differ more than by noise: the second half
// gets a copy, and the next round separates the two tables. Drops exemplars with very few points.
SearchState split_exemplars(const SearchInput& input, SearchState state);
// Drops exemplars whose points others explain about as well, so that each remaining exemplar has
// more points and rotations. Tries the exemplars with the fewest points first.
SearchState merge_exemplars(const SearchInput& input, SearchState state);
// Joins pairs of exemplars with a residual (RotationMatch) below `alike`: the exemplar with fewer
// points gives them to the other.
SearchState join_alike(const SearchInput& input, SearchState state, float alike);

}  // namespace burnish
