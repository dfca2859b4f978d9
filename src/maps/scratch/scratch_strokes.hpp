// Strokes from settings: the position and shape of each scratch; strokes into maps. Private to the scratch
// generator.
#pragma once

#include <cstddef>
#include <vector>

#include "burnish/scratch_maps.hpp"
#include "burnish/scratch_settings.hpp"

namespace burnish {

// A circular arc (a straight line for curvature 0) with the profile of its layer. Lengths are in
// millimeters, y runs down the picture.
struct Stroke {
    double x = 0.0, y = 0.0;  // the middle
    double angle = 0.0;       // of the tangent at the middle, radians, counter-clockwise with y up
    double curvature = 0.0;   // 1/mm; positive turns left, counter-clockwise
    double half_length = 0.0;
    double half_width = 0.0;  // at the widest point
    double depth = 0.0;
};

// The point of the arc at `s` millimeters from its middle.
struct StrokePoint {
    double x, y;
};
StrokePoint point_on(const Stroke& stroke, double s);

// The strokes of one layer. They depend only on settings, inputs and `layer`, not on the size in
// texels or the number of threads.
std::vector<Stroke> make_strokes(const ScratchSettings& settings, std::size_t layer,
                                 const ScratchInputs& inputs);

// Throws UsageError for settings and inputs that cannot be.
void check_scratch_inputs(const ScratchSettings& settings, const ScratchInputs& inputs);

std::vector<std::vector<Stroke>> strokes_of_layers(const ScratchSettings& settings,
                                                   const ScratchInputs& inputs);

// As engrave(), without moments, of strokes that are made already and settings that were checked.
ScratchMaps engrave_strokes(const ScratchSettings& settings, const ScratchInputs& inputs,
                            const std::vector<std::vector<Stroke>>& strokes,
                            const Progress& progress);

}  // namespace burnish
