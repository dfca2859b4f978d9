// Measured materials beside their fits, as a figure. Private to fit_measured.
#pragma once

#include <span>

#include "burnish/plot/figure.hpp"
#include "jobs/models/brdf_fit.hpp"

namespace burnish {

// A row a material and scale (linear, log), a polar panel an incident direction of its curves: the
// luminance of f as it was measured and of the best `most_models` fits.
plot::Figure fit_figure(std::span<const MeasuredFit> fits, std::size_t most_models,
                        double panel_px);

}  // namespace burnish
