#include "capture/solve/exemplars.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "core/parallel.hpp"

namespace burnish {

namespace {

// A cluster of fewer points is noise that found itself.
constexpr int kFewestMembers = 3;
// Exemplars closer than this share of their members' distance from them are one: means of many
// points differ less than points do.
constexpr float kMergeFactor = 0.3f;
constexpr int kSeedRounds = 5;

std::size_t cells_of(const NdfGrid& grid) {
    return static_cast<std::size_t>(grid.cells());
}

float cell_mass(const NdfGrid& grid, int ring) {
    return std::cos(grid.theta(ring)) * static_cast<float>(grid.solid_angle(ring));
}

// Scales a table so that its known part holds a mass of 1.
void normalise_known(const NdfGrid& grid, float* table, const float* weights) {
    double mass = 0.0;
    for (int i = 0; i < grid.cells(); ++i)
        if (weights[i] > 0.0f)
            mass += static_cast<double>(table[i] * cell_mass(grid, i / grid.azimuths));
    if (mass <= 0.0) return;
    const auto factor = static_cast<float>(1.0 / mass);
    for (int i = 0; i < grid.cells(); ++i) table[i] *= factor;
}

Exemplars with_points(const NdfGrid& grid, const MaskedTables& points,
                      const std::vector<std::size_t>& chosen) {
    Exemplars out;
    out.grid = grid;
    out.count = static_cast<int>(chosen.size());
    const std::size_t cells = cells_of(grid);
    for (const std::size_t p : chosen) {
        const auto from = static_cast<std::ptrdiff_t>(p * cells),
                   to = from + static_cast<std::ptrdiff_t>(cells);
        out.D.insert(out.D.end(), points.values.begin() + from, points.values.begin() + to);
        out.weights.insert(out.weights.end(), points.weights.begin() + from,
                           points.weights.begin() + to);
    }
    return out;
}

void append(Exemplars& all, const Exemplars& more) {
    all.count += more.count;
    all.D.insert(all.D.end(), more.D.begin(), more.D.end());
    all.weights.insert(all.weights.end(), more.weights.begin(), more.weights.end());
}

// Every point's best among the matcher's exemplars, if better than what it has; indices from
// `base`.
void improve(const RotationMatcher& matcher, const MaskedTables& points, int base,
             std::vector<PointTurn>& turns) {
    matcher.match(points, [&](std::size_t p, std::span<const RotationMatch> matches) {
        for (std::size_t e = 0; e < matches.size(); ++e)
            if (matches[e].residual < turns[p].residual)
                turns[p] = {base + static_cast<int>(e), matches[e].shift, matches[e].residual};
    });
}

// Seeds in a few rounds, each drawn by how badly points are matched so far (k-means||, Bahmani et
// al. 2012).
Exemplars seeds(const NdfGrid& grid, const MaskedTables& points, int wanted,
                std::mt19937_64& random, std::vector<PointTurn>& turns, const Progress& progress) {
    Exemplars all;
    all.grid = grid;
    std::vector<double> chance(points.count, 1.0);
    const int rounds = std::min(wanted, kSeedRounds);
    for (int round = 0; round < rounds; ++round) {
        progress.step("first exemplars", static_cast<double>(round) / rounds);
        const int more = (wanted - all.count) / (rounds - round);
        std::vector<std::size_t> chosen;
        for (int k = 0; k < more; ++k) {
            const double total = std::accumulate(chance.begin(), chance.end(), 0.0);
            if (!(total > 0.0)) break;
            double at = std::uniform_real_distribution<double>(0.0, total)(random);
            std::size_t p = 0;
            while (p + 1 < points.count && (at -= chance[p]) > 0.0) ++p;
            chosen.push_back(p);
            chance[p] = 0.0;
        }
        if (chosen.empty()) break;
        const Exemplars fresh = with_points(grid, points, chosen);
        RotationMatcher matcher(grid);
        matcher.set_exemplars(fresh.tables());
        improve(matcher, points, all.count, turns);
        append(all, fresh);
        for (std::size_t p = 0; p < points.count; ++p)
            chance[p] = static_cast<double>(turns[p].residual);
    }
    return all;
}

// The mean of each exemplar's members, turned back onto it.
void update(const MaskedTables& points, const std::vector<PointTurn>& turns, Exemplars& all) {
    const NdfGrid grid = all.grid;
    const std::size_t cells = cells_of(grid);
    std::vector<std::vector<std::size_t>> members(static_cast<std::size_t>(all.count));
    for (std::size_t p = 0; p < turns.size(); ++p)
        if (turns[p].exemplar >= 0)
            members[static_cast<std::size_t>(turns[p].exemplar)].push_back(p);
    parallel_for(members.size(), 1, [&](std::size_t e, std::size_t) {
        if (members[e].empty()) return;
        std::vector<float> sum(cells, 0.0f), total(cells, 0.0f), masked(cells), value(cells),
            weight(cells);
        for (const std::size_t p : members[e]) {
            const float* t = points.values.data() + p * cells;
            const float* w = points.weights.data() + p * cells;
            for (std::size_t i = 0; i < cells; ++i) masked[i] = w[i] > 0.0f ? w[i] * t[i] : 0.0f;
            turn_table(grid, masked.data(), -turns[p].shift, value.data());
            turn_table(grid, w, -turns[p].shift, weight.data());
            // The same shape on what both know: least squares of the scale against the exemplar.
            double own = 0.0, both = 0.0;
            const float* c = all.table(static_cast<int>(e));
            const float* cw = all.weight(static_cast<int>(e));
            for (std::size_t i = 0; i < cells; ++i) {
                if (!(weight[i] > 0.0f && cw[i] > 0.0f)) continue;
                const float mass = cell_mass(grid, static_cast<int>(i) / grid.azimuths);
                const float v = value[i] / weight[i];
                own += static_cast<double>(mass * v * v);
                both += static_cast<double>(mass * v * c[i]);
            }
            const auto scale = static_cast<float>(own > 0.0 && both > 0.0 ? both / own : 1.0);
            for (std::size_t i = 0; i < cells; ++i) {
                sum[i] += scale * value[i];
                total[i] += weight[i];
            }
        }
        float* table = all.table(static_cast<int>(e));
        float* weights = all.weight(static_cast<int>(e));
        for (std::size_t i = 0; i < cells; ++i) {
            // A cell is known when half a point has seen it.
            weights[i] = total[i] < 0.5f ? 0.0f : std::min(total[i], 1.0f);
            table[i] = total[i] > 0.0f ? sum[i] / total[i] : 0.0f;
        }
        normalise_known(grid, table, weights);
    });
}

std::vector<PointTurn> assign(const MaskedTables& points, const Exemplars& all) {
    std::vector<PointTurn> turns(points.count);
    RotationMatcher matcher(all.grid);
    matcher.set_exemplars(all.tables());
    improve(matcher, points, 0, turns);
    return turns;
}

void keep_only(Exemplars& all, const std::vector<int>& kept) {
    Exemplars out;
    out.grid = all.grid;
    out.count = static_cast<int>(kept.size());
    const auto cells = static_cast<std::ptrdiff_t>(cells_of(all.grid));
    for (const int e : kept) {
        out.D.insert(out.D.end(), all.table(e), all.table(e) + cells);
        out.weights.insert(out.weights.end(), all.weight(e), all.weight(e) + cells);
    }
    all = std::move(out);
}

std::vector<int> member_counts(const Exemplars& all, const std::vector<PointTurn>& turns) {
    std::vector<int> counts(static_cast<std::size_t>(all.count), 0);
    for (const PointTurn& turn : turns)
        if (turn.exemplar >= 0) ++counts[static_cast<std::size_t>(turn.exemplar)];
    return counts;
}

void drop_small(Exemplars& all, const std::vector<PointTurn>& turns) {
    const std::vector<int> counts = member_counts(all, turns);
    const int fewest =
        std::min<int>(kFewestMembers, *std::max_element(counts.begin(), counts.end()));
    std::vector<int> kept;
    for (int e = 0; e < all.count; ++e)
        if (counts[static_cast<std::size_t>(e)] >= std::max(fewest, 1)) kept.push_back(e);
    keep_only(all, kept);
}

// Of each exemplar: the median residual of its members.
std::vector<float> spreads(const Exemplars& all, const std::vector<PointTurn>& turns) {
    std::vector<std::vector<float>> residuals(static_cast<std::size_t>(all.count));
    for (const PointTurn& turn : turns)
        if (turn.exemplar >= 0)
            residuals[static_cast<std::size_t>(turn.exemplar)].push_back(turn.residual);
    std::vector<float> out;
    for (auto& some : residuals) {
        if (some.empty()) {
            out.push_back(0.0f);
            continue;
        }
        const auto middle = some.begin() + static_cast<std::ptrdiff_t>(some.size() / 2);
        std::nth_element(some.begin(), middle, some.end());
        out.push_back(*middle);
    }
    return out;
}

// Larger clusters take in smaller ones that are alike within their members' own spread.
void merge_alike(Exemplars& all, const std::vector<PointTurn>& turns) {
    if (all.count < 2) return;
    const std::vector<float> spread = spreads(all, turns);
    const auto count = static_cast<std::size_t>(all.count);
    std::vector<float> between(count * count, 1.0f);
    RotationMatcher matcher(all.grid);
    matcher.set_exemplars(all.tables());
    matcher.match(all.tables(), [&](std::size_t p, std::span<const RotationMatch> matches) {
        for (std::size_t e = 0; e < matches.size(); ++e)
            between[p * count + e] = matches[e].residual;
    });
    const std::vector<int> members = member_counts(all, turns);
    std::vector<int> order(count);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return members[static_cast<std::size_t>(a)] > members[static_cast<std::size_t>(b)];
    });
    std::vector<int> kept;
    for (const int e : order) {
        const bool has_twin = std::any_of(kept.begin(), kept.end(), [&](int k) {
            const float own =
                std::min(spread[static_cast<std::size_t>(e)], spread[static_cast<std::size_t>(k)]);
            return between[static_cast<std::size_t>(e) * count + static_cast<std::size_t>(k)] <
                   kMergeFactor * own;
        });
        if (!has_twin) kept.push_back(e);
    }
    std::sort(kept.begin(), kept.end());
    keep_only(all, kept);
}

}  // namespace

