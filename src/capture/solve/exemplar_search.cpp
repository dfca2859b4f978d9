#include "capture/solve/exemplar_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "burnish/error.hpp"
#include "capture/solve/partial_ndf.hpp"
#include "capture/solve/peak_normal.hpp"
#include "capture/solve/residual_signature.hpp"
#include "core/parallel.hpp"

namespace burnish {

namespace {

// Rounds of solving: the first joins, the next split, one joins again, the rest merge.
constexpr int kSolveRounds = 8, kSplitRounds = 4;
// Normals, turns and tables take longer to agree: with 8 rounds some samples stay 10 dB worse.
constexpr int kTiltedRounds = 16;
constexpr std::size_t kTrainingCandidates = 6;
constexpr std::size_t kFewestMembers = 4;
// Mean errors of the worse and the better half of an exemplar's points: noise alone makes 1.1.
constexpr double kSplitRatio = 1.8;
// Share of one direction in the variance of what is left of them: noise alone has a few hundredths.
constexpr double kSplitVariation = 0.15;
// By how much the mean error of an exemplar's points may grow when others take them.
constexpr double kMergeRatio = 1.25;
// Residuals (RotationMatch) below which tables are one: at first generously, as what differs is
// split again; then as close as noise lets them come.
constexpr float kAlikeAtFirst = 0.03f, kAlike = 0.004f;
// Points of an exemplar that its slide along the diffuse direction is worked out from.
constexpr std::size_t kSlidePoints = 256;
constexpr double kFirstEta = 1.5;
// Of an exemplar, which many turns show from all sides, even broad lobes have a middle (alpha 1).
constexpr double kLeastExemplarBend = 2.0;

}  // namespace

ExemplarSearch::ExemplarSearch(const SampleContext& context, const std::vector<std::size_t>& pixels,
                               const std::vector<float>& values,
                               const ExemplarSearchSettings& settings, const Progress& progress)
    : context_(context),
      pixels_(pixels),
      values_(values),
      settings_(settings),
      progress_(progress),
      normals_(pixels.size(), Vec3f{0.0f, 0.0f, 1.0f}) {}

namespace {

// From the slope of least error where the error is a paraboloid, through six places a step apart;
// no farther than two steps; `middle` is the error at the first of them. A lobe is stiff across its
// groove and soft along it, so that x and y for themselves would hardly get anywhere.
template <typename ErrorAt>
std::array<float, 2> least_slope(const ErrorAt& error, float middle, float step) {
    const float right = error(step, 0.0f), up = error(0.0f, step);
    const float left = error(-step, 0.0f), down = error(0.0f, -step);
    const float both = error(step, step);
    const float xx = right - 2.0f * middle + left, yy = up - 2.0f * middle + down;
    const float xy = both - right - up + middle;
    const float gx = 0.5f * (right - left), gy = 0.5f * (up - down);
    float x = 0.0f, y = 0.0f;
    if (const float det = xx * yy - xy * xy; xx > 0.0f && det > 0.0f) {
        x = -(yy * gx - xy * gy) / det;
        y = -(xx * gy - xy * gx) / det;
    } else {  // downhill along the axes that bend up
        if (xx > 0.0f) x = -gx / xx;
        if (yy > 0.0f) y = -gy / yy;
    }
    const float scale = step * std::min(1.0f, 2.0f / std::max(std::hypot(x, y), 1e-6f));
    return {scale * x, scale * y};
}

}  // namespace

Vec3f refined_normal(const SampleContext& context, std::size_t pixel, const float* values,
                     float eta, const ExemplarTables& tables, Vec3f normal, PixelWork& work,
                     PointFit& fit) {
    const auto error = [&](const Vec3f& n) {
        context.gather(pixel, n, values, work);
        return PointFitter(work.samples, eta).at(tables, fit.shift).error;
    };
    for (const float step : {0.04f, 0.015f}) {
        const float now = error(normal);
        const std::array<float, 2> move = least_slope(
            [&](float x, float y) {
                return error(tilted_normal(normal, {x, y}));
            },
            now, step);
        const Vec3f next = tilted_normal(normal, move);
        if (error(next) < now) normal = next;
        context.gather(pixel, normal, values, work);
        fit = PointFitter(work.samples, eta).refined(tables, fit.shift, 0.5f);
    }
    return normal;
}

std::vector<std::vector<std::size_t>> ExemplarSearch::members() const {
    std::vector<std::vector<std::size_t>> out(static_cast<std::size_t>(exemplars_.count));
    for (std::size_t p = 0; p < pixels_.size(); ++p)
        if (turns_[p].exemplar >= 0) out[static_cast<std::size_t>(turns_[p].exemplar)].push_back(p);
    return out;
}

double ExemplarSearch::mean_error() const {
    double sum = 0.0;
    for (const PointFit& fit : fits_) sum += std::min(static_cast<double>(fit.error), 1.0);
    return sum / std::max<double>(1.0, static_cast<double>(fits_.size()));
}

// Every point at its best exemplar and turn; then every exemplar from its points.
void ExemplarSearch::solve_round(double eta, bool search) {
    eta_ = eta;
    const std::size_t count = pixels_.size();
    if (search) {
        RotationMatcher matcher(context_.grid);
        matcher.set_exemplars(exemplars_.tables());
        candidates_ = best_turns(matcher, partial(), kTrainingCandidates);
        for (std::size_t p = 0; p < count; ++p)
            if (turns_[p].exemplar >= 0) candidates_[p].push_back(turns_[p]);
    }
    fits_.assign(count, {});
    trials_.assign(count, {});
    signatures_.assign(count * static_cast<std::size_t>(kSignature.cells()), 0.0f);
    parallel_for(count, 32, [&](std::size_t begin, std::size_t end) {
        progress_.throw_if_cancelled();
        PixelWork work;
        for (std::size_t p = begin; p < end; ++p) fit_point(p, work);
    });
    solve_tables();
    if (settings_.normals) centre_exemplars();
}

// The best of a point's candidates; what it leaves is signed.
void ExemplarSearch::fit_point(std::size_t p, PixelWork& work) {
    const auto eta = static_cast<float>(eta_);
    context_.gather(pixels_[p], normals_[p], values_of(p), work);
    PointFit best;
    best.error = 2.0f;  // more than any fit has
    {
        const PointFitter fitter(work.samples, eta);
        for (const PointTurn& turn : candidates_[p]) {
            const PointFit fit =
                fitter.refined(tables_of(turn.exemplar), turn.shift, kSearchColumns);
            trials_[p].push_back(fit);
            if (fit.error >= best.error) continue;
            best = fit;
            turns_[p] = {turn.exemplar, fit.shift, turn.residual};
        }
    }
    if (best.error >= 2.0f) {
        turns_[p].exemplar = -1;
        return;
    }
    const ExemplarTables own = tables_of(turns_[p].exemplar);
    if (settings_.normals) {
        normals_[p] =
            refined_normal(context_, pixels_[p], values_of(p), eta, own, normals_[p], work, best);
        turns_[p].shift = best.shift;
    }
    fits_[p] = best;
    residual_signature(own, work.samples, PointFitter(work.samples, eta), best,
                       signatures_.data() + p * static_cast<std::size_t>(kSignature.cells()));
    for (PointTurn& turn : candidates_[p])
        if (turn.exemplar == turns_[p].exemplar) turn.shift = best.shift;
}

// Every exemplar from the points that have it.
void ExemplarSearch::solve_tables() {
    const auto eta = static_cast<float>(eta_);
    const std::vector<std::vector<std::size_t>> members = this->members();
    parallel_for(members.size(), 1, [&](std::size_t e, std::size_t) {
        TableEquations equations(context_.grid);
        const ExemplarTables tables = tables_of(static_cast<int>(e));
        PixelWork work;
        for (const std::size_t p : members[e]) {
            progress_.throw_if_cancelled();
            context_.gather(pixels_[p], normals_[p], values_of(p), work);
            equations.add(work.samples, PointFitter(work.samples, eta), tables, fits_[p]);
        }
        float* table = exemplars_.table(static_cast<int>(e));
        equations.solve(table, exemplars_.weight(static_cast<int>(e)));
        const std::vector<float> mimic = equations.diffuse_mimic();
        SlideAlong slide;
        for (std::size_t k = 0; k < members[e].size(); k += 1 + members[e].size() / kSlidePoints) {
            const std::size_t p = members[e][k];
            context_.gather(pixels_[p], normals_[p], values_of(p), work);
            slide.add(work.samples, PointFitter(work.samples, eta), tables, mimic.data(), fits_[p]);
        }
        for (std::size_t i = 0; i < mimic.size(); ++i)
            table[i] = std::max(table[i] + slide.distance() * mimic[i], 0.0f);
    });
    completion_ = complete_exemplars(exemplars_);
}

// A tilt of all its points' normals and a lean of an exemplar the other way show the same: what
// leans is the normals.
void ExemplarSearch::centre_exemplars() {
    const std::vector<std::vector<std::size_t>> members = this->members();
    for (int e = 0; e < exemplars_.count; ++e) {
        const std::array<float, 2> slope = peak_slope(context_.grid, exemplars_.table(e),
                                                      exemplars_.weight(e), kLeastExemplarBend);
        for (const std::size_t p : members[static_cast<std::size_t>(e)]) {
            const float turn = turns_[p].shift * 2.0f * std::numbers::pi_v<float> /
                               static_cast<float>(context_.grid.azimuths);
            const float c = std::cos(turn), s = std::sin(turn);
            normals_[p] = tilted_normal(normals_[p],
                                        {c * slope[0] - s * slope[1], s * slope[0] + c * slope[1]});
        }
    }
    solve_tables();
}

// Exemplars whose members fall into well and badly explained ones give the latter an exemplar of
// their own, at first the same: the next round takes them apart. Those without members go.
void ExemplarSearch::split_exemplars() {
    const auto cells = static_cast<std::ptrdiff_t>(context_.grid.cells());
    std::vector<std::vector<std::size_t>> members = this->members();
    Exemplars next;
    next.grid = exemplars_.grid;
    const auto append = [&](int e) {
        next.D.insert(next.D.end(), exemplars_.table(e), exemplars_.table(e) + cells);
        next.weights.insert(next.weights.end(), exemplars_.weight(e), exemplars_.weight(e) + cells);
        next.areas.insert(next.areas.end(), exemplars_.area(e),
                          exemplars_.area(e) + kAreaGrid.cells());
        return next.count++;
    };
    const auto largest = static_cast<int>(
        std::max_element(members.begin(), members.end(),
                         [](const auto& a, const auto& b) { return a.size() < b.size(); }) -
        members.begin());
    int room = settings_.exemplars -
               static_cast<int>(std::count_if(members.begin(), members.end(), [](const auto& some) {
                   return some.size() >= kFewestMembers;
               }));
    for (int e = 0; e < exemplars_.count; ++e) {
        std::vector<std::size_t>& own = members[static_cast<std::size_t>(e)];
        if (own.size() < kFewestMembers && e != largest) {
            for (const std::size_t p : own) turns_[p].exemplar = -1;
            continue;
        }
        std::stable_sort(own.begin(), own.end(), [&](std::size_t a, std::size_t b) {
            return fits_[a].error < fits_[b].error;
        });
        const std::size_t half = own.size() / 2;
        const auto mean = [&](std::size_t begin, std::size_t end) {
            double sum = 0.0;
            for (std::size_t k = begin; k < end; ++k)
                sum += static_cast<double>(fits_[own[k]].error);
            return sum / static_cast<double>(end - begin);
        };
        const int kept = append(e);
        std::vector<float> side;
        const bool uneven = mean(half, own.size()) > kSplitRatio * mean(0, half);
        const bool varied = main_variation(signatures_, own, side) > kSplitVariation;
        const bool splits = own.size() >= 4 * kFewestMembers && room > 0 && (uneven || varied);
        const int fresh = splits ? append(e) : kept;
        room -= splits ? 1 : 0;
        for (std::size_t k = 0; k < own.size(); ++k)
            turns_[own[k]].exemplar = (varied ? side[k] < 0.0f : k < half) ? kept : fresh;
    }
    next.origin.assign(next.D.size(), NdfOrigin::extrapolated);
    exemplars_ = std::move(next);
    candidates_.clear();  // they name exemplars that were
    // The two halves' own samples decide what they become.
    solve_tables();
}

// Exemplars whose members others explain about as well give them up: what is left has more points,
// and more turns, each. The smallest are asked first.
void ExemplarSearch::merge_exemplars() {
    std::vector<std::vector<std::size_t>> members = this->members();
    std::vector<int> order(members.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return members[static_cast<std::size_t>(a)].size() <
               members[static_cast<std::size_t>(b)].size();
    });
    std::vector<bool> alive(members.size(), true);
    for (const int e : order) {
        auto& own = members[static_cast<std::size_t>(e)];
        double now = 0.0, then = 0.0;
        std::vector<PointTurn> move(own.size());
        for (std::size_t k = 0; k < own.size(); ++k) {
            const std::size_t p = own[k];
            double best = 1.0;
            now += static_cast<double>(fits_[p].error);
            for (std::size_t c = 0; c < candidates_[p].size(); ++c) {
                const PointTurn& turn = candidates_[p][c];
                const auto error = static_cast<double>(trials_[p][c].error);
                if (turn.exemplar == e || !alive[static_cast<std::size_t>(turn.exemplar)] ||
                    error >= best)
                    continue;
                best = error;
                move[k] = {turn.exemplar, trials_[p][c].shift, turn.residual};
            }
            then += best;
        }
        // Few points overfit: generalised cross-validation (Craven & Wahba 1979) counts the cells.
        const double cells_known = static_cast<double>(
            std::count_if(exemplars_.weight(e), exemplars_.weight(e) + exemplars_.grid.cells(),
                          [](float w) { return w > 0.0f; }));
        const double samples = static_cast<double>(own.size() * context_.geometry->lights());
        const double freedom = 1.0 - std::min(0.9, cells_known / std::max(samples, 1.0));
        if (!own.empty() && then > kMergeRatio * now / (freedom * freedom)) continue;
        alive[static_cast<std::size_t>(e)] = false;
        for (std::size_t k = 0; k < own.size(); ++k) {
            turns_[own[k]] = move[k];
            if (move[k].exemplar >= 0)
                members[static_cast<std::size_t>(move[k].exemplar)].push_back(own[k]);
        }
        own.clear();
    }
    keep_exemplars(alive);
    solve_tables();
}

