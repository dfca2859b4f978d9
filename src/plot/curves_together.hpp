// Several curves in one plot. Where curves lie on one another, the last one would hide the others:
// there they take turns in dashes, so that every color is seen.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "burnish/plot/canvas.hpp"

namespace burnish::plot {

struct DrawnCurve {
    std::vector<std::vector<Point>> pieces;  // px of the page; the curve has gaps between them
    Stroke stroke;
};

// `counts`: the places where a curve that is covered is missed. Curves that meet on an axis, at 0,
// need no dashes. At most 64 curves are compared; further ones are drawn as they are.
void draw_curves(Canvas& canvas, std::span<const DrawnCurve> curves,
                 const std::function<bool(Point)>& counts);

}  // namespace burnish::plot
