// From settings to strokes: where each scratch lies and how it is shaped. Private to the scratch
// generator.
#pragma once

#include <cstddef>
#include <vector>

#include "burnish/scratch_maps.hpp"
#include "burnish/scratch_settings.hpp"

namespace burnish {

// A circular arc (a straight line where curvature is 0) with the profile of its layer. Lengths are
// millimetres, y runs down the picture.
struct Stroke {
    double x = 0.0, y = 0.0;  // the middle
    double angle = 0.0;       // of the tangent there, radians, counter-clockwise with y up
    double curvature = 0.0;   // positive turns to the left, counter-clockwise
    double half_length = 0.0;
    double half_width = 0.0;  // where it is widest
    double depth = 0.0;
};

// A point of the arc, `s` millimetres from its middle.
struct StrokePoint {
    double x, y;
};
StrokePoint point_on(const Stroke& stroke, double s);

// The strokes of one layer. They depend on settings, inputs and `layer` alone: not on the size in
// texels, nor on the number of threads.
std::vector<Stroke> make_strokes(const ScratchSettings& settings, std::size_t layer,
                                 const ScratchInputs& inputs);

}  // namespace burnish