// Exemplars whose tables are alike become one: the smaller gives its points to the larger.
void ExemplarSearch::join_alike(float alike) {
    const auto count = static_cast<std::size_t>(exemplars_.count);
    std::vector<std::vector<RotationMatch>> between(count);
    RotationMatcher matcher(context_.grid);
    const MaskedTables tables = exemplars_.tables();
    matcher.set_exemplars(tables);
    matcher.match(tables, [&](std::size_t e, std::span<const RotationMatch> matches) {
        between[e].assign(matches.begin(), matches.end());
    });
    std::vector<std::size_t> members(count, 0);
    for (const PointTurn& turn : turns_)
        if (turn.exemplar >= 0) ++members[static_cast<std::size_t>(turn.exemplar)];
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return members[a] < members[b]; });
    std::vector<bool> alive(count, true);
    std::vector<PointTurn> to(count);  // where an exemplar's points go, and turned by how much more
    for (std::size_t k = 0; k < count; ++k) to[k] = {static_cast<int>(k), 0.0f, 0.0f};
    for (std::size_t place = 0; place < count; ++place) {
        const std::size_t e = order[place];
        std::size_t best = e;
        float least = alike;
        for (std::size_t later = place + 1; later < count; ++later) {
            const RotationMatch& match = between[e][order[later]];
            if (match.residual >= least) continue;
            least = match.residual;
            best = order[later];
        }
        if (best == e) continue;
        alive[e] = false;
        to[e] = {static_cast<int>(best), between[e][best].shift, 0.0f};
    }
    for (PointTurn& turn : turns_)
        while (turn.exemplar >= 0 && !alive[static_cast<std::size_t>(turn.exemplar)]) {
            const PointTurn& next = to[static_cast<std::size_t>(turn.exemplar)];
            turn.shift += next.shift;
            turn.exemplar = next.exemplar;
        }
    for (std::size_t p = 0; p < fits_.size(); ++p) fits_[p].shift = turns_[p].shift;
    keep_exemplars(alive);
    solve_tables();
}

