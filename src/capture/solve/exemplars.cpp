#include "capture/solve/exemplars.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "core/parallel.hpp"

namespace burnish {

namespace {

// Fewest points of a cluster: one or two points may share only their noise.
constexpr int kFewestMembers = 3;
// Two exemplars are merged if their residual is below this ratio to the smaller of their spreads
// (the median residual of an exemplar's members). It is below 1 because means of many points differ
// less than points do.
constexpr float kMergeFactor = 0.3f;
// Rounds of drawing seeds. Each matches all points against the new seeds; after a few rounds
// k-means|| is within a constant factor of the best seeding.
constexpr int kSeedRounds = 5;

std::size_t cells_of(const NdfGrid& grid) {
    return static_cast<std::size_t>(grid.cells());
}

float cell_mass(const NdfGrid& grid, int ring) {
    return std::cos(grid.theta(ring)) * static_cast<float>(grid.solid_angle(ring));
}

// Scales a table so that its known part has a mass of 1.
void normalize_known(const NdfGrid& grid, float* table, const float* weights) {
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

void append_all(Exemplars& all, const Exemplars& more) {
    for (int e = 0; e < more.count; ++e) all.append(more, e);
}

// Assigns the best of the matcher's exemplars to every point for which it is better than the
// current one. Numbers the matcher's exemplars from `base`.
void improve(const RotationMatcher& matcher, const MaskedTables& points, int base,
             std::vector<Candidate>& assigned) {
    matcher.match(points, [&](std::size_t p, std::span<const RotationMatch> matches) {
        for (std::size_t e = 0; e < matches.size(); ++e)
            if (matches[e].residual < assigned[p].residual)
                assigned[p] = {base + static_cast<int>(e), matches[e].shift, matches[e].residual};
    });
}

// Draws seeds from the points in kSeedRounds rounds; the probability of a point is proportional to
// its current residual (k-means||, Bahmani et al. 2012).
Exemplars seeds(const NdfGrid& grid, const MaskedTables& points, int wanted,
                std::mt19937_64& random, std::vector<Candidate>& assigned,
                const Progress& progress) {
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
        improve(matcher, points, all.count, assigned);
        append_all(all, fresh);
        for (std::size_t p = 0; p < points.count; ++p)
            chance[p] = static_cast<double>(assigned[p].residual);
    }
    return all;
}

// Replaces each exemplar by the mean of its members, rotated back onto it.
void update(const MaskedTables& points, const std::vector<Candidate>& assigned, Exemplars& all) {
    const NdfGrid grid = all.grid;
    const std::size_t cells = cells_of(grid);
    std::vector<std::vector<std::size_t>> members(static_cast<std::size_t>(all.count));
    for (std::size_t p = 0; p < assigned.size(); ++p)
        if (assigned[p].exemplar >= 0)
            members[static_cast<std::size_t>(assigned[p].exemplar)].push_back(p);
    parallel_for(members.size(), 1, [&](std::size_t e, std::size_t) {
        if (members[e].empty()) return;
        std::vector<float> sum(cells, 0.0f), total(cells, 0.0f), masked(cells), value(cells),
            weight(cells);
        for (const std::size_t p : members[e]) {
            const float* t = points.values.data() + p * cells;
            const float* w = points.weights.data() + p * cells;
            for (std::size_t i = 0; i < cells; ++i) masked[i] = w[i] > 0.0f ? w[i] * t[i] : 0.0f;
            rotate_table(grid, masked.data(), -assigned[p].shift, value.data());
            rotate_table(grid, w, -assigned[p].shift, weight.data());
            // The scale of a partial table is unknown: the least-squares fit to the exemplar over
            // the cells known in both determines it.
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
            // A cell is known when its members' weights, each up to 1, add up to 1/2.
            weights[i] = total[i] < 0.5f ? 0.0f : std::min(total[i], 1.0f);
            table[i] = total[i] > 0.0f ? sum[i] / total[i] : 0.0f;
        }
        normalize_known(grid, table, weights);
    });
}

std::vector<Candidate> assign(const MaskedTables& points, const Exemplars& all) {
    std::vector<Candidate> assigned(points.count);
    RotationMatcher matcher(all.grid);
    matcher.set_exemplars(all.tables());
    improve(matcher, points, 0, assigned);
    return assigned;
}

Exemplars only(const Exemplars& all, const std::vector<int>& kept) {
    Exemplars out;
    out.grid = all.grid;
    for (const int e : kept) out.append(all, e);
    return out;
}

std::vector<int> member_counts(const Exemplars& all, const std::vector<Candidate>& assigned) {
    std::vector<int> counts(static_cast<std::size_t>(all.count), 0);
    for (const Candidate& own : assigned)
        if (own.exemplar >= 0) ++counts[static_cast<std::size_t>(own.exemplar)];
    return counts;
}

// The one with the most members stays, even without any: where no point shows a highlight.
void drop_small(Exemplars& all, const std::vector<Candidate>& assigned) {
    const std::vector<int> counts = member_counts(all, assigned);
    const auto largest = std::max_element(counts.begin(), counts.end());
    const int fewest = std::clamp(*largest, 1, kFewestMembers);
    std::vector<int> kept;
    for (int e = 0; e < all.count; ++e)
        if (counts[static_cast<std::size_t>(e)] >= fewest) kept.push_back(e);
    if (kept.empty()) kept.push_back(static_cast<int>(largest - counts.begin()));
    all = only(all, kept);
}

// The median residual of each exemplar's members.
std::vector<float> spreads(const Exemplars& all, const std::vector<Candidate>& assigned) {
    std::vector<std::vector<float>> residuals(static_cast<std::size_t>(all.count));
    for (const Candidate& own : assigned)
        if (own.exemplar >= 0)
            residuals[static_cast<std::size_t>(own.exemplar)].push_back(own.residual);
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

// Drops exemplars that equal one with more members within the spread of their members.
void merge_alike(Exemplars& all, const std::vector<Candidate>& assigned) {
    if (all.count < 2) return;
    const std::vector<float> spread = spreads(all, assigned);
    const auto count = static_cast<std::size_t>(all.count);
    std::vector<float> between(count * count, 1.0f);
    RotationMatcher matcher(all.grid);
    matcher.set_exemplars(all.tables());
    matcher.match(all.tables(), [&](std::size_t p, std::span<const RotationMatch> matches) {
        for (std::size_t e = 0; e < matches.size(); ++e)
            between[p * count + e] = matches[e].residual;
    });
    const std::vector<int> members = member_counts(all, assigned);
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
    all = only(all, kept);
}

}  // namespace

int Exemplars::append(const Exemplars& from, int index) {
    const auto cells = static_cast<std::ptrdiff_t>(grid.cells());
    D.insert(D.end(), from.table(index), from.table(index) + cells);
    weights.insert(weights.end(), from.weight(index), from.weight(index) + cells);
    origin.insert(origin.end(), cells_of(grid), NdfOrigin::extrapolated);
    if (!from.areas.empty())
        areas.insert(areas.end(), from.area(index), from.area(index) + kAreaGrid.cells());
    return count++;
}

void rotate_table(const NdfGrid& grid, const float* table, float shift, float* out) {
    const auto columns = static_cast<float>(grid.azimuths);
    float rotation = std::fmod(shift, columns);
    if (rotation < 0.0f) rotation += columns;
    const int whole = static_cast<int>(rotation) % grid.azimuths;
    const float t = rotation - std::floor(rotation);
    for (int r = 0; r < grid.rings; ++r)
        for (int c = 0; c < grid.azimuths; ++c) {
            const int near = (c - whole + grid.azimuths) % grid.azimuths;
            const int far = (near - 1 + grid.azimuths) % grid.azimuths;
            const float* row = table + static_cast<std::ptrdiff_t>(r) * grid.azimuths;
            out[r * grid.azimuths + c] = row[near] + t * (row[far] - row[near]);
        }
}

Exemplars cluster_points(const NdfGrid& grid, const MaskedTables& points,
                         const ClusterSettings& settings, std::vector<Candidate>& assigned,
                         const Progress& progress) {
    std::mt19937_64 random(settings.seed);
    assigned.assign(points.count, {});
    const int wanted = std::clamp(settings.exemplars, 1, static_cast<int>(points.count));
    Exemplars all = seeds(grid, points, wanted, random, assigned, progress);
    for (int round = 0; round < settings.rounds; ++round) {
        progress.step("clustering", static_cast<double>(round) / settings.rounds);
        assigned = assign(points, all);
        update(points, assigned, all);
        drop_small(all, assigned);
        if (round + 2 >= settings.rounds) merge_alike(all, assign(points, all));
    }
    assigned = assign(points, all);
    return all;
}

std::vector<std::vector<Candidate>> best_candidates(const RotationMatcher& matcher,
                                                    const MaskedTables& points, std::size_t most) {
    std::vector<std::vector<Candidate>> out(points.count);
    matcher.match(points, [&](std::size_t p, std::span<const RotationMatch> matches) {
        std::vector<Candidate> all;
        for (std::size_t e = 0; e < matches.size(); ++e)
            all.push_back({static_cast<int>(e), matches[e].shift, matches[e].residual});
        const std::size_t kept = std::min(most, all.size());
        std::partial_sort(
            all.begin(), all.begin() + static_cast<std::ptrdiff_t>(kept), all.end(),
            [](const Candidate& a, const Candidate& b) { return a.residual < b.residual; });
        all.resize(kept);
        out[p] = std::move(all);
    });
    return out;
}

}  // namespace burnish
