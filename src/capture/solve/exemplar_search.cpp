#include "capture/solve/exemplar_search.hpp"

#include <algorithm>

#include "capture/solve/search_state.hpp"

namespace burnish {

namespace {

// Rounds of solving. Exemplars are joined after the first, split after each of the next, joined
// again after round kSplitRounds, and merged after each further round except the last.
constexpr int kSolveRounds = 8, kSplitRounds = 4;
// Rounds if normals may tilt: normals, rotations and tables take longer to converge together. With
// 8 rounds some simulated samples stay 10 dB worse.
constexpr int kTiltedRounds = 16;
// Residuals (RotationMatch) below which two exemplars are joined. The first is generous, as splits
// separate exemplars that differ. The last is the residual of equal exemplars with 1 % of noise.
constexpr float kAlikeAtFirst = 0.03f, kAlikeAtLast = 0.004f;
// The initial index of refraction: that of glass, varnish and most polymers.
constexpr double kFirstEta = 1.5;
// Rounds of solving for each trial of an index, and after the last trial. Only points that see one
// facet at different angles separate F from D, so that the tables must be solved for with each
// index.
constexpr int kEtaTrialRounds = 3, kEtaLastRounds = 2;
// Trials of the golden section after its first two: they reduce the bracket of sqrt(F(1)) from 0.51
// to 0.018.
constexpr int kEtaTrials = 7;
// Initial numbers of training points and of their samples for each exemplar: at least as many samples
// as a table of the usual grid has cells. With 16 points under 25 lights, tables fit any normals.
constexpr int kPointsPerExemplar = 16;
constexpr std::size_t kSamplesPerExemplar = 3072;

// `start` with the normals of `now`: they hardly depend on the index and improve with every trial.
SearchState restarted(const SearchState& start, const SearchState& now) {
    SearchState out = start;
    for (std::size_t p = 0; p < out.points.size(); ++p) out.points[p].normal = now.points[p].normal;
    return out;
}

// Golden section over sqrt(F(1)) = (eta-1)/(eta+1); equal steps of it change the shape of F by
// about equal amounts. Returns the state with the index that explains the points best.
SearchState estimate_eta(const SearchInput& input, const PartialTables& partial,
                         const SearchState& start) {
    SearchState now = start;
    const auto eta_of = [](double root) { return (1.0 + root) / (1.0 - root); };
    const auto cost = [&](double root) {
        now = restarted(start, now);
        now.eta = eta_of(root);
        for (int round = 0; round < kEtaTrialRounds; ++round)
            now = solve_round(input, partial, std::move(now), false);
        return mean_error(now);
    };
    constexpr double kGolden = 0.6180339887498949;
    double low = 0.09, high = 0.6;  // eta 1.2 to 4
    double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
    double at_a = cost(a), at_b = cost(b);
    for (int k = 0; k < kEtaTrials; ++k) {
        input.progress.step("index of refraction", static_cast<double>(k) / kEtaTrials);
        if (at_a < at_b) {
            high = b;
            b = a;
            at_b = at_a;
            a = high - kGolden * (high - low);
            at_a = cost(a);
        } else {
            low = a;
            a = b;
            at_a = at_b;
            b = low + kGolden * (high - low);
            at_b = cost(b);
        }
    }
    now = restarted(start, now);
    now.eta = eta_of(0.5 * (low + high));
    return now;
}

SearchState clustered(const SearchInput& input, const PartialTables& partial, SearchState state) {
    const std::size_t samples = partial.count * input.context.geometry->lights();
    const int most = std::max(1, std::min(static_cast<int>(partial.count) / kPointsPerExemplar,
                                          static_cast<int>(samples / kSamplesPerExemplar)));
    const int wanted = std::clamp(input.settings.exemplars, 1, most);
    std::vector<Candidate> assigned;
    state.exemplars = cluster_points(input.context.grid, partial.masked(),
                                     {.exemplars = wanted, .seed = input.settings.seed}, assigned,
                                     input.progress);
    for (std::size_t p = 0; p < assigned.size(); ++p) state.points[p].assigned = assigned[p];
    state.completion = complete_exemplars(state.exemplars);
    return state;
}

// Applies the change of exemplars that follows a round.
SearchState changed(const SearchInput& input, SearchState state, int round, int rounds) {
    if (round == 0) return join_alike(input, std::move(state), kAlikeAtFirst);
    if (round < kSplitRounds) return split_exemplars(input, std::move(state));
    if (round == kSplitRounds) return join_alike(input, std::move(state), kAlikeAtLast);
    if (round + 1 < rounds) return merge_exemplars(input, std::move(state));
    return state;
}

}  // namespace

FoundExemplars find_exemplars(const SampleContext& context, const std::vector<std::size_t>& pixels,
                              const std::vector<float>& values,
                              const ExemplarSearchSettings& settings, const Progress& progress) {
    const SearchInput input{context, pixels, values, settings, progress};
    PartialTables partial;
    SearchState state = solve_partial(input, settings.eta.value_or(kFirstEta), partial);
    state = clustered(input, partial, std::move(state));
    const int rounds = settings.normals != NormalStart::none ? kTiltedRounds : kSolveRounds;
    for (int round = 0; round < rounds; ++round) {
        progress.step("solving exemplars", static_cast<double>(round) / rounds);
        state = solve_round(input, partial, std::move(state), true);
        state = changed(input, std::move(state), round, rounds);
    }
    if (!settings.eta) {
        state = estimate_eta(input, partial, state);
        for (int round = 0; round < kEtaLastRounds; ++round)
            state = solve_round(input, partial, std::move(state), false);
    }
    const double error = mean_error(state);
    return {std::move(state.exemplars), state.completion, state.eta, error};
}

}  // namespace burnish
