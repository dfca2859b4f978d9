// How well a fit foretells pictures that took no part in it: lights that were held out, beside the
// analytic models fitted to the same pictures.
#pragma once

#include <string>
#include <vector>

#include "burnish/progress.hpp"
#include "capture/rig/rig.hpp"
#include "capture/stack/image_stack.hpp"
#include "scene/material/tabulated_material.hpp"

namespace burnish {

// Of luminance, over the samples of held-out lights that are not clipped and whose light stands
// above the point's horizon.
struct HeldOutError {
    std::string model;  // "tabulated" or one of parametric_model_names()
    double rmse = 0.0;  // in the pictures' units
    double psnr = 0.0;  // dB; the peak is the brightest of those samples
};

// `keep`: 1 for lights that took part (fitted_lights). Models whose maps the material lacks are
// left out; without a held-out light the list is empty.
std::vector<HeldOutError> held_out_errors(const ImageStack& stack, const Rig& rig,
                                          const TabulatedMaterial& material,
                                          const std::vector<std::uint8_t>& keep,
                                          const Progress& progress);

}  // namespace burnish
