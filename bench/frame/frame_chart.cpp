// Draws the result of `burnish bench frame` as bars: a row of panels for each case, with one panel
// each for one light, image light and tables, whose costs differ by orders of magnitude. Panels of
// one kind share a scale over all cases.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "bench/frame/frame_cost.hpp"
#include "bench/frame/frame_papers.hpp"
#include "burnish/plot/panels.hpp"
#include "burnish/renderer.hpp"
#include "burnish/version.hpp"

namespace burnish {
namespace {

constexpr double kPanelWidth = 480;
constexpr plot::Rgb kPaperColor{0.76, 0.09, 0.36};

enum Kind { one_light, image_light, tabulated, kinds };
constexpr std::array<const char*, kinds> kAxisLabels = {
    "one light, Gouraud = 1", "image light, Gouraud = 1", "tables, Gouraud = 1"};

Kind kind_of(const Technique& technique) {
    if (technique.lit_by_image()) return image_light;
    return technique.tabulated() ? tabulated : one_light;
}

plot::Rgb color_of(const Technique& technique) {
    if (technique.lit_by_image()) return {0.84, 0.37, 0.0};
    if (technique.tabulated()) return {0.48, 0.37, 0.65};
    if (technique.variant != gpu::ShadingVariant::full) return {0.55, 0.57, 0.6};
    if (technique.method == Method::normal_map) return {0.0, 0.45, 0.7};
    return {0.11, 0.54, 0.42};
}

using Panels = std::array<std::vector<plot::Bar>, kinds>;

plot::Bar bar_of(const TechniqueCost& cost, const Estimate& value) {
    plot::Bar bar{
        std::string(cost.technique.name), value.median, value.spread, "", color_of(cost.technique),
        k12_cost(cost.technique.name)};
    // Gouraud shading is the unit: it has no samples of its own.
    bar.text =
        cost.samples.empty() ? "1" : fmt::format("{:.2f} ± {:.2f}", value.median, value.spread);
    if (cost.samples.empty()) bar.spread = 0;
    return bar;
}

Panels bars_of(const FrameCaseCost& of, Clock clock) {
    Panels bars;
    for (const TechniqueCost& cost : of.costs)
        if (const Estimated value = of.against_gouraud(cost, clock))
            bars[kind_of(cost.technique)].push_back(bar_of(cost, *value));
    return bars;
}

std::string caption(const FrameCost& cost) {
    return fmt::format(
        "{}, {}; {} threads of {}. Medians of {} interleaved rounds with half the distance between "
        "the quartiles; {}. Made by Burnish {}.",
        cost.device, cost.timer.usable ? "device time" : "wall clock", cost.threads, cost.processor,
        cost.rounds, cost.date.substr(0, 10), version());
}

}  // namespace

plot::Figure frame_cost_figure(const FrameCost& cost) {
    std::vector<Panels> cases;
    std::array<double, kinds> most{};  // values at the right ends of the axes, for each kind
    for (const FrameCaseCost& of : cost.cases) {
        cases.push_back(bars_of(of, cost.clock()));
        for (std::size_t kind = 0; kind < kinds; ++kind)
            for (const plot::Bar& bar : cases.back()[kind])
                most[kind] = std::max({most[kind], bar.value + bar.spread, bar.mark.value_or(0.0)});
    }
    plot::Figure figure;
    figure.title = "What a frame costs, Gouraud shading = 1";
    figure.legend = {{"diamonds: K12 Table I, on a Radeon HD 5670", kPaperColor}};
    figure.caption = caption(cost);
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const FrameCaseCost& of = cost.cases[i];
        const std::string title =
            fmt::format("{} x {}, {} triangles", of.asked.width, of.asked.height, of.triangles);
        plot::PanelRow& row = figure.rows.emplace_back();
        for (std::size_t kind = 0; kind < kinds; ++kind)
            if (!cases[i][kind].empty())
                row.panels.push_back(plot::bar_panel(
                    {std::move(cases[i][kind]), kAxisLabels[kind], most[kind], kPaperColor}, title,
                    kPanelWidth));
    }
    return figure;
}

std::string frame_cost_svg(const FrameCost& cost) {
    return plot::figure_svg(frame_cost_figure(cost), {{"burnish:command", cost.command},
                                                      {"burnish:version", std::string(version())}});
}

}  // namespace burnish
