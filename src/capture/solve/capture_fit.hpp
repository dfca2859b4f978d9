// Fits a material of measured distributions to a stack of pictures, in stages that are kept on
// disk. An interrupted fit continues from its last stage and gives the result of an uninterrupted
// one.
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
#include "capture/solve/training_points.hpp"
#include "capture/stack/image_stack.hpp"
#include "capture/stack/light_level.hpp"

namespace burnish {

class TexelFitter;

// Unexplained share of the light, as a root mean square, above which a fit is doubted: 5 % of noise
// in each channel leaves less.
inline constexpr double kMuchUnexplained = 0.05;

// The same, above which a flat fit is compared with one with normals: less is the noise of the best
// pictures.
inline constexpr double kTriedUnexplained = 0.005;

struct CaptureFitReport {
    StackCensus census;
    LightLevel level;
    double spacing_deg =
        0.0;  // median distance of neighboring half vectors, at the center of the sample
    int training_points = 0;
    int exemplars = 0;
    double eta = 0.0;
    CompletionReport completion;
    double training_error = 0.0;  // root of the mean of the training points' PointFit::error
    NormalStart start = NormalStart::none;  // of the fit with the lower training_error
    // training_error of some of the points with normals of their own, where a fit without them
    // leaves more than kTriedUnexplained; else 1.
    double tilted_error = 1.0;
};

// One value for each light: 1 takes part, 0 is held out.
std::vector<std::uint8_t> fitted_lights(std::size_t lights, int hold_out);

// One object for each fit. Call its members from one thread at a time; they run in parallel
// themselves. Results do not depend on the number of threads. Members throw Error for files and
// Interrupted when canceled; the next run continues from the stages that were written.
class CaptureFit {
  public:
    // Reads the pictures. `stages`: a folder for the files kept between runs; created if it is
    // missing.
    CaptureFit(const Rig& rig, const CaptureFitSettings& settings,
               const std::filesystem::path& stages, const Progress& progress);
    // Fits pictures in memory (images_of); keeps nothing between runs.
    CaptureFit(const Rig& rig, std::span<const Image> pictures, const Image& mask,
               const CaptureFitSettings& settings, const Progress& progress);
    ~CaptureFit();

    // Finds the exemplars, or loads them from `stages` if an earlier run with the same settings
    // wrote them.
    void find_exemplars();

    // Fits every texel; requires the exemplars. Continues after the last band that an earlier run
    // wrote.
    void fit_texels();
    // Fits the texels of bands [first, last) of stack().bands(), for several jobs over one folder.
    // The texels equal those of fit_texels. Writes nothing.
    Texels fit_bands(std::size_t first, std::size_t last);
    // Takes the texels of all bands, merged from parts of fit_bands (Texels::merge), instead of
    // calling fit_texels.
    void take_texels(Texels texels);

    // Requires all texels.
    TabulatedMaterial material() const;

    // With the computed height of the sample and the chosen intensities.
    const Rig& rig() const { return rig_; }
    const ImageStack& stack() const { return *stack_; }
    const Exemplars& exemplars() const { return exemplars_; }
    const CaptureFitReport& report() const { return report_; }
    const CaptureFitSettings& settings() const { return settings_; }
    // Root of the mean of PointFit::error: over the texels once they are fitted, before that over
    // the training points.
    double unexplained() const;

  private:
    FoundExemplars search(const TrainingPoints& points, NormalStart start,
                          std::optional<double> eta) const;
    // Normals start at the diffuse light; where that leaves more than kMuchUnexplained, as on metals,
    // they start at the highlight too, and the start of the lower error counts.
    FoundExemplars search_tilted(const TrainingPoints& points, std::optional<double> eta,
                                 NormalStart& start) const;
    void start();  // continues construction once the stack is ready
    TexelFitter texel_fitter() const;
    bool load_exemplars();
    void save_exemplars() const;
    std::size_t load_texels();
    void save_texels(std::size_t bands) const;
    std::uint64_t identity() const;
    std::uint64_t texel_identity() const;

    Rig rig_;
    CaptureFitSettings settings_;
    std::filesystem::path stages_;  // empty: keeps no files
    Progress progress_;
    std::unique_ptr<ImageStack> stack_;
    std::unique_ptr<LightGeometry> geometry_;
    SampleContext context_;
    Exemplars exemplars_;
    std::optional<Texels> texels_;
    CaptureFitReport report_;
};

}  // namespace burnish
