// From a stack of pictures to a material of measured distributions, in stages that are kept on
// disk: an interrupted fit continues where it was, and gives what an uninterrupted one gives.
//
//   pictures    every picture read once (image_stack.hpp)
//   exemplars   partial distributions of some points, clustered, solved for, completed; eta
//               (exemplar_search.hpp)
//   texels      every pixel: exemplar, rotation, diffuse, specular, normal, models (texel_fit.hpp)
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "burnish/capture_fit.hpp"
#include "burnish/lobe_fit.hpp"
#include "burnish/progress.hpp"
#include "burnish/tabulated_material.hpp"
#include "capture/solve/exemplar_search.hpp"
#include "capture/solve/texels.hpp"
#include "capture/stack/image_stack.hpp"

namespace burnish {

class TexelFitter;

struct CaptureFitReport {
    StackCensus census;
    double spacing_deg =
        0.0;  // median distance of neighboring half vectors, at the center of the sample
    int training_points = 0;
    int exemplars = 0;
    double eta = 0.0;
    CompletionReport completion;
    double training_error = 0.0;  // root of the mean of the training points' PointFit::error
};

// A light each: 1 takes part, 0 is held out.
std::vector<std::uint8_t> fitted_lights(std::size_t lights, int hold_out);

// One object per fit; its members must not be called from several threads at a time, and run in
// parallel themselves. Results do not depend on the number of threads. Members throw Error for
// files, Interrupted when cancelled; what was written by then is found by the next run.
class CaptureFit {
  public:
    // Reads the pictures. `stages`: a folder for what is kept between runs; made when it is not
    // there.
    CaptureFit(const Rig& rig, const CaptureFitSettings& settings,
               const std::filesystem::path& stages, const Progress& progress);
    // Of pictures in memory (images_of); nothing is kept between runs.
    CaptureFit(const Rig& rig, std::span<const Image> pictures, const Image& mask,
               const CaptureFitSettings& settings, const Progress& progress);
    ~CaptureFit();

    // Takes the exemplars from `stages` where an earlier run of the same settings left them.
    void find_exemplars();

    // Every texel; needs the exemplars. Continues after the last band that an earlier run left.
    void fit_texels();
    // The same in parts, for several jobs over one folder: the texels of bands [first, last) of
    // stack().bands(). They are the same as fit_texels finds. Nothing is written.
    Texels fit_bands(std::size_t first, std::size_t last);
    // Takes the texels of all bands over, as parts of fit_bands merged (Texels::merge), in place of
    // fit_texels.
    void take_texels(Texels texels);

    // After all texels.
    TabulatedMaterial material() const;

    const Rig& rig() const { return rig_; }  // with the height of the sample filled in
    const ImageStack& stack() const { return *stack_; }
    const Exemplars& exemplars() const { return exemplars_; }
    const CaptureFitReport& report() const { return report_; }
    const CaptureFitSettings& settings() const { return settings_; }
    // Root of the mean of PointFit::error: of the texels once they are done, else of the training
    // points.
    double unexplained() const;

  private:
    void start();  // with the stack in place
    TexelFitter texel_fitter() const;
    bool load_exemplars();
    void save_exemplars() const;
    std::size_t load_texels();
    void save_texels(std::size_t bands) const;
    std::uint64_t identity() const;
    std::uint64_t texel_identity() const;

    Rig rig_;
    CaptureFitSettings settings_;
    std::filesystem::path stages_;  // empty: nothing is kept
    Progress progress_;
    std::unique_ptr<ImageStack> stack_;
    std::unique_ptr<LightGeometry> geometry_;
    SampleContext context_;
    Exemplars exemplars_;
    std::optional<Texels> texels_;
    CaptureFitReport report_;
};

}  // namespace burnish
