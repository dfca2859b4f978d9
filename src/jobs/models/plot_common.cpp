#include "jobs/models/plot_common.hpp"

#include <algorithm>

#include "burnish/error.hpp"
#include "burnish/f64.hpp"
#include "burnish/version.hpp"

namespace burnish {

std::pair<double, double> RoughnessPair::as_alpha() const {
    if (!exponents) return {x, y};
    return {f64::alpha_from_exponent(x), f64::alpha_from_exponent(y)};
}

std::pair<double, double> RoughnessPair::as_exponents() const {
    if (exponents) return {x, y};
    return {f64::exponent_from_alpha(x), f64::exponent_from_alpha(y)};
}

RoughnessPair roughness_pair(const ParameterValues& values) {
    require_one_roughness(values, true);
    const auto pair_of = [&](bool exponents, std::string_view x, std::string_view y) {
        RoughnessPair pair;
        pair.exponents = exponents;
        pair.x = values.real(values.is_set(x) ? x : y);
        pair.y = values.real(values.is_set(y) ? y : x);
        return pair;
    };
    if (values.is_set("alpha_x") || values.is_set("alpha_y"))
        return pair_of(false, "alpha_x", "alpha_y");
    if (values.is_set("e_x") || values.is_set("e_y")) return pair_of(true, "e_x", "e_y");
    return {};
}

void add_rows(plot::Figure& figure, const plot::PanelRow& row, std::size_t most) {
    for (std::size_t start = 0; start < row.panels.size(); start += most) {
        const std::size_t end = std::min(start + most, row.panels.size());
        plot::PanelRow part{row.label, {}, row.bar};
        for (std::size_t i = start; i < end; ++i) part.panels.push_back(row.panels[i]);
        figure.rows.push_back(std::move(part));
    }
}

void write_plot(plot::Figure figure, const PlotOutput& output, plot::Metadata parameters,
                const Progress& progress) {
    std::size_t count = 0, index = 0;
    for (const plot::PanelRow& row : figure.rows) count += row.panels.size();
    for (plot::PanelRow& row : figure.rows) {
        for (plot::Panel& panel : row.panels) {
            const double done = static_cast<double>(index++) / static_cast<double>(count);
            panel.draw = [draw = std::move(panel.draw), &progress, done](plot::Canvas& canvas,
                                                                         const plot::Box& box) {
                progress.step("draw", done);
                draw(canvas, box);
            };
        }
    }
    parameters["burnish:version"] = version();
    parameters["burnish:command"] = output.command;
    parameters["burnish:title"] = figure.title;
    plot::write_figure(figure, output.path, parameters, output.pixel_ratio);
    progress.step("draw", 1);
}

}  // namespace burnish
