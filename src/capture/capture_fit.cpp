#include "capture/capture_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "burnish/error.hpp"
#include "capture/coverage.hpp"
#include "capture/partial_ndf.hpp"
#include "capture/stage_file.hpp"
#include "core/parallel.hpp"

namespace burnish {

namespace {

// Bytes of training samples in memory at most.
constexpr std::size_t kTrainingBytes = std::size_t{256} << 20;
constexpr int kSolveRounds = 10, kSplitRounds = 4;
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
constexpr std::size_t kCandidates = 3, kTrainingCandidates = 6;
// Columns to each side in which a candidate's turn is searched.
constexpr float kSearchColumns = 1.5f;
// Points of an exemplar that its slide along the diffuse direction is worked out from.
constexpr std::size_t kSlidePoints = 256;
constexpr std::size_t kPixelTile = 64;
constexpr double kFirstEta = 1.5;

// What a point's samples leave unexplained, in the exemplar's frame and in units of what its
// samples decide there, so that noise is about as large in every cell.
constexpr NdfGrid kSignature = {8, 24};
void sign_residual(const ExemplarTables& tables, const PointSamples& samples,
                   const PointFitter& fitter, const PointFit& fit, float* out) {
    const auto cells = static_cast<std::size_t>(kSignature.cells());
    std::vector<float> sum(cells, 0.0f), total(cells, 0.0f);
    const float area_out =
        area_at(tables.areas, samples.out, samples.to_eye[2], area_shift(tables.grid, fit.shift));
    const auto columns = static_cast<float>(tables.grid.azimuths);
    for (std::size_t q = 0; q < samples.size(); ++q) {
        const float b =
            specular_shape(tables, samples, q, fit.shift, fitter.fresnel()[q], area_out);
        const float model =
            samples.received[q] * (fit.diffuse * std::numbers::inv_pi_v<float> + fit.specular * b);
        const float d = std::max(lookup(tables.grid, tables.D, samples.half[q], fit.shift), 1e-6f);
        const float slope = samples.received[q] * fit.specular * b / d;  // of the model by D
        const int ring = samples.half[q].ring * kSignature.rings / tables.grid.rings;
        float turns = (samples.half[q].column - fit.shift) / columns;
        turns -= std::floor(turns);
        const int column =
            static_cast<int>(turns * static_cast<float>(kSignature.azimuths)) % kSignature.azimuths;
        const auto to = static_cast<std::size_t>(ring * kSignature.azimuths + column);
        sum[to] += fitter.weights()[q] * slope * (samples.value[q] - model);
        total[to] += fitter.weights()[q] * slope * slope;
    }
    for (std::size_t i = 0; i < cells; ++i)
        out[i] = total[i] > 0.0f ? sum[i] / std::sqrt(total[i]) : 0.0f;
}

// The direction in which the members' signatures vary most (power iteration), and its share of all
// their variance; `side` receives each member's place along it.
double main_variation(const std::vector<float>& signatures, const std::vector<std::size_t>& members,
                      std::vector<float>& side) {
    const auto cells = static_cast<std::size_t>(kSignature.cells());
    std::vector<double> mean(cells, 0.0), axis(cells), next(cells);
    for (const std::size_t p : members)
        for (std::size_t i = 0; i < cells; ++i)
            mean[i] += static_cast<double>(signatures[p * cells + i]) /
                       static_cast<double>(members.size());
    double variance = 0.0;
    for (const std::size_t p : members)
        for (std::size_t i = 0; i < cells; ++i)
            variance += std::pow(static_cast<double>(signatures[p * cells + i]) - mean[i], 2);
    for (std::size_t i = 0; i < cells; ++i) axis[i] = 1.0 + static_cast<double>(i % 7);
    double along = 0.0;
    side.resize(members.size());
    constexpr int kPowers = 20;
    for (int power = 0; power < kPowers; ++power) {
        const double length =
            std::sqrt(std::inner_product(axis.begin(), axis.end(), axis.begin(), 0.0));
        if (!(length > 0.0)) return 0.0;
        for (double& a : axis) a /= length;
        std::fill(next.begin(), next.end(), 0.0);
        along = 0.0;
        for (std::size_t k = 0; k < members.size(); ++k) {
            const float* s = signatures.data() + members[k] * cells;
            double place = 0.0;
            for (std::size_t i = 0; i < cells; ++i)
                place += (static_cast<double>(s[i]) - mean[i]) * axis[i];
            side[k] = static_cast<float>(place);
            along += place * place;
            for (std::size_t i = 0; i < cells; ++i)
                next[i] += place * (static_cast<double>(s[i]) - mean[i]);
        }
        axis = next;
    }
    return variance > 0.0 ? along / variance : 0.0;
}

}  // namespace

std::vector<std::uint8_t> fitted_lights(std::size_t lights, int hold_out) {
    std::vector<std::uint8_t> keep(lights, 1);
    if (hold_out < 2) return keep;
    const auto n = static_cast<std::size_t>(hold_out);
    for (std::size_t k = n / 2; k < lights; k += n) keep[k] = 0;
    return keep;
}

struct CaptureFit::Training {
    std::vector<std::size_t> pixels;
    std::vector<float> values;  // pixels x lights x 3
    std::vector<float> tables, weights;
    std::vector<PointTurn> turns;
    std::vector<std::vector<PointTurn>> candidates;
    std::vector<PointFit> fits;
    std::vector<std::vector<PointFit>> trials;  // of each candidate
    double eta = 0.0;                           // that fits were made with
    std::vector<float> signatures;  // pixels x kSignature.cells(): what is left of each point

