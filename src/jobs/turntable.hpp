// The turntables of `burnish render`: which pictures there are to draw, the drawing, the film of them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "burnish/progress.hpp"
#include "burnish/render.hpp"
#include "burnish/stage.hpp"
#include "jobs/render.hpp"

namespace burnish {

// Throws UsageError for flags of turntables that contradict each other, or have none.
void check_turntable(const RenderRequest& request);

// Draws what is missing of the turntable. `metadata`: of every picture, but for the device. Throws
// Error for a picture that is there and not of this turn (`resume`), before anything is drawn.
RenderReport render_turntable(const RenderRequest& request, Stage& stage, const Metadata& metadata,
                              const Progress& progress);

}  // namespace burnish
