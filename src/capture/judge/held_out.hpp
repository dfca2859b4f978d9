// Errors of a fit on the pictures of held-out lights, which took no part in it, and the same errors
// of the analytic models that were fitted to the same pictures.
#pragma once

#include <string>
#include <vector>

#include "burnish/progress.hpp"
#include "burnish/rig.hpp"
#include "burnish/tabulated_material.hpp"
#include "capture/stack/image_stack.hpp"

namespace burnish {

// Errors of luminance over the valid samples of held-out lights: not clipped, and of a light above
// the point's horizon.
struct HeldOutError {
    std::string model;        // "tabulated" or one of parametric_model_names()
    std::size_t samples = 0;  // the number of valid samples
    double peak = 0.0;        // the brightest of them, in the pictures' units
    double rmse = 0.0;        // in the pictures' units; 0 without samples
    double psnr =
        0.0;  // dB relative to `peak`: infinite for an RMSE of 0, not a number without samples
};

// `keep`: 1 for lights that took part (fitted_lights). Omits models whose maps the material lacks;
// returns an empty list if no light was held out.
std::vector<HeldOutError> held_out_errors(const ImageStack& stack, const Rig& rig,
                                          const TabulatedMaterial& material,
                                          const std::vector<std::uint8_t>& keep,
                                          const Progress& progress);

}  // namespace burnish