    MaskedTables masked() const { return {tables, weights, pixels.size()}; }
};

struct CaptureFit::Texels {
    std::vector<std::uint16_t> exemplar;
    std::vector<float> angle, error;
    std::vector<float> diffuse, specular, normal;  // x 3
};

CaptureFit::CaptureFit(const Rig& rig, const CaptureFitSettings& settings,
                       const std::filesystem::path& stages, const Progress& progress)
    : rig_(rig), settings_(settings), stages_(stages), progress_(progress) {
    std::error_code error;
    std::filesystem::create_directories(stages, error);
    if (error) throw Error(stages.string(), "", "a folder that can be made", error.message());
    stack_ = std::make_unique<ImageStack>(rig, stages / "pictures.bin", progress);
    if (rig_.width_mm > 0.0 && rig_.height_mm <= 0.0)
        rig_.height_mm = rig_.width_mm * stack_->height() / stack_->width();
    geometry_ = std::make_unique<LightGeometry>(rig_, stack_->width(), stack_->height());
    keep_ = fitted_lights(stack_->lights(), settings.hold_out);
    report_.census = stack_->census();
    report_.spacing_deg = point_coverage(rig_, {0.0, 0.0, 0.0}).spacing;
}

CaptureFit::~CaptureFit() = default;

std::uint64_t CaptureFit::identity() const {
    Identity id;
    id.add(stack_->identity());
    id.add(settings_.grid.rings);
    id.add(settings_.grid.azimuths);
    id.add(settings_.exemplars);
    id.add(settings_.eta.value_or(-1.0));
    id.add(settings_.seed);
    id.add(settings_.hold_out);
    id.add(settings_.training_points);
    id.add(settings_.normals);
    return id.value();
}

// Points spread evenly over what is to be fitted.
CaptureFit::Training CaptureFit::gather_training() const {
    Training training;
    std::vector<std::size_t> all;
    for (std::size_t p = 0; p < stack_->pixels(); ++p)
        if (stack_->mask()[p]) all.push_back(p);
    const std::size_t lights = stack_->lights();
    const std::size_t most =
        std::min({static_cast<std::size_t>(settings_.training_points), all.size(),
                  std::max<std::size_t>(kTrainingBytes / (12 * lights), 16)});
    // Steps of an irrational share do not fall in with rows.
    std::vector<std::size_t> chosen(most);
    for (std::size_t k = 0; k < most; ++k) {
        const double jitter = std::fmod(static_cast<double>(k) * std::numbers::phi, 1.0);
        chosen[k] = all[std::min(
            all.size() - 1,
            static_cast<std::size_t>((static_cast<double>(k) + jitter) *
                                     static_cast<double>(all.size()) / static_cast<double>(most)))];
    }
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    training.pixels = chosen;
    training.values.resize(chosen.size() * lights * 3);
    std::size_t next = 0;
    for (std::size_t b = 0; b < stack_->bands() && next < chosen.size(); ++b) {
        progress_.step("training points",
                       static_cast<double>(b) / static_cast<double>(stack_->bands()));
        const std::size_t end = std::min((b + 1) * stack_->band_pixels(), stack_->pixels());
        if (chosen[next] >= end) continue;
        const StackBand band = stack_->load(b);
        for (; next < chosen.size() && chosen[next] < end; ++next)
            stack_->decode(band, chosen[next] - band.first, 1,
                           training.values.data() + next * lights * 3);
    }
    return training;
}

// What one worker needs for one pixel after another.
struct CaptureFit::PixelWork {
    PointLights lights;
    PointSamples samples;

