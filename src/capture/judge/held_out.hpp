// How well a fit predicts pictures that took no part in it, those of the lights that were held out,
// beside the analytic models that were fitted to the same pictures.
#pragma once

#include <string>
#include <vector>

#include "burnish/progress.hpp"
#include "burnish/rig.hpp"
#include "burnish/tabulated_material.hpp"
#include "capture/stack/image_stack.hpp"

namespace burnish {

// Of luminance, over the samples of held-out lights that are not clipped and whose light stands
// above the point's horizon.
struct HeldOutError {
    std::string model;        // "tabulated" or one of parametric_model_names()
    std::size_t samples = 0;  // that count
    double peak = 0.0;        // the brightest of them, in the pictures' units
    double rmse = 0.0;        // in the pictures' units; 0 without samples
    double psnr =
        0.0;  // dB relative to `peak`: infinite for an RMSE of 0, not a number without samples
};

// `keep`: 1 for lights that took part (fitted_lights). Models whose maps the material lacks are
// left out; without a held-out light the list is empty.
std::vector<HeldOutError> held_out_errors(const ImageStack& stack, const Rig& rig,
                                          const TabulatedMaterial& material,
                                          const std::vector<std::uint8_t>& keep,
                                          const Progress& progress);

}  // namespace burnish
