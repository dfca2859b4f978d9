// Functions shared by the two plot commands. Private to src/jobs/models/plot_*.cpp.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "jobs/models/plot.hpp"

namespace burnish {

// The given roughness pair, and its conversion to the other kind.
struct RoughnessPair {
    bool exponents = true;
    double x = 200, y = 10;

    std::pair<double, double> as_alpha() const;
    std::pair<double, double> as_exponents() const;
};
RoughnessPair roughness_pair(const ParameterValues& values);

// Draws and writes the figure; reports progress after each panel.
void write_plot(plot::Figure figure, const PlotOutput& output, plot::Metadata parameters,
                const Progress& progress);

// Rows of at most `most` panels, each with the same label and bar.
void add_rows(plot::Figure& figure, const plot::PanelRow& row, std::size_t most);

}  // namespace burnish