    void gather(const CaptureFit& fit, std::size_t pixel, const float* values) {
        fit.geometry_->at(pixel, lights);
        gather_samples(lights, {0.0f, 0.0f, 1.0f}, {values, 3 * fit.stack_->lights()}, fit.keep_,
                       fit.settings_.grid, samples);
    }
};

// Every training point at its best exemplar and turn; then every exemplar from its points.
void CaptureFit::solve_round(Training& training, double eta, bool search) {
    training.eta = eta;
    const std::size_t count = training.pixels.size(), per_point = 3 * stack_->lights();
    const auto eta_f = static_cast<float>(eta);
    if (search) {
        RotationMatcher matcher(settings_.grid);
        matcher.set_exemplars(exemplars_.tables());
        training.candidates = best_turns(matcher, training.masked(), kTrainingCandidates);
        for (std::size_t p = 0; p < count; ++p)
            if (training.turns[p].exemplar >= 0)
                training.candidates[p].push_back(training.turns[p]);
    }
    training.fits.assign(count, {});
    training.trials.assign(count, {});
    const auto signature = static_cast<std::size_t>(kSignature.cells());
    training.signatures.assign(count * signature, 0.0f);
    parallel_for(count, 32, [&](std::size_t begin, std::size_t end) {
        PixelWork work;
        for (std::size_t p = begin; p < end; ++p) {
            work.gather(*this, training.pixels[p], training.values.data() + p * per_point);
            const PointFitter fitter(work.samples, eta_f);
            PointFit best;
            best.error = 2.0f;
            for (const PointTurn& turn : training.candidates[p]) {
                const ExemplarTables tables = {settings_.grid, exemplars_.table(turn.exemplar),
                                               exemplars_.area(turn.exemplar)};
                const PointFit fit = fitter.refined(tables, turn.shift, kSearchColumns);
                training.trials[p].push_back(fit);
                if (fit.error < best.error) {
                    best = fit;
                    training.turns[p] = {turn.exemplar, fit.shift, turn.residual};
                }
            }
            training.fits[p] = best;
            const int own = training.turns[p].exemplar;
            if (best.error < 2.0f)
                sign_residual({settings_.grid, exemplars_.table(own), exemplars_.area(own)},
                              work.samples, fitter, best,
                              training.signatures.data() + p * signature);
            if (best.error < 2.0f)
                for (PointTurn& turn : training.candidates[p])
                    if (turn.exemplar == training.turns[p].exemplar) turn.shift = best.shift;
        }
    });
    solve_tables(training);
}

// Every exemplar from the points that have it.
void CaptureFit::solve_tables(const Training& training) {
    const std::size_t count = training.pixels.size(), per_point = 3 * stack_->lights();
    const auto eta_f = static_cast<float>(training.eta);
    std::vector<std::vector<std::size_t>> members(static_cast<std::size_t>(exemplars_.count));
    for (std::size_t p = 0; p < count; ++p)
        if (training.turns[p].exemplar >= 0)
            members[static_cast<std::size_t>(training.turns[p].exemplar)].push_back(p);
    parallel_for(members.size(), 1, [&](std::size_t e, std::size_t) {
        TableEquations equations(settings_.grid);
        const ExemplarTables tables = {settings_.grid, exemplars_.table(static_cast<int>(e)),
                                       exemplars_.area(static_cast<int>(e))};
        PixelWork work;
        for (const std::size_t p : members[e]) {
            work.gather(*this, training.pixels[p], training.values.data() + p * per_point);
            equations.add(work.samples, PointFitter(work.samples, eta_f), tables, training.fits[p]);
        }
        float* table = exemplars_.table(static_cast<int>(e));
        equations.solve(table, exemplars_.weight(static_cast<int>(e)));
        const std::vector<float> mimic = equations.diffuse_mimic();
        SlideAlong slide;
        for (std::size_t k = 0; k < members[e].size(); k += 1 + members[e].size() / kSlidePoints) {
            const std::size_t p = members[e][k];
            work.gather(*this, training.pixels[p], training.values.data() + p * per_point);
            slide.add(work.samples, PointFitter(work.samples, eta_f), tables, mimic.data(),
                      training.fits[p]);
        }
        for (std::size_t i = 0; i < mimic.size(); ++i)
            table[i] = std::max(table[i] + slide.distance() * mimic[i], 0.0f);
    });
    report_.completion = complete_exemplars(exemplars_);
}

namespace {

double mean_error(const std::vector<PointFit>& fits) {
    double sum = 0.0;
    for (const PointFit& fit : fits) sum += std::min(static_cast<double>(fit.error), 1.0);
    return sum / std::max<double>(1.0, static_cast<double>(fits.size()));
}

}  // namespace

// Exemplars whose members fall into well and badly explained ones give the latter an exemplar of
// their own, at first the same: the next round takes them apart. Those without members go.
void CaptureFit::split_exemplars(Training& training) {
    const auto cells = static_cast<std::ptrdiff_t>(settings_.grid.cells());
    std::vector<std::vector<std::size_t>> members(static_cast<std::size_t>(exemplars_.count));
    for (std::size_t p = 0; p < training.pixels.size(); ++p)
        if (training.turns[p].exemplar >= 0)
            members[static_cast<std::size_t>(training.turns[p].exemplar)].push_back(p);
    Exemplars next;
    next.grid = exemplars_.grid;
    const auto append = [&](int e) {
        next.D.insert(next.D.end(), exemplars_.table(e), exemplars_.table(e) + cells);
        next.weights.insert(next.weights.end(), exemplars_.weight(e), exemplars_.weight(e) + cells);
        next.areas.insert(next.areas.end(), exemplars_.area(e),
                          exemplars_.area(e) + kAreaGrid.cells());
        return next.count++;
    };
    int room = settings_.exemplars -
               static_cast<int>(std::count_if(members.begin(), members.end(), [](const auto& some) {
                   return some.size() >= kFewestMembers;
               }));
    for (int e = 0; e < exemplars_.count; ++e) {
        std::vector<std::size_t>& own = members[static_cast<std::size_t>(e)];
        if (own.size() < kFewestMembers) {
            for (const std::size_t p : own) training.turns[p].exemplar = -1;
            continue;
        }
        std::stable_sort(own.begin(), own.end(), [&](std::size_t a, std::size_t b) {
            return training.fits[a].error < training.fits[b].error;
        });
        const std::size_t half = own.size() / 2;
        const auto mean = [&](std::size_t begin, std::size_t end) {
            double sum = 0.0;
            for (std::size_t k = begin; k < end; ++k)
                sum += static_cast<double>(training.fits[own[k]].error);
            return sum / static_cast<double>(end - begin);
        };
        const int kept = append(e);
        std::vector<float> side;
        const bool uneven = mean(half, own.size()) > kSplitRatio * mean(0, half);
        const bool varied = main_variation(training.signatures, own, side) > kSplitVariation;
        const bool splits = own.size() >= 4 * kFewestMembers && room > 0 && (uneven || varied);
        const int fresh = splits ? append(e) : kept;
        room -= splits ? 1 : 0;
        for (std::size_t k = 0; k < own.size(); ++k)
            training.turns[own[k]].exemplar = (varied ? side[k] < 0.0f : k < half) ? kept : fresh;
    }
    next.origin.assign(next.D.size(), NdfOrigin::extrapolated);
    exemplars_ = std::move(next);
    // The two halves' own samples decide what they become.
    solve_tables(training);
}

// Exemplars whose members others explain about as well give them up: what is left has more points,
// and more turns, each. The smallest are asked first.
void CaptureFit::merge_exemplars(Training& training) {
    const std::size_t count = training.pixels.size();
    std::vector<std::vector<std::size_t>> members(static_cast<std::size_t>(exemplars_.count));
    for (std::size_t p = 0; p < count; ++p)
        if (training.turns[p].exemplar >= 0)
            members[static_cast<std::size_t>(training.turns[p].exemplar)].push_back(p);
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
            now += static_cast<double>(training.fits[p].error);
            for (std::size_t c = 0; c < training.candidates[p].size(); ++c) {
                const PointTurn& turn = training.candidates[p][c];
                const auto error = static_cast<double>(training.trials[p][c].error);
                if (turn.exemplar == e || !alive[static_cast<std::size_t>(turn.exemplar)] ||
                    error >= best)
                    continue;
                best = error;
                move[k] = {turn.exemplar, training.trials[p][c].shift, turn.residual};
            }
            then += best;
        }
        // Few points overfit: generalised cross-validation (Craven & Wahba 1979) counts the cells.
        const double cells_known = static_cast<double>(
            std::count_if(exemplars_.weight(e), exemplars_.weight(e) + exemplars_.grid.cells(),
                          [](float w) { return w > 0.0f; }));
        const double samples = static_cast<double>(own.size() * stack_->lights());
        const double freedom = 1.0 - std::min(0.9, cells_known / std::max(samples, 1.0));
        if (!own.empty() && then > kMergeRatio * now / (freedom * freedom)) continue;
        alive[static_cast<std::size_t>(e)] = false;
        for (std::size_t k = 0; k < own.size(); ++k) {
            training.turns[own[k]] = move[k];
            if (move[k].exemplar >= 0)
                members[static_cast<std::size_t>(move[k].exemplar)].push_back(own[k]);
        }
        own.clear();
    }
    keep_exemplars(training, alive);
    solve_tables(training);
}

