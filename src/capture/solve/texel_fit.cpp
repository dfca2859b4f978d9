#include "capture/solve/texel_fit.hpp"

#include <algorithm>
#include <numbers>

#include "burnish/error.hpp"
#include "burnish/f32.hpp"
#include "capture/model/parametric_fit.hpp"
#include "capture/solve/partial_ndf.hpp"
#include "capture/solve/peak_normal.hpp"
#include "capture/solve/point_fit.hpp"
#include "core/parallel.hpp"
#include "core/work_pool.hpp"

namespace burnish {

namespace {

// Candidates tried for each pixel, in the order of their match: the right exemplar is nearly always
// among them.
constexpr std::size_t kCandidates = 3;
// Candidates tried if none of the first kCandidates explains the pixel.
constexpr std::size_t kDoubtCandidates = 8;
// Ratio of a pixel's error to the mean error of the training points above which the pixel is tried
// again.
constexpr float kDoubt = 3.0f;
// Columns between the rotations of the second trial: half the width within which a search finds the
// minimum.
constexpr int kDoubtStep = 2;
// Half width, in columns, of the search around a matched rotation: tables of exemplars are not
// blurred, so that matches have this accuracy.
constexpr float kTexelColumns = 1.0f;
// Samples used to compare candidates, half of them the brightest: a fifth of the usual capture's.
constexpr std::size_t kSearchSamples = 320;
// Half width, in columns, of the final search with all samples, around the best rotation with
// kSearchSamples.
constexpr float kLastColumns = 0.25f;
// Candidates with an error up to this ratio to the least, both with kSearchSamples, are compared
// with all samples.
constexpr float kClose = 1.5f;
// A candidate's search ends after one step if the ratio of its error to the least is above this:
// further steps reduce an error by less.
constexpr float kGiveUp = 4.0f;
// Alternations between solving for the normal and the rotation of a pixel.
constexpr int kNormalPasses = 3;
// Samples used to fit the models: enough for five numbers; more samples do not predict held-out
// lights better.
constexpr std::size_t kModelSamples = 96;
// Steps of a model's search, which starts from the exemplar's nearest lobe.
constexpr int kModelSteps = 3;
// Pixels of a tile, which one worker matches together.
constexpr std::size_t kPixelTile = 16;
// Error limit of searches without an early end.
constexpr float kNever = 1e30f;

// A candidate with its best rotation and its error, both with kSearchSamples.
struct Tried {
    int exemplar;
    PointFit fit;
};

// The candidates of one pixel: searched with some of its samples, ranked with all.
class Trials {
  public:
    Trials(const Exemplars& exemplars, const PointFitter& all, const PointFitter& few)
        : exemplars_(exemplars), all_(all), few_(few) {}

    // Searches near the candidate's rotation.
    void add(const Candidate& candidate) {
        add(candidate.exemplar, candidate.shift, kGiveUp * least_);
    }

    // Searches near the best of rotations around the whole circle.
    void add_all_around(const Candidate& candidate) {
        PointFit lowest;
        lowest.error = kNoFit;
        for (int c = 0; c < exemplars_.grid.azimuths; c += kDoubtStep) {
            const PointFit fit = few_.at(tables_of(candidate.exemplar), static_cast<float>(c));
            if (fit.error < lowest.error) lowest = fit;
        }
        add(candidate.exemplar, lowest.shift, kNever);
    }

    // The best with all samples among those with nearly the least error with the few; exemplar -1
    // if there is no candidate. The best rotations with all and with few samples differ by less
    // than kLastColumns.
    Tried best() const {
        Tried out{-1, {}};
        out.fit.error = kNoFit;
        for (const Tried& one : tried_) {
            if (one.fit.error > kClose * least_) continue;
            const PointFit fit = all_.nearby(tables_of(one.exemplar), one.fit.shift, kLastColumns);
            if (fit.error < out.fit.error) out = {one.exemplar, fit};
        }
        return out;
    }

