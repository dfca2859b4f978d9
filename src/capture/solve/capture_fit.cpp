#include "capture/solve/capture_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numbers>
#include <numeric>

#include "burnish/error.hpp"
#include "capture/model/parametric_fit.hpp"
#include "capture/rig/coverage.hpp"
#include "capture/solve/exemplar_search.hpp"
#include "capture/solve/partial_ndf.hpp"
#include "capture/solve/peak_normal.hpp"
#include "capture/stack/stage_file.hpp"
#include "core/parallel.hpp"
#include "core/work_pool.hpp"
#include "fit/lobe_fit.hpp"

namespace burnish {

namespace {

// Bytes of training samples in memory at most.
constexpr std::size_t kTrainingBytes = std::size_t{256} << 20;
// Training points where nobody says how many: the figures of docs/capture.md are from a tenth of
// these samples, and their cost is that of so many.
constexpr std::size_t kUsualPoints = 8192, kUsualSamples = 4000000;
constexpr std::size_t kCandidates = 3, kDoubtCandidates = 8;
// A texel whose error is so many times the training points' mean is tried at every turn, in steps
// of so many columns.
constexpr float kDoubt = 3.0f;
constexpr int kDoubtStep = 2;
// Exemplars are done: matched turns are within this of the best.
constexpr float kTexelColumns = 1.0f;
// Samples that tell candidates apart, by how much the best of all samples' turns may differ from
// theirs, and how near the best a candidate must come to be judged by all samples.
constexpr std::size_t kSearchLights = 320;
constexpr float kLastColumns = 0.25f;
constexpr float kClose = 1.5f;
// A candidate whose error is so many times the best one's after one step will not overtake it.
constexpr float kGiveUp = 4.0f;
// A texel's normal and turn are found in turns.
constexpr int kNormalPasses = 3;
constexpr std::size_t kPixelTile = 16;
// Raised when the same settings come to give other numbers: stages of before are not gone on with.
constexpr int kMethodVersion = 3;
// What an interruption of the texel stage costs at most, and a band.
constexpr std::chrono::seconds kSaveEvery{20};

}  // namespace

std::vector<std::uint8_t> fitted_lights(std::size_t lights, int hold_out) {
    std::vector<std::uint8_t> keep(lights, 1);
    if (hold_out < 2) return keep;
    const auto n = static_cast<std::size_t>(hold_out);
    for (std::size_t k = n / 2; k < lights; k += n) keep[k] = 0;
    return keep;
}

struct CaptureFit::Texels {
    std::vector<std::uint16_t> exemplar;
    std::vector<float> angle, error;
    std::vector<float> diffuse, specular, normal;  // x 3
    std::vector<float> models;  // x models x kModelNumbers; empty when none are wanted
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
    context_.geometry = geometry_.get();
    context_.keep = fitted_lights(stack_->lights(), settings.hold_out);
    context_.grid = settings.grid;
    report_.census = stack_->census();
    report_.spacing_deg = point_coverage(rig_, {0.0, 0.0, 0.0}).spacing;
    context_.spacing_rad = static_cast<float>(report_.spacing_deg * std::numbers::pi / 180.0);
}

CaptureFit::~CaptureFit() = default;

std::uint64_t CaptureFit::identity() const {
    Identity id;
    id.add(kMethodVersion);
    id.add(stack_->identity());
    id.add(settings_.grid.rings);
    id.add(settings_.grid.azimuths);
    id.add(settings_.exemplars);
    id.add(settings_.eta.value_or(-1.0));
    id.add(settings_.seed);
    id.add(settings_.hold_out);
    id.add(settings_.training_points);
    id.add(settings_.normals);
    id.add(settings_.models);
    return id.value();
}

// Spread evenly over what is to be fitted.
std::vector<std::size_t> CaptureFit::training_pixels() const {
    std::vector<std::size_t> all;
    for (std::size_t p = 0; p < stack_->pixels(); ++p)
        if (stack_->mask()[p]) all.push_back(p);
    const std::size_t fits = std::max<std::size_t>(kTrainingBytes / (12 * stack_->lights()), 16);
    const std::size_t wanted =
        settings_.training_points > 0
            ? static_cast<std::size_t>(settings_.training_points)
            : std::min(kUsualPoints, std::max<std::size_t>(kUsualSamples / stack_->lights(), 16));
    const std::size_t most = std::min({wanted, all.size(), fits});
    if (most == all.size()) return all;
    // Steps of an irrational share do not fall in with rows.
    std::vector<std::size_t> chosen(most);
    const double step = static_cast<double>(all.size()) / static_cast<double>(most);
    for (std::size_t k = 0; k < most; ++k) {
        const double jitter = std::fmod(static_cast<double>(k) * std::numbers::phi, 1.0);
        const auto at = static_cast<std::size_t>((static_cast<double>(k) + jitter) * step);
        chosen[k] = all[std::min(all.size() - 1, at)];
    }
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    return chosen;
}

std::vector<float> CaptureFit::training_values(const std::vector<std::size_t>& pixels) const {
    const std::size_t per_point = 3 * stack_->lights();
    std::vector<float> values(pixels.size() * per_point);
    std::size_t next = 0;
    for (std::size_t b = 0; b < stack_->bands() && next < pixels.size(); ++b) {
        progress_.step("training points",
                       static_cast<double>(b) / static_cast<double>(stack_->bands()));
        const std::size_t end = std::min((b + 1) * stack_->band_pixels(), stack_->pixels());
        if (pixels[next] >= end) continue;
        const StackBand band = stack_->load(b);
        for (; next < pixels.size() && pixels[next] < end; ++next)
            stack_->decode(band, pixels[next] - band.first, 1, values.data() + next * per_point);
    }
    return values;
}

void CaptureFit::find_exemplars() {
    if (load_exemplars()) return;
    const std::vector<std::size_t> pixels = training_pixels();
    const std::vector<float> values = training_values(pixels);
    ExemplarSearch search(context_, pixels, values,
                          {.exemplars = settings_.exemplars,
                           .eta = settings_.eta,
                           .seed = settings_.seed,
                           .normals = settings_.normals},
                          progress_);
    search.run();
    exemplars_ = search.exemplars();
    report_.completion = search.completion();
    report_.training_points = static_cast<int>(pixels.size());
    report_.exemplars = exemplars_.count;
    report_.eta = search.eta();
    report_.training_error = std::sqrt(search.mean_error());
    save_exemplars();
}

namespace {

// Of each model and texel, and their names in the material's maps.
constexpr std::array<const char*, 5> kModelNumbers = {"alpha_along", "alpha_across", "groove_deg",
                                                      "diffuse", "specular"};
// Lights that models are fitted to: enough for five numbers.
constexpr std::size_t kModelLights = 96;

float luminance(const std::array<float, 3>& rgb) {
    return kLuminance[0] * rgb[0] + kLuminance[1] * rgb[1] + kLuminance[2] * rgb[2];
}

}  // namespace

// What a worker holds for a tile of pixels.
struct CaptureFit::TileWork {
    std::vector<float> values, tables, weights;
    std::array<PixelWork, kPixelTile> pixels;
    std::array<Vec3f, kPixelTile> normals;  // that are searched from
    PartialNdfWork partial;
    PointSamples few;
};

// What the workers of the texel stage share.
struct CaptureFit::TexelTools {
    std::vector<LobeFit> lobes;  // of each exemplar: where models start from
    RotationMatcher matcher;
    PartialNdfSolver solver;
    float eta;
    float doubt;  // error from which a texel is looked at again
    WorkPool<TileWork> work;
};

// The exemplar and turn that explain a pixel's samples best; `exemplar` stays as it was where there
// is no candidate. Candidates are judged by few samples: what all of them say about a turn differs
// by less than the last search looks to each side.
PointFit CaptureFit::best_turn(const PointFitter& fitter, const PointSamples& few,
                               const std::vector<PointTurn>& candidates, const TexelTools& tools,
                               int& exemplar) const {
    const PointFitter quick(few, tools.eta);
    std::vector<PointTurn> judged;  // by their errors on the few, as residuals
    float least = 2.0f;             // more than any fit has
    const auto judge = [&](int e, float shift, float give_up) {
        const PointFit fit = quick.refined(tables_of(e), shift, kTexelColumns, give_up);
        judged.push_back({e, fit.shift, fit.error});
        least = std::min(least, fit.error);
    };
    PointFit best;
    const auto decide = [&] {
        best = {};
        best.error = 2.0f;
        for (const PointTurn& turn : judged) {
            if (turn.residual > kClose * least) continue;
            const PointFit fit = fitter.nearby(tables_of(turn.exemplar), turn.shift, kLastColumns);
            if (fit.error >= best.error) continue;
            best = fit;
            exemplar = turn.exemplar;
        }
    };
    for (std::size_t k = 0; k < std::min(candidates.size(), kCandidates); ++k)
        judge(candidates[k].exemplar, candidates[k].shift, kGiveUp * least);
    decide();
    // Far worse than points are wont to be: its part looked most like something else. Every turn of
    // every candidate is tried on the samples themselves.
    if (exemplar < 0 || best.error <= tools.doubt) return best;
    for (const PointTurn& turn : candidates) {
        PointFit lowest;
        lowest.error = 2.0f;
        for (int c = 0; c < settings_.grid.azimuths; c += kDoubtStep) {
            const PointFit fit = quick.at(tables_of(turn.exemplar), static_cast<float>(c));
            if (fit.error < lowest.error) lowest = fit;
        }
        judge(turn.exemplar, lowest.shift, 1e30f);
    }
    decide();
    return best;
}

// The best exemplar and turn of a pixel, the k-th of its tile, and its strengths in each channel.
void CaptureFit::fit_texel(std::size_t pixel, std::size_t k,
                           const std::vector<PointTurn>& candidates, const TexelTools& tools,
                           TileWork& tile, Texels& texels) const {
    const float* values = tile.values.data() + k * 3 * stack_->lights();
    PixelWork& work = tile.pixels[k];
    int exemplar = -1;
    PointFitter fitter(work.samples, tools.eta);
    thin_samples(work.samples, kSearchLights, tile.few);
    PointFit best = best_turn(fitter, tile.few, candidates, tools, exemplar);
    if (exemplar < 0) return;
    Vec3f normal = tile.normals[k];
    if (settings_.normals) {
        for (int pass = 0; pass < kNormalPasses; ++pass)
            normal = refined_normal(context_, pixel, values, tools.eta, tables_of(exemplar), normal,
                                    work, best);
        fitter = PointFitter(work.samples, tools.eta);  // they were gathered anew
    }
    std::array<float, 3> diffuse{}, specular{};
    fitter.colours(tables_of(exemplar), best.shift, diffuse, specular);
    texels.exemplar[pixel] = static_cast<std::uint16_t>(exemplar);
    texels.angle[pixel] =
        best.shift * 2.0f * std::numbers::pi_v<float> / static_cast<float>(settings_.grid.azimuths);
    texels.error[pixel] = best.error;
    if (!texels.models.empty()) {
        thin_samples(work.samples, kModelLights, tile.few);
        fit_models(pixel, exemplar, best.shift, tools, tile.few, texels);
    }
    for (std::size_t c = 0; c < 3; ++c) {
        texels.diffuse[3 * pixel + c] = diffuse[c];
        texels.specular[3 * pixel + c] = specular[c];
        texels.normal[3 * pixel + c] = normal[c];
    }
}

void CaptureFit::fit_models(std::size_t pixel, int exemplar, float shift, const TexelTools& tools,
                            const PointSamples& samples, Texels& texels) const {
    const LobeFit& lobe = tools.lobes[static_cast<std::size_t>(exemplar)];
    ParametricFit start;
    start.alpha_along = static_cast<float>(lobe.alpha_along);
    start.alpha_across = static_cast<float>(lobe.alpha_across);
    start.groove =
        static_cast<float>(lobe.groove) +
        shift * 2.0f * std::numbers::pi_v<float> / static_cast<float>(settings_.grid.azimuths);
    const std::size_t models = parametric_model_names().size();
    for (std::size_t m = 0; m < models; ++m) {
        const ParametricFit fit =
            fit_parametric(static_cast<ParametricModel>(m), samples, tools.eta, start, {false, 3});
        float* to = texels.models.data() + (pixel * models + m) * kModelNumbers.size();
        to[0] = fit.alpha_along;
        to[1] = fit.alpha_across;
        to[2] = fit.groove * 180.0f / std::numbers::pi_v<float>;
        to[3] = luminance(fit.diffuse);
        to[4] = luminance(fit.specular);
    }
}

void CaptureFit::fit_band(const StackBand& band, TexelTools& tools, Texels& texels) const {
    const auto cells = static_cast<std::size_t>(settings_.grid.cells());
    const std::size_t per_point = 3 * stack_->lights();
    parallel_for(band.pixels, kPixelTile, [&](std::size_t begin, std::size_t end) {
        progress_.throw_if_cancelled();
        const WorkPool<TileWork>::Lease lease(tools.work);
        TileWork& w = *lease;
        const std::size_t count = end - begin;
        w.values.resize(count * per_point);
        w.tables.resize(count * cells);
        w.weights.resize(count * cells);
        stack_->decode(band, begin, count, w.values.data());
        const auto pixel = [&](std::size_t k) { return band.first + begin + k; };
        for (std::size_t k = 0; k < count; ++k) {
            float* table = w.tables.data() + k * cells;
            float* known = w.weights.data() + k * cells;
            const float* values = w.values.data() + k * per_point;
            w.normals[k] = {0.0f, 0.0f, 1.0f};
            if (!stack_->mask()[pixel(k)]) {
                std::fill_n(known, cells, 0.0f);
            } else if (settings_.normals) {
                w.normals[k] = peak_normal(context_, tools.solver, pixel(k), values, w.pixels[k],
                                           w.partial, table, known);
            } else {
                context_.gather(pixel(k), w.normals[k], values, w.pixels[k]);
                tools.solver.solve(w.pixels[k].samples, w.partial, table, known);
            }
        }
        const auto candidates =
            best_turns(tools.matcher, {w.tables, w.weights, count}, kDoubtCandidates);
        for (std::size_t k = 0; k < count; ++k)
            if (stack_->mask()[pixel(k)]) fit_texel(pixel(k), k, candidates[k], tools, w, texels);
    });
}

double CaptureFit::unexplained() const {
    if (!texels_) return report_.training_error;
    double sum = 0.0, count = 0.0;
    for (std::size_t p = 0; p < stack_->pixels(); ++p) {
        if (texels_->exemplar[p] == TabulatedMaterial::kNoExemplar) continue;
        sum += static_cast<double>(texels_->error[p]);
        ++count;
    }
    return std::sqrt(sum / std::max(count, 1.0));
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
    const auto eta = static_cast<float>(report_.eta);
    if (settings_.models)
        t.models.assign(pixels * parametric_model_names().size() * kModelNumbers.size(), 0.0f);
    TexelTools tools = {
        lobes(),
        RotationMatcher(settings_.grid),
        PartialNdfSolver(settings_.grid, context_.spacing_rad, eta),
        eta,
        kDoubt * static_cast<float>(report_.training_error * report_.training_error),
        {}};
    tools.matcher.set_exemplars(exemplars_.tables());
    auto saved = std::chrono::steady_clock::now();
    for (std::size_t b = load_texels(); b < stack_->bands(); ++b) {
        progress_.step("texels", static_cast<double>(b) / static_cast<double>(stack_->bands()));
        fit_band(stack_->load(b), tools, t);
        const auto now = std::chrono::steady_clock::now();
        if (now - saved < kSaveEvery && b + 1 < stack_->bands()) continue;
        save_texels(b + 1);
        saved = now;
    }
}

std::vector<LobeFit> CaptureFit::lobes() const {
    std::vector<LobeFit> out;
    for (int e = 0; e < exemplars_.count; ++e)
        out.push_back(fit_lobe(settings_.grid, exemplars_.table(e), Mdf::ggx));
    return out;
}

TabulatedMaterial CaptureFit::material() const {
    TabulatedMaterial m;
    m.grid = settings_.grid;
    m.exemplars = exemplars_.count;
    m.D = exemplars_.D;
    m.origin = exemplars_.origin;
    for (const LobeFit& lobe : lobes()) m.groove.push_back(static_cast<float>(lobe.groove));
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
    if (texels_->models.empty()) return m;
    const auto names = parametric_model_names();
    const std::size_t numbers = names.size() * kModelNumbers.size();
    for (std::size_t k = 0; k < numbers; ++k) {
        std::vector<float>& map = m.maps[fmt::format("{}.{}", names[k / kModelNumbers.size()],
                                                     kModelNumbers[k % kModelNumbers.size()])];
        map.resize(m.texels());
        for (std::size_t t = 0; t < map.size(); ++t) map[t] = texels_->models[t * numbers + k];
    }
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

void CaptureFit::save_texels(std::size_t bands) const {
    StageWriter writer(texel_identity());
    writer.put(static_cast<std::uint64_t>(bands));
    writer.put(texels_->exemplar);
    writer.put(texels_->angle);
    writer.put(texels_->error);
    writer.put(texels_->diffuse);
    writer.put(texels_->specular);
    writer.put(texels_->normal);
    writer.put(texels_->models);
    writer.write(stages_ / "texels.bin");
}

// Bands that an earlier run has done.
std::size_t CaptureFit::load_texels() {
    StageReader reader(stages_ / "texels.bin", texel_identity());
    std::uint64_t bands = 0;
    Texels found;
    reader.get(bands);
    reader.get(found.exemplar);
    reader.get(found.angle);
    reader.get(found.error);
    reader.get(found.diffuse);
    reader.get(found.specular);
    reader.get(found.normal);
    reader.get(found.models);
    const std::size_t pixels = stack_->pixels();
    const bool whole = reader.good() && bands <= stack_->bands() &&
                       found.exemplar.size() == pixels && found.angle.size() == pixels &&
                       found.error.size() == pixels && found.diffuse.size() == 3 * pixels &&
                       found.specular.size() == 3 * pixels && found.normal.size() == 3 * pixels &&
                       found.models.size() == texels_->models.size();
    if (!whole) return 0;
    *texels_ = std::move(found);
    return bands;
}

// Texels depend on the exemplars that were found.
std::uint64_t CaptureFit::texel_identity() const {
    Identity id;
    id.add(identity());
    id.add_bytes(exemplars_.D.data(), exemplars_.D.size() * sizeof(float));
    return id.value();
}

}  // namespace burnish
