// Completes exemplars (W08, section on synthesis). Cells that no rotation of an exemplar's own
// points reaches are taken from similar exemplars whose points reach them; the rest is
// extrapolated.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "capture/solve/exemplar_solve.hpp"

namespace burnish {

namespace {

// Largest residual (RotationMatch) for which an exemplar gives cells to another.
constexpr float kLargestResidual = 0.05f;
// Largest number of donors of an exemplar, the most similar first.
constexpr std::size_t kMostDonors = 4;
// Bounds of the power of the slope in a tail: GGX's tail has the fourth power, a Gaussian falls
// faster than any power.
constexpr float kLeastPower = 4.0f, kMostPower = 12.0f;
// Weight of a cell that was taken from another exemplar; cells determined by samples have weight 1.
constexpr float kTakenWeight = 0.5f;

std::size_t cells_of(const Exemplars& all) {
    return static_cast<std::size_t>(all.grid.cells());
}

// Weights averaged over three columns and rings, so that they decrease towards a seam.
std::vector<float> feathered(const NdfGrid& grid, const float* weights) {
    std::vector<float> out(static_cast<std::size_t>(grid.cells()));
    for (int r = 0; r < grid.rings; ++r)
        for (int c = 0; c < grid.azimuths; ++c) {
            float sum = 0.0f;
            for (int dr = -1; dr <= 1; ++dr)
                for (int dc = -1; dc <= 1; ++dc) {
                    const int ring = std::clamp(r + dr, 0, grid.rings - 1);
                    const int column = (c + dc + grid.azimuths) % grid.azimuths;
                    sum += weights[ring * grid.azimuths + column] > 0.0f ? 1.0f / 9.0f : 0.0f;
                }
            const int i = r * grid.azimuths + c;
            out[static_cast<std::size_t>(i)] = weights[i] > 0.0f ? sum : 0.0f;
        }
    return out;
}

// Sums the donors' values at every cell, each donor rotated and scaled to the exemplar; `known`
// receives the sum of their weights.
void gather_donors(const Exemplars& all, const std::vector<Candidate>& donors,
                   const std::vector<float>& scales, std::vector<float>& sum,
                   std::vector<float>& known) {
    const std::size_t cells = cells_of(all);
    std::vector<float> masked(cells), value(cells), weight(cells);
    sum.assign(cells, 0.0f);
    known.assign(cells, 0.0f);
    for (std::size_t k = 0; k < donors.size(); ++k) {
        const float* d = all.table(donors[k].exemplar);
        const float* w = all.weight(donors[k].exemplar);
        for (std::size_t i = 0; i < cells; ++i) masked[i] = w[i] * d[i];
        rotate_table(all.grid, masked.data(), donors[k].shift, value.data());
        rotate_table(all.grid, w, donors[k].shift, weight.data());
        const float trust = 1.0f / (donors[k].residual + 1e-4f);
        for (std::size_t i = 0; i < cells; ++i) {
            sum[i] += trust * scales[k] * value[i];
            known[i] += trust * weight[i];
        }
    }
    for (std::size_t i = 0; i < cells; ++i)
        if (known[i] > 0.0f) sum[i] /= known[i];
}

// Fills the cells that `e` lacks and its donors have; returns true if there were any.
bool take_from_others(const Exemplars& before, int e, const std::vector<Candidate>& donors,
                      const std::vector<float>& scales, Exemplars& after) {
    std::vector<float> sum, known;
    gather_donors(before, donors, scales, sum, known);
    const float* own_weights = before.weight(e);
    const std::vector<float> own = feathered(before.grid, own_weights);
    float* table = after.table(e);
    float* weights = after.weight(e);
    bool any = false;
    for (std::size_t i = 0; i < own.size(); ++i) {
        if (known[i] <= 0.0f) continue;
        const bool missing = own_weights[i] <= 0.0f;
        const float share = missing ? 0.0f : own[i];
        table[i] = share * before.table(e)[i] + (1.0f - share) * sum[i];
        if (!missing) continue;
        weights[i] = kTakenWeight;
        after.origin[static_cast<std::size_t>(e) * own.size() + i] = NdfOrigin::completed;
        any = true;
    }
    return any;
}

// The power of the slope with which the density of slopes, P = D cos^4, falls at the outermost
// known ring of an azimuth, from averages over neighboring columns.
float tail_power(const Exemplars& all, int e, int column, int ring) {
    const NdfGrid& grid = all.grid;
    const auto mean = [&](int r) {
        float sum = 0.0f, count = 0.0f;
        for (int dc = -2; dc <= 2; ++dc) {
            const int i = r * grid.azimuths + (column + dc + grid.azimuths) % grid.azimuths;
            if (all.weight(e)[i] <= 0.0f) continue;
            sum += all.table(e)[i];
            count += 1.0f;
        }
        return count > 0.0f ? sum / count : 0.0f;
    };
    const int inner = std::max(ring - 3, 0);
    const float t0 = grid.theta(inner), t1 = grid.theta(ring);
    const float d0 = mean(inner), d1 = mean(ring);
    if (inner == ring || d0 <= 0.0f || d1 <= 0.0f) return kLeastPower;
    const float p0 = d0 * std::pow(std::cos(t0), 4.0f), p1 = d1 * std::pow(std::cos(t1), 4.0f);
    const float power = -std::log(p1 / p0) / std::log(std::tan(t1) / std::tan(t0));
    return std::clamp(power, kLeastPower, kMostPower);
}

void extrapolate(Exemplars& all, int e) {
    const NdfGrid& grid = all.grid;
    float* table = all.table(e);
    const float* weights = all.weight(e);
    for (int c = 0; c < grid.azimuths; ++c) {
        int last = grid.rings - 1;
        while (last >= 0 && weights[last * grid.azimuths + c] <= 0.0f) --last;
        // Nothing is known along this azimuth; it is filled from neighboring columns below.
        if (last < 0) continue;
        const float power = tail_power(all, e, c, last);
        const float t0 = grid.theta(last);
        float from = 0.0f;
        int count = 0;
        for (int dc = -1; dc <= 1; ++dc) {
            const int i = last * grid.azimuths + (c + dc + grid.azimuths) % grid.azimuths;
            if (weights[i] <= 0.0f) continue;
            from += table[i];
            ++count;
        }
        from /= static_cast<float>(std::max(count, 1));
        for (int r = last + 1; r < grid.rings; ++r) {
            const float t = grid.theta(r);
            // cos^(power - 4): 0 at the horizon for tails that fall faster than GGX's.
            table[r * grid.azimuths + c] = from * std::pow(std::sin(t0) / std::sin(t), power) *
                                           std::pow(std::cos(t) / std::cos(t0), power - 4.0f);
        }
    }
    // Gaps within the last known ring and unknown azimuths are filled from the nearest known
    // azimuths.
    for (int r = 0; r < grid.rings; ++r)
        for (int c = 0; c < grid.azimuths; ++c) {
            const int i = r * grid.azimuths + c;
            if (weights[i] > 0.0f) continue;
            bool outside = true;
            for (int k = r; k < grid.rings && outside; ++k)
                outside = weights[k * grid.azimuths + c] <= 0.0f;
            bool any = false;
            for (int k = 0; k < grid.rings && !any; ++k)
                any = weights[k * grid.azimuths + c] > 0.0f;
            if (outside && any) continue;
            float sum = 0.0f, total = 0.0f;
            for (int d = 1; d <= grid.azimuths / 2 && total <= 0.0f; ++d)
                for (const int dc : {-d, d}) {
                    const int j = r * grid.azimuths + (c + dc + grid.azimuths) % grid.azimuths;
                    if (weights[j] <= 0.0f) continue;
                    sum += table[j];
                    total += 1.0f;
                }
            table[i] = total > 0.0f ? sum / total : 0.0f;
        }
}

void normalize(Exemplars& all, int e) {
    float* table = all.table(e);
    const double mass = ndf_mass(all.grid, table);
    if (!(mass > 0.0)) {
        // Without a highlight the shape is unknown: D is constant and all cells are extrapolated.
        std::fill_n(table, cells_of(all), std::numbers::inv_pi_v<float>);
        return;
    }
    for (std::size_t i = 0; i < cells_of(all); ++i) table[i] = static_cast<float>(table[i] / mass);
}

}  // namespace

CompletionReport complete_exemplars(Exemplars& exemplars) {
    CompletionReport report;
    const std::size_t cells = cells_of(exemplars);
    for (std::size_t i = 0; i < exemplars.origin.size(); ++i)
        exemplars.origin[i] =
            exemplars.weights[i] > 0.0f ? NdfOrigin::measured : NdfOrigin::extrapolated;
    if (exemplars.count > 1) {
        RotationMatcher matcher(exemplars.grid);
        matcher.set_exemplars(exemplars.tables());
        std::vector<std::vector<Candidate>> donors(static_cast<std::size_t>(exemplars.count));
        std::vector<std::vector<float>> scales(donors.size());
        matcher.match(exemplars.tables(), [&](std::size_t p,
                                              std::span<const RotationMatch> matches) {
            std::vector<std::size_t> order;
            for (std::size_t e = 0; e < matches.size(); ++e)
                if (e != p && matches[e].residual < kLargestResidual) order.push_back(e);
            std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
                return matches[a].residual < matches[b].residual;
            });
            order.resize(std::min(order.size(), kMostDonors));
            for (const std::size_t e : order) {
                donors[p].push_back({static_cast<int>(e), matches[e].shift, matches[e].residual});
                scales[p].push_back(matches[e].scale);
            }
        });
        const Exemplars before = exemplars;
        for (int e = 0; e < exemplars.count; ++e)
            if (take_from_others(before, e, donors[static_cast<std::size_t>(e)],
                                 scales[static_cast<std::size_t>(e)], exemplars))
                ++report.completed;
    }
    exemplars.areas.clear();
    double total = 0.0;
    for (int e = 0; e < exemplars.count; ++e) {
        extrapolate(exemplars, e);
        normalize(exemplars, e);
        const std::vector<float> areas = ndf_areas(exemplars.grid, exemplars.table(e));
        exemplars.areas.insert(exemplars.areas.end(), areas.begin(), areas.end());
        for (std::size_t i = 0; i < cells; ++i) {
            const double share =
                exemplars.grid.solid_angle(static_cast<int>(i) / exemplars.grid.azimuths);
            const NdfOrigin origin = exemplars.origin[static_cast<std::size_t>(e) * cells + i];
            total += share;
            if (origin == NdfOrigin::measured) report.measured += share;
            if (origin == NdfOrigin::completed) report.completed_share += share;
            if (origin == NdfOrigin::extrapolated) report.extrapolated += share;
        }
    }
    if (total > 0.0) {
        report.measured /= total;
        report.completed_share /= total;
        report.extrapolated /= total;
    }
    return report;
}

}  // namespace burnish
