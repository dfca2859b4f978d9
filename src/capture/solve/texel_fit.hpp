// The last stage of a fit: fits the exemplars to every pixel, band by band.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "burnish/lobe_fit.hpp"
#include "burnish/progress.hpp"
#include "capture/solve/exemplars.hpp"
#include "capture/solve/peak_normal.hpp"
#include "capture/solve/point_fit.hpp"
#include "capture/solve/sample_context.hpp"
#include "capture/solve/texels.hpp"
#include "capture/stack/image_stack.hpp"

namespace burnish {

struct TexelFitSettings {
    NormalStart normals = NormalStart::none;  // unless none, the normals of pixels may tilt
    bool models = true;                       // also fits the analytic models to every pixel
    double eta = 0.0;                         // index of refraction; 0: no Fresnel factor
    // Root of the mean of PointFit::error over the training points. Pixels with much larger errors
    // are tried again.
    double training_error = 0.0;
};

class TexelFitter {
  public:
    // `context`, `stack` and `exemplars` must outlive the fitter. `lobes`: the nearest GGX lobe of
    // each exemplar, the start of the models' searches.
    TexelFitter(const SampleContext& context, const ImageStack& stack, const Exemplars& exemplars,
                std::vector<LobeFit> lobes, const TexelFitSettings& settings);
    ~TexelFitter();

    // Fits the pixels of a band, which must lie within `texels`. Runs in parallel; the results
    // depend neither on the number of threads nor on the bands fitted before. One call at a time.
    // Throws Interrupted.
    void fit(const StackBand& band, const Progress& progress, Texels& texels);

  private:
    struct TileWork;
    struct Shared;

    void gather_tile(const StackBand& band, std::size_t begin, std::size_t count,
                     TileWork& tile) const;
    void fit_texel(std::size_t pixel, std::size_t k, const std::vector<Candidate>& candidates,
                   TileWork& tile, Texels& texels) const;
    void fit_models(std::size_t texel, const Candidate& best, const PointSamples& samples,
                    Texels& texels) const;
    ExemplarTables tables_of(int exemplar) const {
        return {exemplars_.grid, exemplars_.table(exemplar), exemplars_.area(exemplar)};
    }

    const SampleContext& context_;
    const ImageStack& stack_;
    const Exemplars& exemplars_;
    TexelFitSettings settings_;
    std::unique_ptr<Shared> shared_;
};

}  // namespace burnish
