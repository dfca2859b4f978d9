// From a stack of pictures to a material of measured distributions, in stages that are kept on
// disk: an interrupted fit goes on where it was, and gives what an uninterrupted one gives.
//
//   pictures    every picture read once (image_stack.hpp)
//   exemplars   partial distributions of some points, clustered, solved for, completed; eta
//   texels      every pixel: exemplar, angle, diffuse, specular
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "burnish/progress.hpp"
#include "capture/solve/exemplar_search.hpp"
#include "capture/stack/image_stack.hpp"
#include "fit/lobe_fit.hpp"
#include "scene/material/tabulated_material.hpp"

namespace burnish {

struct CaptureFitSettings {
    NdfGrid grid;
    int exemplars = 64;         // at most
    std::optional<double> eta;  // none: estimated; 0: no Fresnel
    std::uint64_t seed = 1;
    int hold_out = 0;  // every n-th light takes no part and judges; 0: none
    // From which exemplars are made, at most; 0: 8192, and no more than have 4 million samples.
    int training_points = 0;
    bool normals = false;  // let normals tilt; else the sample is flat
    bool models = true;    // analytic models of every texel too (parametric_fit.hpp)
};

struct CaptureFitReport {
    StackCensus census;
    double spacing_deg = 0.0;  // median, of half vectors in the middle of the sample
    int training_points = 0;
    int exemplars = 0;
    double eta = 0.0;
    CompletionReport completion;
    double training_error = 0.0;  // root of the mean of the points' PointFit::error
};

// Lights that take part (1) or are held out (0).
std::vector<std::uint8_t> fitted_lights(std::size_t lights, int hold_out);

class CaptureFit {
  public:
    // `stages`: a folder for what is kept between runs; made when it is not there.
    CaptureFit(const Rig& rig, const CaptureFitSettings& settings,
               const std::filesystem::path& stages, const Progress& progress);
    ~CaptureFit();

    void find_exemplars();
    void fit_texels();
    // After both.
    TabulatedMaterial material() const;

    const Rig& rig() const { return rig_; }  // with the sample's height filled in
    const ImageStack& stack() const { return *stack_; }
    const Exemplars& exemplars() const { return exemplars_; }
    const CaptureFitReport& report() const { return report_; }
    const CaptureFitSettings& settings() const { return settings_; }
    // Root of the mean of PointFit::error: of the texels once they are done, else of the points
    // that exemplars are made from, as they were before the last of these.
    double unexplained() const;

  private:
    struct Texels;
    struct TileWork;
    struct TexelTools;
    std::vector<std::size_t> training_pixels() const;
    std::vector<float> training_values(const std::vector<std::size_t>& pixels) const;
    ExemplarTables tables_of(int exemplar) const {
        return {settings_.grid, exemplars_.table(exemplar), exemplars_.area(exemplar)};
    }
    PointFit best_turn(const PointFitter& fitter, const PointSamples& few,
                       const std::vector<PointTurn>& candidates, const TexelTools& tools,
                       int& exemplar) const;
    void fit_texel(std::size_t pixel, std::size_t k, const std::vector<PointTurn>& candidates,
                   const TexelTools& tools, TileWork& tile, Texels& texels) const;
    void fit_models(std::size_t pixel, int exemplar, float shift, const TexelTools& tools,
                    const PointSamples& samples, Texels& texels) const;
    void fit_band(const StackBand& band, TexelTools& tools, Texels& texels) const;
    std::size_t load_texels();
    void save_texels(std::size_t bands) const;
    std::uint64_t texel_identity() const;
    std::vector<LobeFit> lobes() const;
    bool load_exemplars();
    void save_exemplars() const;
    std::uint64_t identity() const;

    Rig rig_;
    CaptureFitSettings settings_;
    std::filesystem::path stages_;
    Progress progress_;
    std::unique_ptr<ImageStack> stack_;
    std::unique_ptr<LightGeometry> geometry_;
    SampleContext context_;
    Exemplars exemplars_;
    std::unique_ptr<Texels> texels_;
    CaptureFitReport report_;
};

}  // namespace burnish