void ExemplarSearch::keep_exemplars(std::vector<bool> alive) {
    if (std::none_of(alive.begin(), alive.end(), [](bool a) { return a; })) alive.front() = true;
    const auto cells = static_cast<std::ptrdiff_t>(context_.grid.cells());
    Exemplars next;
    next.grid = exemplars_.grid;
    std::vector<int> renamed(alive.size(), -1);
    for (int e = 0; e < exemplars_.count; ++e) {
        if (!alive[static_cast<std::size_t>(e)]) continue;
        renamed[static_cast<std::size_t>(e)] = next.count++;
        next.D.insert(next.D.end(), exemplars_.table(e), exemplars_.table(e) + cells);
        next.weights.insert(next.weights.end(), exemplars_.weight(e), exemplars_.weight(e) + cells);
        next.areas.insert(next.areas.end(), exemplars_.area(e),
                          exemplars_.area(e) + kAreaGrid.cells());
    }
    next.origin.assign(next.D.size(), NdfOrigin::extrapolated);
    for (PointTurn& turn : turns_)
        if (turn.exemplar >= 0) turn.exemplar = renamed[static_cast<std::size_t>(turn.exemplar)];
    exemplars_ = std::move(next);
    candidates_.clear();  // they name exemplars that were
}

// Where clustering starts from: what each point shows by itself.
void ExemplarSearch::solve_partial() {
    const std::size_t count = pixels_.size();
    const auto cells = static_cast<std::size_t>(context_.grid.cells());
    tables_.resize(count * cells);
    weights_.resize(count * cells);
    const PartialNdfSolver solver(context_.grid, context_.spacing_rad, static_cast<float>(eta_));
    progress_.step("partial distributions", 0.0);
    parallel_for(count, 32, [&](std::size_t begin, std::size_t end) {
        progress_.throw_if_cancelled();
        PixelWork work;
        PartialNdfWork partial;
        for (std::size_t p = begin; p < end; ++p) {
            float* table = tables_.data() + p * cells;
            float* weights = weights_.data() + p * cells;
            if (settings_.normals) {
                normals_[p] = peak_normal(context_, solver, pixels_[p], values_of(p), work, partial,
                                          table, weights);
                continue;
            }
            context_.gather(pixels_[p], normals_[p], values_of(p), work);
            solver.solve(work.samples, partial, table, weights);
        }
    });
}

