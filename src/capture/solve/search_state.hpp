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

// What a search works on; no step changes it.
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

// One training point.
struct PointState {
    Vec3f normal{0.0f, 0.0f, 1.0f};
    Candidate assigned;                 // its exemplar and rotation
    PointFit fit;                       // of the assigned exemplar; error 0 before the first round
    std::vector<Candidate> candidates;  // exemplars of the state that were tried, or will be
    std::vector<PointFit> trials;       // of each candidate
    Signature signature{};              // of what the assigned exemplar leaves
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

// The points that each exemplar is assigned to, in increasing order.
std::vector<std::vector<std::size_t>> members_of(const SearchState& state);
// Of PointFit::error, each at most 1.
double mean_error(const SearchState& state);

// ---- search_rounds.cpp: points and tables are solved for alternately

// What each point shows by itself, which clustering starts from; the points' first normals.
SearchState solve_partial(const SearchInput& input, double eta, PartialTables& partial);
// Assigns to every point its best candidate, then solves for every exemplar from its points and,
// where normals may tilt, centers the exemplars. `match`: candidates are found anew, by the partial
// tables; without, they stay.
SearchState solve_round(const SearchInput& input, const PartialTables& partial, SearchState state,
                        bool match);
// Solves for every exemplar from the samples of its points and completes it.
SearchState solve_tables(const SearchInput& input, SearchState state);

// ---- search_changes.cpp: changes of which exemplars there are. Candidates are dropped, as they
// name exemplars of the state before; tables are solved for at the end.

// Gives the worse explained half of an exemplar's points an exemplar of their own where the halves
// differ more than noise makes them; the next round takes the two apart. Exemplars of hardly any
// points are dropped.
SearchState split_exemplars(const SearchInput& input, SearchState state);
// Drops exemplars whose points others explain about as well: those that stay have more points, and
// more rotations, each. The exemplars with the fewest points are tried first.
SearchState merge_exemplars(const SearchInput& input, SearchState state);
// Joins exemplars with a residual (RotationMatch) below `alike`: the one with fewer points gives
// them to the other.
SearchState join_alike(const SearchInput& input, SearchState state, float alike);

}  // namespace burnish
