// Figures of several panels: plots and pictures in rows, with titles, colour bars, a legend and a
// caption, written as PNG or SVG. Panels come from plot/panels.hpp, mdf_plot.hpp and brdf_plot.hpp;
// any other kind is a Panel with a `draw` of its own.
//
//   Figure figure;
//   figure.title = "K11 Fig 6";
//   figure.rows.push_back({"isotropic", {disk_panel(...), picture_panel(image, "rendered")}});
//   write_figure(figure, "fig6.png", {{"burnish:command", ...}, {"burnish:version", ...}});
//
// Threads: one at a time for each figure. Lifetime: a figure keeps what its panels draw.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "burnish/api.hpp"
#include "burnish/image.hpp"
#include "burnish/plot/canvas.hpp"
#include "burnish/plot/scale.hpp"

namespace burnish {
namespace BURNISH_API plot {

// One place of a figure. Sizes are px of the page, without title and note.
struct Panel {
    std::string title;  // above, wrapped; panels of a row have their titles at one height
    double width = 260;
    double height = 260;
    std::function<void(Canvas&, const Box&)> draw;  // into the box, axes and their numbers included
    std::string note;  // below, small, wrapped: the measured figures, or what to look at
    // Center of title and note, px to the right of the panel's own center: for axes at the left.
    double middle = 0;
};

struct ColorBar {
    Scale scale;
    std::string label;  // "D [1/sr], linear"
    std::optional<double> above =
        {};                  // largest value, when it is beyond the scale: drawn as an arrow
    bool diverging = false;  // else sequential
};

struct PanelRow {
    std::string label;  // at the left, upright
    std::vector<Panel> panels;
    std::optional<ColorBar> bar = {};  // at the right of this row
};

struct LegendEntry {
    std::string label;
    Rgb color;
    std::vector<double> dash = {};
};

struct Figure {
    std::string title;
    std::vector<PanelRow> rows;            // rows may differ in length
    std::vector<LegendEntry> legend = {};  // below the rows
    std::string caption;                   // below all, wrapped to the width
};

using Metadata = std::map<std::string, std::string>;

// A figure holds at most this many panels, and its picture at most this many pixels a side.
inline constexpr std::size_t kMostPanels = 120;
inline constexpr double kMostSidePx = 16384;

// Throws UsageError for more panels or a larger picture than that, and for a figure without panels.
struct DrawnFigure {
    Image image;                  // RGB, display values
    double pixel_ratio = 2;       // pixels per px
    std::vector<DataArea> areas;  // of the panels, in px; each panel's `draw` names its own
};
DrawnFigure draw_figure(const Figure& figure, double pixel_ratio = 2);
std::string figure_svg(const Figure& figure, const Metadata& metadata);

// Writes by extension: .png (pixel_ratio pixels per px, metadata as attributes) or .svg
// (<metadata>, and title and caption as <title> and <desc>). Written whole or not at all. Throws
// UsageError for other extensions. Throws Error, before anything is drawn, for a path that cannot
// be written.
void require_figure_path(const std::filesystem::path& path);
void write_figure(const Figure& figure, const std::filesystem::path& path, const Metadata& metadata,
                  double pixel_ratio = 2);

}  // namespace plot
}  // namespace burnish
