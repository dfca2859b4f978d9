// What a fitted material cannot be trusted in, and the warnings of it.
#pragma once

#include <string>
#include <vector>

#include "burnish/tabulated_material.hpp"
#include "jobs/capture/capture_fit.hpp"

namespace burnish {

// `m`: as CaptureFit::material makes it. `spacing_deg`: CaptureFitReport::spacing_deg.
ExemplarJudgement judge_exemplars(const TabulatedMaterial& m, double spacing_deg);

// Texels with a color at the end of the file's range, where CaptureFit::material cuts it.
std::size_t texels_beyond_range(const TabulatedMaterial& m);

// Warns of limits of the fit that follow from its inputs. `result`: all but its warnings is set.
void warn_of_fit(const CaptureFitResult& result, const CaptureFitRequest& request,
                 std::vector<std::string>& warnings);

}  // namespace burnish