void turn_table(const NdfGrid& grid, const float* table, float shift, float* out) {
    const auto columns = static_cast<float>(grid.azimuths);
    float turn = std::fmod(shift, columns);
    if (turn < 0.0f) turn += columns;
    const int whole = static_cast<int>(turn) % grid.azimuths;
    const float t = turn - std::floor(turn);
    for (int r = 0; r < grid.rings; ++r)
        for (int c = 0; c < grid.azimuths; ++c) {
            const int near = (c - whole + grid.azimuths) % grid.azimuths;
            const int far = (near - 1 + grid.azimuths) % grid.azimuths;
            const float* row = table + static_cast<std::ptrdiff_t>(r) * grid.azimuths;
            out[r * grid.azimuths + c] = row[near] + t * (row[far] - row[near]);
        }
}

Exemplars cluster_points(const NdfGrid& grid, const MaskedTables& points,
                         const ClusterSettings& settings, std::vector<PointTurn>& turns,
                         const Progress& progress) {
    std::mt19937_64 random(settings.seed);
    turns.assign(points.count, {});
    const int wanted = std::clamp(settings.exemplars, 1, static_cast<int>(points.count));
    Exemplars all = seeds(grid, points, wanted, random, turns, progress);
    for (int round = 0; round < settings.rounds; ++round) {
        progress.step("clustering", static_cast<double>(round) / settings.rounds);
        turns = assign(points, all);
        update(points, turns, all);
        drop_small(all, turns);
        if (round + 2 >= settings.rounds) merge_alike(all, assign(points, all));
    }
    turns = assign(points, all);
    all.origin.assign(all.D.size(), NdfOrigin::extrapolated);
    return all;
}

std::vector<std::vector<PointTurn>> best_turns(const RotationMatcher& matcher,
                                               const MaskedTables& points, std::size_t most) {
    std::vector<std::vector<PointTurn>> out(points.count);
    matcher.match(points, [&](std::size_t p, std::span<const RotationMatch> matches) {
        std::vector<PointTurn> all;
        for (std::size_t e = 0; e < matches.size(); ++e)
            all.push_back({static_cast<int>(e), matches[e].shift, matches[e].residual});
        const std::size_t kept = std::min(most, all.size());
        std::partial_sort(
            all.begin(), all.begin() + static_cast<std::ptrdiff_t>(kept), all.end(),
            [](const PointTurn& a, const PointTurn& b) { return a.residual < b.residual; });
        all.resize(kept);
        out[p] = std::move(all);
    });
    return out;
}

}  // namespace burnish