void ExemplarSearch::run() {
    eta_ = settings_.eta.value_or(kFirstEta);
    solve_partial();
    const int wanted =
        std::clamp(settings_.exemplars, 1, std::max(1, static_cast<int>(pixels_.size() / 16)));
    exemplars_ = cluster_points(context_.grid, partial(),
                                {.exemplars = wanted, .seed = settings_.seed}, turns_, progress_);
    completion_ = complete_exemplars(exemplars_);
    const int rounds = settings_.normals ? kTiltedRounds : kSolveRounds;
    for (int round = 0; round < rounds; ++round) {
        progress_.step("solving exemplars", static_cast<double>(round) / rounds);
        solve_round(eta_, true);
        if (round == 0 || round == kSplitRounds) {
            join_alike(round == 0 ? kAlikeAtFirst : kAlike);
        } else if (round < kSplitRounds) {
            split_exemplars();
        } else if (round + 1 < rounds) {
            merge_exemplars();
        }
    }
    if (!settings_.eta) {
        const double eta = estimate_eta();
        for (int round = 0; round < 2; ++round) solve_round(eta, false);
    }
}

// Golden section over F(1) = ((eta-1)/(eta+1))^2 on a scale where steps of F's shape are even. Each
// trial solves the exemplars anew for two rounds: F and D are told apart only by points that see
// one facet at different angles (docs/capture.md).
double ExemplarSearch::estimate_eta() {
    const Exemplars start = exemplars_;
    const std::vector<PointTurn> turns = turns_;
    const std::vector<std::vector<PointTurn>> candidates = candidates_;
    const auto reset = [&] {
        exemplars_ = start;
        turns_ = turns;
        candidates_ = candidates;
    };
    const auto cost = [&](double eta) {
        reset();
        for (int round = 0; round < 3; ++round) solve_round(eta, false);
        return mean_error();
    };
    const auto eta_of = [](double root) {
        return (1.0 + root) / (1.0 - root);
    };  // root = sqrt(F(1))
    constexpr double kGolden = 0.6180339887498949;
    double low = 0.09, high = 0.6;  // eta 1.2 to 4
    double a = high - kGolden * (high - low), b = low + kGolden * (high - low);
    double at_a = cost(eta_of(a)), at_b = cost(eta_of(b));
    constexpr int kTrials = 7;
    for (int k = 0; k < kTrials; ++k) {
        progress_.step("index of refraction", static_cast<double>(k) / kTrials);
        if (at_a < at_b) {
            high = b;
            b = a;
            at_b = at_a;
            a = high - kGolden * (high - low);
            at_a = cost(eta_of(a));
        } else {
            low = a;
            a = b;
            at_a = at_b;
            b = low + kGolden * (high - low);
            at_b = cost(eta_of(b));
        }
    }
    reset();
    return eta_of(0.5 * (low + high));
}

}  // namespace burnish
