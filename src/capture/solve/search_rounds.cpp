// Solves for points and tables alternately.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "burnish/error.hpp"
#include "capture/solve/partial_ndf.hpp"
#include "capture/solve/peak_normal.hpp"
#include "capture/solve/point_fit.hpp"
#include "capture/solve/search_state.hpp"
#include "core/parallel.hpp"

namespace burnish {

namespace {

// Candidates tried for each point: a match of partial tables nearly always ranks the right exemplar
// among the first.
constexpr std::size_t kTrainingCandidates = 6;
// Half width, in columns, of the search around a matched rotation: partial tables are blurred by
// about a column.
constexpr float kSearchColumns = 1.5f;
// Points of an exemplar from which its step along the diffuse direction is computed: enough for one
// number.
constexpr std::size_t kSlidePoints = 256;
// Least curvature of a peak (peak_slope) for centering an exemplar, that of alpha 1. Many points
// show an exemplar from all sides, so that the center of even a broad lobe is known.
constexpr double kLeastExemplarBend = 2.0;
// Points in one work item.
constexpr std::size_t kPointTile = 32;

// Tries the point's candidates; returns false if none explains any of its light.
bool assign_best(const SearchState& state, const PixelWork& work, PointState& point) {
    const PointFitter fitter(work.samples, static_cast<float>(state.eta));
    point.fit = {};
    point.fit.error = kNoFit;
    point.trials.clear();
    for (const Candidate& candidate : point.candidates) {
        const PointFit fit =
            fitter.refined(state.tables_of(candidate.exemplar), candidate.shift, kSearchColumns);
        point.trials.push_back(fit);
        if (fit.error >= point.fit.error) continue;
        point.fit = fit;
        point.assigned = {candidate.exemplar, fit.shift, candidate.residual};
    }
    if (point.fit.error < kNoFit) return true;
    point.fit = {};
    point.assigned.exemplar = -1;
    return false;
}

void fit_point(const SearchInput& input, const SearchState& state, std::size_t p, PixelWork& work,
               PointState& point) {
    point.signature.fill(0.0f);
    input.context.gather(input.pixels[p], point.normal, input.values_of(p), work);
    if (!assign_best(state, work, point)) return;
    const auto eta = static_cast<float>(state.eta);
    const ExemplarTables own = state.tables_of(point.assigned.exemplar);
    if (input.settings.normals != NormalStart::none) {
        point.normal =
            refined_normal({input.context, input.pixels[p], input.values_of(p), eta, own},
                           point.normal, work, point.fit);
        point.assigned.shift = point.fit.shift;
    }
    residual_signature(own, work.samples, PointFitter(work.samples, eta), point.fit,
                       point.signature);
    for (Candidate& candidate : point.candidates)
        if (candidate.exemplar == point.assigned.exemplar) candidate.shift = point.fit.shift;
}

// Centers the exemplars. A tilt of all normals of an exemplar's points and an opposite lean of the
// exemplar predict the same samples; the lean is moved from the exemplar to the normals.
SearchState center_exemplars(const SearchInput& input, SearchState state) {
    const auto members = members_of(state);
    const NdfGrid& grid = input.context.grid;
    for (int e = 0; e < state.exemplars.count; ++e) {
        const std::array<float, 2> slope = peak_slope(
            grid, state.exemplars.table(e), state.exemplars.weight(e), kLeastExemplarBend);
        for (const std::size_t p : members[static_cast<std::size_t>(e)]) {
            PointState& point = state.points[p];
            const float angle = point.assigned.shift * 2.0f * std::numbers::pi_v<float> /
                                static_cast<float>(grid.azimuths);
            const float c = std::cos(angle), s = std::sin(angle);
            point.normal = tilted_normal(
                point.normal, {c * slope[0] - s * slope[1], s * slope[0] + c * slope[1]});
        }
    }
    return solve_tables(input, std::move(state));
}

void match_candidates(const SearchInput& input, const PartialTables& partial, SearchState& state) {
    RotationMatcher matcher(input.context.grid);
    matcher.set_exemplars(state.exemplars.tables());
    auto candidates = best_candidates(matcher, partial.masked(), kTrainingCandidates);
    for (std::size_t p = 0; p < state.points.size(); ++p) {
        PointState& point = state.points[p];
        point.candidates = std::move(candidates[p]);
        if (point.assigned.exemplar >= 0) point.candidates.push_back(point.assigned);
    }
}

}  // namespace

std::vector<std::vector<std::size_t>> members_of(const SearchState& state) {
    std::vector<std::vector<std::size_t>> out(static_cast<std::size_t>(state.exemplars.count));
    for (std::size_t p = 0; p < state.points.size(); ++p)
        if (const int e = state.points[p].assigned.exemplar; e >= 0)
            out[static_cast<std::size_t>(e)].push_back(p);
    return out;
}

double mean_error(const SearchState& state) {
    double sum = 0.0;
    for (const PointState& point : state.points)
        sum += std::min(static_cast<double>(point.fit.error), 1.0);
    return sum / std::max<double>(1.0, static_cast<double>(state.points.size()));
}

SearchState solve_partial(const SearchInput& input, double eta, PartialTables& partial) {
    SearchState state;
    state.eta = eta;
    state.points.resize(input.pixels.size());
    const auto cells = static_cast<std::size_t>(input.context.grid.cells());
    partial.count = state.points.size();
    partial.tables.resize(partial.count * cells);
    partial.weights.resize(partial.count * cells);
    const PartialNdfSolver solver(input.context.grid, input.context.spacing_rad,
                                  static_cast<float>(eta));
    input.progress.step("partial distributions", 0.0);
    parallel_for(partial.count, kPointTile, [&](std::size_t begin, std::size_t end) {
        input.progress.throw_if_cancelled();
        PixelWork work;
        PartialNdfWork partial_work;
        for (std::size_t p = begin; p < end; ++p) {
            float* table = partial.tables.data() + p * cells;
            float* weights = partial.weights.data() + p * cells;
            Vec3f& normal = state.points[p].normal;
            normal = first_normal(input.settings.normals, input.context, solver, input.pixels[p],
                                  input.values_of(p), work, partial_work, table, weights);
        }
    });
    return state;
}

SearchState solve_round(const SearchInput& input, const PartialTables& partial, SearchState state,
                        bool match) {
    if (match) match_candidates(input, partial, state);
    parallel_for(state.points.size(), kPointTile, [&](std::size_t begin, std::size_t end) {
        input.progress.throw_if_cancelled();
        PixelWork work;
        for (std::size_t p = begin; p < end; ++p) fit_point(input, state, p, work, state.points[p]);
    });
    state = solve_tables(input, std::move(state));
    return input.settings.normals != NormalStart::none ? center_exemplars(input, std::move(state))
                                                       : state;
}

SearchState refit_points(const SearchInput& input, SearchState state) {
    parallel_for(state.points.size(), kPointTile, [&](std::size_t begin, std::size_t end) {
        input.progress.throw_if_cancelled();
        PixelWork work;
        for (std::size_t p = begin; p < end; ++p) {
            PointState& point = state.points[p];
            if (point.assigned.exemplar < 0) continue;
            input.context.gather(input.pixels[p], point.normal, input.values_of(p), work);
            point.fit = PointFitter(work.samples, static_cast<float>(state.eta))
                            .at(state.tables_of(point.assigned.exemplar), point.assigned.shift);
        }
    });
    return state;
}

SearchState solve_tables(const SearchInput& input, SearchState state) {
    const auto eta = static_cast<float>(state.eta);
    const auto members = members_of(state);
    parallel_for(members.size(), 1, [&](std::size_t e, std::size_t) {
        TableEquations equations(input.context.grid);
        const ExemplarTables tables = state.tables_of(static_cast<int>(e));
        PixelWork work;
        const auto gather = [&](std::size_t p) {
            input.context.gather(input.pixels[p], state.points[p].normal, input.values_of(p), work);
        };
        for (const std::size_t p : members[e]) {
            input.progress.throw_if_cancelled();
            gather(p);
            equations.add(work.samples, PointFitter(work.samples, eta), tables,
                          state.points[p].fit);
        }
        float* table = state.exemplars.table(static_cast<int>(e));
        equations.solve(table, state.exemplars.weight(static_cast<int>(e)));
        const std::vector<float> mimic = equations.diffuse_mimic();
        SlideAlong slide;
        for (std::size_t k = 0; k < members[e].size(); k += 1 + members[e].size() / kSlidePoints) {
            const std::size_t p = members[e][k];
            gather(p);
            slide.add(work.samples, PointFitter(work.samples, eta), tables, mimic.data(),
                      state.points[p].fit);
        }
        for (std::size_t i = 0; i < mimic.size(); ++i)
            table[i] = std::max(table[i] + slide.distance() * mimic[i], 0.0f);
    });
    state.completion = complete_exemplars(state.exemplars);
    return state;
}

}  // namespace burnish