  private:
    void add(int exemplar, float shift, float give_up) {
        const PointFit fit = few_.refined(tables_of(exemplar), shift, kTexelColumns, give_up);
        tried_.push_back({exemplar, fit});
        least_ = std::min(least_, fit.error);
    }
    ExemplarTables tables_of(int exemplar) const {
        return {exemplars_.grid, exemplars_.table(exemplar), exemplars_.area(exemplar)};
    }

    const Exemplars& exemplars_;
    const PointFitter &all_, &few_;
    std::vector<Tried> tried_;
    float least_ = kNoFit;  // with the few samples
};

float luminance(const std::array<float, 3>& rgb) {
    return f32::luminance(f32::vec3(rgb[0], rgb[1], rgb[2]));
}

}  // namespace

// Memory of a worker for a tile of pixels.
struct TexelFitter::TileWork {
    std::vector<float> values, tables, weights;
    std::array<PixelWork, kPixelTile> pixels;
    std::array<Vec3f, kPixelTile> normals;  // before the exemplars are known
    PartialNdfWork partial;
    PointSamples few;
};

// State shared by all workers.
struct TexelFitter::Shared {
    std::vector<LobeFit> lobes;  // of each exemplar
    RotationMatcher matcher;
    PartialNdfSolver solver;
    float eta;
    float doubt;  // error above which a pixel is tried again
    WorkPool<TileWork> work;
};

TexelFitter::TexelFitter(const SampleContext& context, const ImageStack& stack,
                         const Exemplars& exemplars, std::vector<LobeFit> lobes,
                         const TexelFitSettings& settings)
    : context_(context),
      stack_(stack),
      exemplars_(exemplars),
      settings_(settings),
      shared_(new Shared{
          std::move(lobes),
          RotationMatcher(exemplars.grid),
          PartialNdfSolver(exemplars.grid, context.spacing_rad, static_cast<float>(settings.eta)),
          static_cast<float>(settings.eta),
          kDoubt * static_cast<float>(settings.training_error * settings.training_error),
          {}}) {
    shared_->matcher.set_exemplars(exemplars.tables());
}

TexelFitter::~TexelFitter() = default;

void TexelFitter::fit(const StackBand& band, const Progress& progress, Texels& texels) {
    parallel_for(band.pixels, kPixelTile, [&](std::size_t begin, std::size_t end) {
        progress.throw_if_cancelled();
        const WorkPool<TileWork>::Lease lease(shared_->work);
        TileWork& tile = *lease;
        const std::size_t count = end - begin;
        gather_tile(band, begin, count, tile);
        const auto candidates =
            best_candidates(shared_->matcher, {tile.tables, tile.weights, count}, kDoubtCandidates);
        for (std::size_t k = 0; k < count; ++k)
            if (const std::size_t pixel = band.first + begin + k; stack_.mask()[pixel])
                fit_texel(pixel, k, candidates[k], tile, texels);
    });
}

// Samples and partial distributions of `count` pixels.
void TexelFitter::gather_tile(const StackBand& band, std::size_t begin, std::size_t count,
                              TileWork& tile) const {
    const auto cells = static_cast<std::size_t>(exemplars_.grid.cells());
    const std::size_t per_pixel = 3 * stack_.lights();
    tile.values.resize(count * per_pixel);
    tile.tables.resize(count * cells);
    tile.weights.resize(count * cells);
    stack_.decode(band, begin, count, tile.values.data());
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t pixel = band.first + begin + k;
        float* table = tile.tables.data() + k * cells;
        float* known = tile.weights.data() + k * cells;
        const float* values = tile.values.data() + k * per_pixel;
        tile.normals[k] = {0.0f, 0.0f, 1.0f};
        if (!stack_.mask()[pixel]) {
            std::fill_n(known, cells, 0.0f);
        } else {
            tile.normals[k] = first_normal(settings_.normals, context_, shared_->solver, pixel,
                                           values, tile.pixels[k], tile.partial, table, known);
        }
    }
}

