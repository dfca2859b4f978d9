// Axes of a data area, for the panels of this folder.
#pragma once

#include <string>

#include "burnish/plot/canvas.hpp"
#include "burnish/plot/scale.hpp"

namespace burnish::plot {

inline const TextStyle kAxisNumber{.size = 11.5, .color = kInk};
inline const TextStyle kAxisLabel{.size = 12.5, .color = kInk};

// Ticks and numbers outside the box, the label beyond them; `grid`: faint lines across the box.
void draw_x_axis(Canvas& canvas, const Box& box, const Scale& scale, const std::string& label,
                 bool grid);
void draw_y_axis(Canvas& canvas, const Box& box, const Scale& scale, const std::string& label,
                 bool grid);

// Room the axes need around a data area.
inline constexpr double kAxisBelow = 38;
inline constexpr double kAxisLeft = 62;
inline constexpr double kAxisRight = 12;

}  // namespace burnish::plot