// Exemplars whose tables are alike become one: the smaller gives its points to the larger.
void CaptureFit::join_alike(Training& training, float alike) {
    const auto count = static_cast<std::size_t>(exemplars_.count);
    std::vector<std::vector<RotationMatch>> between(count);
    RotationMatcher matcher(settings_.grid);
    const MaskedTables tables = exemplars_.tables();
    matcher.set_exemplars(tables);
    matcher.match(tables, [&](std::size_t e, std::span<const RotationMatch> matches) {
        between[e].assign(matches.begin(), matches.end());
    });
    std::vector<std::size_t> members(count, 0);
    for (const PointTurn& turn : training.turns)
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
    for (PointTurn& turn : training.turns)
        while (turn.exemplar >= 0 && !alive[static_cast<std::size_t>(turn.exemplar)]) {
            const PointTurn& next = to[static_cast<std::size_t>(turn.exemplar)];
            turn.shift += next.shift;
            turn.exemplar = next.exemplar;
        }
    for (std::size_t p = 0; p < training.fits.size(); ++p)
        training.fits[p].shift = training.turns[p].shift;
    keep_exemplars(training, alive);
    solve_tables(training);
}

void CaptureFit::keep_exemplars(Training& training, const std::vector<bool>& alive) {
    const auto cells = static_cast<std::ptrdiff_t>(settings_.grid.cells());
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
    for (PointTurn& turn : training.turns)
        if (turn.exemplar >= 0) turn.exemplar = renamed[static_cast<std::size_t>(turn.exemplar)];
    exemplars_ = std::move(next);
}

