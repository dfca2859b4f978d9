// Steps that change the set of exemplars: splitting, merging, joining.
#include <algorithm>
#include <numeric>

#include "capture/solve/search_state.hpp"

namespace burnish {

namespace {

// Fewest points of an exemplar: a split drops exemplars with fewer. It splits only exemplars with
// at least four times as many.
constexpr std::size_t kFewestPoints = 4;
// Fewest samples of an exemplar that is split, half as many as a table of the usual grid has cells:
// tables of fewer fit any normals and strengths.
constexpr std::size_t kFewestSplitSamples = 1536;
// Least ratio of the mean errors of the worse and the better half of an exemplar's points for a
// split; noise alone gives 1.1.
constexpr double kSplitRatio = 1.8;
// Least variance share of the largest principal component of the points' residual signatures for a
// split; noise alone gives a few hundredths.
constexpr double kSplitVariation = 0.15;
// Largest ratio of the mean errors of an exemplar's points with other exemplars and with their own
// for which the others take the points.
constexpr double kMergeRatio = 1.25;

using Members = std::vector<std::vector<std::size_t>>;

void drop_candidates(SearchState& state) {
    for (PointState& point : state.points) {
        point.candidates.clear();
        point.trials.clear();
    }
}

// Keeps the exemplars that are alive, at least one, and renumbers them.
SearchState keep_exemplars(SearchState state, std::vector<bool> alive) {
    if (std::none_of(alive.begin(), alive.end(), [](bool a) { return a; })) alive.front() = true;
    Exemplars next;
    next.grid = state.exemplars.grid;
    std::vector<int> renamed(alive.size(), -1);
    for (std::size_t e = 0; e < alive.size(); ++e)
        if (alive[e]) renamed[e] = next.append(state.exemplars, static_cast<int>(e));
    for (PointState& point : state.points)
        if (int& e = point.assigned.exemplar; e >= 0) e = renamed[static_cast<std::size_t>(e)];
    state.exemplars = std::move(next);
    drop_candidates(state);
    return state;
}

// Exemplars in increasing order of the number of their points.
std::vector<std::size_t> smallest_first(const Members& members) {
    std::vector<std::size_t> order(members.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return members[a].size() < members[b].size();
    });
    return order;
}

// ---- splitting

// The two halves of an exemplar's points: `second[k]` is true if the k-th point is in the second
// half.
struct Halves {
    bool differ = false;  // by more than noise
    std::vector<bool> second;
};

// Sorts `points` by error.
Halves halves_of(const SearchState& state, std::vector<std::size_t>& points) {
    const auto error_of = [&](std::size_t p) { return state.points[p].fit.error; };
    std::stable_sort(points.begin(), points.end(),
                     [&](std::size_t a, std::size_t b) { return error_of(a) < error_of(b); });
    const std::size_t half = points.size() / 2;
    const auto mean = [&](std::size_t begin, std::size_t end) {
        double sum = 0.0;
        for (std::size_t k = begin; k < end; ++k) sum += static_cast<double>(error_of(points[k]));
        return sum / static_cast<double>(end - begin);
    };
    std::vector<const Signature*> signatures;
    signatures.reserve(points.size());
    for (const std::size_t p : points) signatures.push_back(&state.points[p].signature);
    std::vector<float> place;  // coordinate of each point along the largest principal component
    const bool uneven = mean(half, points.size()) > kSplitRatio * mean(0, half);
    const bool varied = main_variation(signatures, place) > kSplitVariation;
    Halves out;
    out.differ = uneven || varied;
    for (std::size_t k = 0; k < points.size(); ++k)
        out.second.push_back(varied ? !(place[k] < 0.0f) : !(k < half));
    return out;
}

// ---- merging

// The fit of a point without exemplar `own`: the best of its other candidates that are alive.
// Without such a candidate: exemplar -1 and an error of 1.
struct Alternative {
    Candidate candidate;
    double error = 1.0;
};

Alternative alternative_to(int own, const PointState& point, const std::vector<bool>& alive) {
    Alternative out;
    for (std::size_t c = 0; c < point.candidates.size(); ++c) {
        const Candidate& candidate = point.candidates[c];
        const auto error = static_cast<double>(point.trials[c].error);
        if (candidate.exemplar == own || !alive[static_cast<std::size_t>(candidate.exemplar)] ||
            error >= out.error)
            continue;
        out.error = error;
        out.candidate = {candidate.exemplar, point.trials[c].shift, candidate.residual};
    }
    return out;
}

// Share of free samples of an exemplar's points: 1 - known cells / samples, since the cells were
// fitted to the samples.
double freedom_of(const Exemplars& all, int e, std::size_t points, std::size_t lights) {
    const auto known = static_cast<double>(std::count_if(
        all.weight(e), all.weight(e) + all.grid.cells(), [](float w) { return w > 0.0f; }));
    const auto samples = static_cast<double>(points * lights);
    // At least 0.1: the share is a divisor, and it would be 0 with no more samples than cells.
    return 1.0 - std::min(0.9, known / std::max(samples, 1.0));
}

// ---- joining

// Matches all pairs of exemplars.
std::vector<std::vector<RotationMatch>> matches_between(const Exemplars& exemplars) {
    std::vector<std::vector<RotationMatch>> out(static_cast<std::size_t>(exemplars.count));
    RotationMatcher matcher(exemplars.grid);
    const MaskedTables tables = exemplars.tables();
    matcher.set_exemplars(tables);
    matcher.match(tables, [&](std::size_t e, std::span<const RotationMatch> matches) {
        out[e].assign(matches.begin(), matches.end());
    });
    return out;
}

}  // namespace

