// Panels of any data: pictures, lines over an axis, bars.
//
// Threads: any number may make panels at a time. Lifetime: a panel keeps what it draws.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/plot/figure.hpp"

namespace burnish {
namespace BURNISH_API plot {

// Display values (what write_image takes for PNG). `width` px on the page, 0: half the pixels of
// the picture, so that a figure written with the usual pixel ratio of 2 shows it texel for texel.
Panel picture_panel(const Image& image, std::string title, double width = 0);

struct Axis {
    std::string label;
    Scale scale;
};

struct Series {
    std::string label;
    std::vector<Point> points;  // in the units of the axes; a NaN breaks the line
    Rgb color;
    std::vector<double> dash = {};
    double width = 1.8;
};

// The i-th of several lines, in its colour and dash.
Series series(std::size_t index, std::string label, std::vector<Point> points);
std::vector<LegendEntry> legend_of(const std::vector<Series>& all);

// Lines over an axis. Parts beyond the axes are cut off, and arrows at the edge mark them.
struct LinePlot {
    Axis x, y;
    std::vector<Series> lines;
    std::optional<std::pair<double, std::string>> level = {};  // a labelled horizontal line
    std::optional<std::pair<double, std::string>> place = {};  // a labelled upright line
};
Panel line_panel(LinePlot plot, std::string title, double width = 380, double height = 280);

// A horizontal bar from 0 with its value beside it.
struct Bar {
    std::string label;
    double value = 0;
    double spread = 0;      // half the length of a whisker; 0: none
    std::string text = {};  // written behind the bar; empty: the value
    Rgb color = series_color(0);
    std::optional<double> mark = {};  // a second value to compare with, drawn as a diamond
};

struct BarPlot {
    std::vector<Bar> bars;
    std::string axis_label;
    double most = 0;  // value at the right end of the axis; 0: the largest that is drawn
    Rgb mark_color = kInk;
};

// Marks an area "bar LABEL" for each bar, and "bars" for all.
Panel bar_panel(BarPlot plot, std::string title, double width = 460);

}  // namespace plot
}  // namespace burnish