void CaptureFit::find_exemplars() {
    if (load_exemplars()) return;
    Training training = gather_training();
    const std::size_t count = training.pixels.size();
    const auto cells = static_cast<std::size_t>(settings_.grid.cells());
    training.tables.resize(count * cells);
    training.weights.resize(count * cells);
    const double first_eta = settings_.eta.value_or(kFirstEta);
    const PartialNdfSolver solver(
        settings_.grid, static_cast<float>(report_.spacing_deg * std::numbers::pi / 180.0),
        static_cast<float>(first_eta));
    progress_.step("partial distributions", 0.0);
    parallel_for(count, 32, [&](std::size_t begin, std::size_t end) {
        PixelWork work;
        for (std::size_t p = begin; p < end; ++p) {
            work.gather(*this, training.pixels[p],
                        training.values.data() + p * 3 * stack_->lights());
            solver.solve(work.samples, training.tables.data() + p * cells,
                         training.weights.data() + p * cells);
        }
    });
    const int wanted =
        std::clamp(settings_.exemplars, 1, std::max(1, static_cast<int>(count / 16)));
    exemplars_ =
        cluster_points(settings_.grid, training.masked(),
                       {.exemplars = wanted, .seed = settings_.seed}, training.turns, progress_);
    report_.completion = complete_exemplars(exemplars_);
    double eta = first_eta;
    for (int round = 0; round < kSolveRounds; ++round) {
        progress_.step("solving exemplars", static_cast<double>(round) / kSolveRounds);
        solve_round(training, eta, round + 1 < kSolveRounds);
        if (round == 0 || round == kSplitRounds) {
            join_alike(training, round == 0 ? kAlikeAtFirst : kAlike);
        } else if (round < kSplitRounds) {
            split_exemplars(training);
        } else if (round + 1 < kSolveRounds) {
            merge_exemplars(training);
        }
    }
    if (!settings_.eta) {
        eta = estimate_eta(training);
        for (int round = 0; round < 2; ++round) solve_round(training, eta, false);
    }
    report_.training_points = static_cast<int>(count);
    report_.exemplars = exemplars_.count;
    report_.eta = eta;
    report_.eta_estimated = !settings_.eta;
    report_.training_error = std::sqrt(mean_error(training.fits));
    save_exemplars();
}