SearchState split_exemplars(const SearchInput& input, SearchState state) {
    Members members = members_of(state);
    Exemplars next;
    next.grid = state.exemplars.grid;
    const auto largest = static_cast<std::size_t>(
        std::max_element(members.begin(), members.end(),
                         [](const auto& a, const auto& b) { return a.size() < b.size(); }) -
        members.begin());
    int room = input.settings.exemplars -
               static_cast<int>(std::count_if(members.begin(), members.end(), [](const auto& some) {
                   return some.size() >= kFewestPoints;
               }));
    for (std::size_t e = 0; e < members.size(); ++e) {
        std::vector<std::size_t>& own = members[e];
        if (own.size() < kFewestPoints && e != largest) {
            for (const std::size_t p : own) state.points[p].assigned.exemplar = -1;
            continue;
        }
        const Halves halves = halves_of(state, own);
        const int kept = next.append(state.exemplars, static_cast<int>(e));
        const bool splits = own.size() >= 4 * kFewestPoints &&
                            own.size() * input.context.geometry->lights() >= kFewestSplitSamples &&
                            room > 0 && halves.differ;
        const int fresh = splits ? next.append(state.exemplars, static_cast<int>(e)) : kept;
        room -= splits ? 1 : 0;
        for (std::size_t k = 0; k < own.size(); ++k)
            state.points[own[k]].assigned.exemplar = halves.second[k] ? fresh : kept;
    }
    state.exemplars = std::move(next);
    drop_candidates(state);
    // The samples of each half determine its table.
    return solve_tables(input, std::move(state));
}

SearchState merge_exemplars(const SearchInput& input, SearchState state) {
    Members members = members_of(state);
    std::vector<bool> alive(members.size(), true);
    for (const std::size_t e : smallest_first(members)) {
        std::vector<std::size_t>& own = members[e];
        double now = 0.0, then = 0.0;
        std::vector<Candidate> move;
        for (const std::size_t p : own) {
            const Alternative other = alternative_to(static_cast<int>(e), state.points[p], alive);
            now += static_cast<double>(state.points[p].fit.error);
            then += other.error;
            move.push_back(other.candidate);
        }
        // Generalized cross-validation (Craven & Wahba 1979): a table of few points is fitted to
        // their noise too, so that its error on other samples is larger by a factor of 1 /
        // freedom^2.
        const double freedom = freedom_of(state.exemplars, static_cast<int>(e), own.size(),
                                          input.context.geometry->lights());
        if (!own.empty() && then > kMergeRatio * now / (freedom * freedom)) continue;
        alive[e] = false;
        for (std::size_t k = 0; k < own.size(); ++k) {
            state.points[own[k]].assigned = move[k];
            if (move[k].exemplar >= 0)
                members[static_cast<std::size_t>(move[k].exemplar)].push_back(own[k]);
        }
        own.clear();
    }
    state = keep_exemplars(std::move(state), std::move(alive));
    return solve_tables(input, refit_points(input, std::move(state)));
}

SearchState join_alike(const SearchInput& input, SearchState state, float alike) {
    const auto between = matches_between(state.exemplars);
    const std::vector<std::size_t> order = smallest_first(members_of(state));
    std::vector<bool> alive(order.size(), true);
    std::vector<Candidate> to(
        order.size());  // of removed exemplars: the target and the added rotation
    for (std::size_t place = 0; place < order.size(); ++place) {
        const std::size_t e = order[place];
        float least = alike;
        for (std::size_t later = place + 1; later < order.size(); ++later) {
            const RotationMatch& match = between[e][order[later]];
            if (match.residual >= least) continue;
            least = match.residual;
            alive[e] = false;
            to[e] = {static_cast<int>(order[later]), match.shift, 0.0f};
        }
    }
    for (PointState& point : state.points) {
        Candidate& own = point.assigned;
        while (own.exemplar >= 0 && !alive[static_cast<std::size_t>(own.exemplar)]) {
            const Candidate& next = to[static_cast<std::size_t>(own.exemplar)];
            own.shift += next.shift;
            own.exemplar = next.exemplar;
        }
    }
    state = keep_exemplars(std::move(state), std::move(alive));
    return solve_tables(input, refit_points(input, std::move(state)));
}

}  // namespace burnish
