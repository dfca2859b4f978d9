// From pictures of one flat sample, by one camera under many lights, to a tabulated material.
//
// Where the rig states no intensities (Rig::intensity_stated) and the pictures, taken as they are,
// would make the sample whiter than white or nearly black, the fit chooses the unit: it multiplies
// all intensities by one factor, so that the brightest parts of the sample reflect as white paper
// does. The material's metadata hold the factor ("burnish:chosen_intensity"). Where the rig states
// intensities with which a material could not be written, Error names them before the fit.
//
// Threads: functions may be called from any thread, and run in parallel themselves; results do not
// depend on the number of threads. Lifetime: nothing that is passed in is referred to afterwards.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

#include "burnish/api.hpp"
#include "burnish/image.hpp"
#include "burnish/ndf_grid.hpp"
#include "burnish/progress.hpp"
#include "burnish/rig.hpp"
#include "burnish/tabulated_material.hpp"

namespace BURNISH_API burnish {

// Memory of one band of a stack of pictures, bytes: large enough that reads from a disk are
// sequential, small beside other memory.
inline constexpr std::size_t kUsualBandBytes = std::size_t{48} << 20;

struct CaptureFitSettings {
    NdfGrid grid;               // of the exemplars
    int exemplars = 64;         // at most
    std::optional<double> eta;  // none: estimated; 0: no Fresnel
    std::uint64_t seed = 1;
    int hold_out = 0;         // every n-th light takes no part and judges; 0: none
    int training_points = 0;  // at most; 0: 8192, and no more than have 4 million samples
    bool normals = false;     // normals of texels may tilt; else the sample is flat
    bool models = true;       // analytic models of every texel too (parametric_fit.hpp)
    // Memory of the pictures' bands, in bytes; results do not depend on it.
    std::size_t band_bytes = kUsualBandBytes;
};

// `pictures`: one a light of the rig and in its order: linear, RGB or grey, all of one size, row 0
// at the top. `mask`: 1 channel of that size, above 0.5 is to be measured; empty: everything.
// Writes no file. Throws Error for pictures that do not fit the rig or hold values that are not
// finite, Interrupted when `progress` is cancelled.
TabulatedMaterial fit_capture(const Rig& rig, std::span<const Image> pictures,
                              const Image& mask = {}, const CaptureFitSettings& settings = {},
                              const Progress& progress = {});

// The same from the picture files that the rig names. `stages`: a folder for what is kept between
// runs, made when it is not there: an interrupted fit continues where it was. Throws Error for
// files, Interrupted when `progress` is cancelled.
TabulatedMaterial fit_capture(const Rig& rig, const std::filesystem::path& stages,
                              const CaptureFitSettings& settings = {},
                              const Progress& progress = {});

}  // namespace burnish