// Golden section over F(1) = ((eta-1)/(eta+1))^2 on a scale where steps of F's shape are even. Each
// trial solves the exemplars anew for two rounds: F and D are told apart only by points that see
// one facet at different angles (docs/capture.md).
double CaptureFit::estimate_eta(Training& training) {
    const Exemplars start = exemplars_;
    const Training before = training;
    const auto cost = [&](double eta) {
        exemplars_ = start;
        training.turns = before.turns;
        training.candidates = before.candidates;
        for (int round = 0; round < 3; ++round) solve_round(training, eta, false);
        return mean_error(training.fits);
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
    exemplars_ = start;
    training.turns = before.turns;
    training.candidates = before.candidates;
    return eta_of(0.5 * (low + high));
}

void CaptureFit::fit_band(const StackBand& band, Texels& texels) const {
    const auto cells = static_cast<std::size_t>(settings_.grid.cells());
    const std::size_t per_point = 3 * stack_->lights();
    RotationMatcher matcher(settings_.grid);
    matcher.set_exemplars(exemplars_.tables());
    const auto eta = static_cast<float>(report_.eta);
    const PartialNdfSolver solver(
        settings_.grid, static_cast<float>(report_.spacing_deg * std::numbers::pi / 180.0), eta);
    const float radians =
        2.0f * std::numbers::pi_v<float> / static_cast<float>(settings_.grid.azimuths);
    parallel_for(band.pixels, kPixelTile, [&](std::size_t begin, std::size_t end) {
        const std::size_t count = end - begin;
        std::vector<float> values(count * per_point), tables(count * cells), weights(count * cells);
        stack_->decode(band, begin, count, values.data());
        std::vector<PixelWork> work(count);
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t pixel = band.first + begin + k;
            if (!stack_->mask()[pixel]) continue;
            work[k].gather(*this, pixel, values.data() + k * per_point);
            solver.solve(work[k].samples, tables.data() + k * cells, weights.data() + k * cells);
        }
        const auto candidates = best_turns(matcher, {tables, weights, count}, kCandidates);
        for (std::size_t k = 0; k < count; ++k) {
            const std::size_t pixel = band.first + begin + k;
            if (!stack_->mask()[pixel]) continue;
            const PointFitter fitter(work[k].samples, eta);
            PointFit best;
            best.error = 2.0f;
            int exemplar = 0;
            for (const PointTurn& turn : candidates[k]) {
                const ExemplarTables candidate = {settings_.grid, exemplars_.table(turn.exemplar),
                                                  exemplars_.area(turn.exemplar)};
                const PointFit fit = fitter.refined(candidate, turn.shift, kSearchColumns);
                if (fit.error >= best.error) continue;
                best = fit;
                exemplar = turn.exemplar;
            }
            std::array<float, 3> diffuse{}, specular{};
            fitter.colours({settings_.grid, exemplars_.table(exemplar), exemplars_.area(exemplar)},
                           best.shift, diffuse, specular);
            texels.exemplar[pixel] = static_cast<std::uint16_t>(exemplar);
            texels.angle[pixel] = best.shift * radians;
            texels.error[pixel] = best.error;
            for (std::size_t c = 0; c < 3; ++c) {
                texels.diffuse[3 * pixel + c] = diffuse[c];
                texels.specular[3 * pixel + c] = specular[c];
            }
        }
    });
}

