// The benchmark's report: rows of work, budget and measured value.
#pragma once

#include <string>
#include <vector>

#include "core/statistics.hpp"

namespace burnish::bench {

struct Row {
    std::string work;
    double budget = 0;  // upper bound; 0: no budget
    double reached = 0;
    double spread = 0;  // half the distance between the quartiles
    std::string unit;   // "x" for a ratio, "s" ...
};

struct Report {
    std::string device;
    std::vector<Row> rows;
};

// Budgets and measured values side by side, as Markdown with machine and date; also the console
// output.
std::string to_markdown(const Report& report);

void measure_frames(Report& report);
void measure_area_lights(Report& report);
void measure_cloth(Report& report);
void measure_layers(Report& report);
void measure_edits(Report& report);
void measure_image_light(Report& report);  // does nothing without the sample data
void measure_loading(Report& report);
void measure_first_picture(Report& report);
void measure_scratches(Report& report);
void measure_weaves(Report& report);
void measure_distributions(Report& report);
void measure_capture(Report& report);
void measure_visibility(Report& report);
void measure_traces(Report& report);

}  // namespace burnish::bench