// Fits the best exemplar and rotation of a pixel, the k-th of its tile, and its strengths in each
// channel. A pixel that no candidate explains has no exemplar.
void TexelFitter::fit_texel(std::size_t pixel, std::size_t k,
                            const std::vector<Candidate>& candidates, TileWork& tile,
                            Texels& texels) const {
    const float* values = tile.values.data() + k * 3 * stack_.lights();
    PixelWork& work = tile.pixels[k];
    PointFitter fitter(work.samples, shared_->eta);
    thin_samples(work.samples, kSearchSamples, tile.few);
    const PointFitter quick(tile.few, shared_->eta);
    Trials trials(exemplars_, fitter, quick);
    for (std::size_t c = 0; c < std::min(candidates.size(), kCandidates); ++c)
        trials.add(candidates[c]);
    Tried best = trials.best();
    // A much larger error than at the training points: the match may have ranked the right rotation
    // low.
    if (best.exemplar >= 0 && best.fit.error > shared_->doubt) {
        for (const Candidate& candidate : candidates) trials.add_all_around(candidate);
        best = trials.best();
    }
    if (best.exemplar < 0) return;
    const ExemplarTables own = tables_of(best.exemplar);
    Vec3f normal = tile.normals[k];
    if (settings_.normals != NormalStart::none) {
        for (int pass = 0; pass < kNormalPasses; ++pass)
            normal = refined_normal({context_, pixel, values, shared_->eta, own}, normal, work,
                                    best.fit);
        fitter = PointFitter(work.samples, shared_->eta);  // the samples were gathered again
    }
    std::array<float, 3> diffuse{}, specular{};
    fitter.colors(own, best.fit.shift, diffuse, specular);
    const std::size_t texel = pixel - texels.first;
    texels.exemplar[texel] = static_cast<std::uint16_t>(best.exemplar);
    texels.angle[texel] = best.fit.shift * 2.0f * std::numbers::pi_v<float> /
                          static_cast<float>(exemplars_.grid.azimuths);
    texels.error[texel] = best.fit.error;
    for (std::size_t c = 0; c < 3; ++c) {
        texels.diffuse[3 * texel + c] = diffuse[c];
        texels.specular[3 * texel + c] = specular[c];
        texels.normal[3 * texel + c] = normal[c];
    }
    if (!settings_.models) return;
    thin_samples(work.samples, kModelSamples, tile.few);
    fit_models(texel, {best.exemplar, best.fit.shift, 0.0f}, tile.few, texels);
}

void TexelFitter::fit_models(std::size_t texel, const Candidate& best, const PointSamples& samples,
                             Texels& texels) const {
    const LobeFit& lobe = shared_->lobes[static_cast<std::size_t>(best.exemplar)];
    ParametricFit start;
    start.alpha_along = static_cast<float>(lobe.alpha_along);
    start.alpha_across = static_cast<float>(lobe.alpha_across);
    start.groove =
        static_cast<float>(lobe.groove) + best.shift * 2.0f * std::numbers::pi_v<float> /
                                              static_cast<float>(exemplars_.grid.azimuths);
    const std::size_t models = parametric_model_names().size();
    for (std::size_t m = 0; m < models; ++m) {
        const ParametricFit fit = fit_parametric(static_cast<ParametricModel>(m), samples,
                                                 shared_->eta, start, {false, kModelSteps});
        float* to = texels.models.data() + (texel * models + m) * kModelNumbers.size();
        to[0] = fit.alpha_along;
        to[1] = fit.alpha_across;
        to[2] = fit.groove * 180.0f / std::numbers::pi_v<float>;
        to[3] = luminance(fit.diffuse);
        to[4] = luminance(fit.specular);
    }
}

}  // namespace burnish