void CaptureFit::fit_texels() {
    const std::size_t pixels = stack_->pixels();
    texels_ = std::make_unique<Texels>();
    Texels& t = *texels_;
    t.exemplar.assign(pixels, TabulatedMaterial::kNoExemplar);
    t.angle.assign(pixels, 0.0f);
    t.error.assign(pixels, 0.0f);
    t.diffuse.assign(3 * pixels, 0.0f);
    t.specular.assign(3 * pixels, 0.0f);
    t.normal.assign(3 * pixels, 0.0f);
    for (std::size_t p = 0; p < pixels; ++p) t.normal[3 * p + 2] = 1.0f;
    for (std::size_t b = 0; b < stack_->bands(); ++b) {
        progress_.step("texels", static_cast<double>(b) / static_cast<double>(stack_->bands()));
        fit_band(stack_->load(b), t);
    }
}

TabulatedMaterial CaptureFit::material() const {
    TabulatedMaterial m;
    m.grid = settings_.grid;
    m.exemplars = exemplars_.count;
    m.D = exemplars_.D;
    m.origin = exemplars_.origin;
    m.groove.assign(static_cast<std::size_t>(exemplars_.count), 0.0f);
    m.eta = report_.eta;
    m.width = stack_->width();
    m.height = stack_->height();
    m.width_mm = rig_.width_mm;
    m.height_mm = rig_.height_mm;
    m.exemplar = texels_->exemplar;
    m.angle = texels_->angle;
    const auto image = [&](const std::vector<float>& values) {
        Image out(m.width, m.height, 3);
        out.pixels = values;
        return out;
    };
    m.diffuse = image(texels_->diffuse);
    m.specular = image(texels_->specular);
    m.normal = image(texels_->normal);
    m.maps["fit.error"] = texels_->error;
    return m;
}

void CaptureFit::save_exemplars() const {
    StageWriter writer(identity());
    writer.put(exemplars_.count);
    writer.put(exemplars_.D);
    writer.put(exemplars_.weights);
    writer.put(exemplars_.areas);
    writer.put(exemplars_.origin);
    writer.put(report_.completion);
    writer.put(report_.training_points);
    writer.put(report_.eta);
    writer.put(report_.eta_estimated);
    writer.put(report_.training_error);
    writer.write(stages_ / "exemplars.bin");
}

bool CaptureFit::load_exemplars() {
    StageReader reader(stages_ / "exemplars.bin", identity());
    Exemplars found;
    CaptureFitReport report = report_;
    found.grid = settings_.grid;
    reader.get(found.count);
    reader.get(found.D);
    reader.get(found.weights);
    reader.get(found.areas);
    reader.get(found.origin);
    reader.get(report.completion);
    reader.get(report.training_points);
    reader.get(report.eta);
    reader.get(report.eta_estimated);
    reader.get(report.training_error);
    const std::size_t cells = static_cast<std::size_t>(std::max(found.count, 0)) *
                              static_cast<std::size_t>(settings_.grid.cells());
    if (!reader.good() || found.count < 1 || found.D.size() != cells ||
        found.weights.size() != cells || found.origin.size() != cells)
        return false;
    report.exemplars = found.count;
    exemplars_ = std::move(found);
    report_ = report;
    return true;
}

}  // namespace burnish
