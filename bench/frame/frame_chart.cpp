// The result of `burnish bench frame` as a bar chart: a panel a case, two panels a row. The bars of
// one light share one scale over all panels; image light and tables cost many times as much and
// have their own.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/frame/frame_cost.hpp"
#include "bench/frame/frame_papers.hpp"
#include "core/version.hpp"
#include "gpu/draw/renderer.hpp"

namespace burnish {

namespace {

constexpr double kPanelWidth = 600, kLabels = 150, kValues = 84, kMargin = 24;
constexpr double kRow = 23, kBar = 15, kTitle = 34, kAxis = 30, kHead = 96, kGap = 30;
constexpr const char* kInk = "#24292f";
constexpr const char* kFaint = "#d0d4d9";
constexpr const char* kPaperInk = "#c2185b";

struct Bar {
    std::string_view name;
    Estimate value;
    std::optional<double> paper;
    const char* color;
    bool unit;  // what the others are compared to, exact
};

struct Panel {
    std::string title;
    std::vector<Bar> one_light, image_light, tabulated;
};

struct Scale {
    double most = 1;  // value at the right end
    double step = 1;  // between ticks
    double x(double value) const {
        const double share = std::clamp(value / most, 0.0, 1.0);
        return kLabels + share * (kPanelWidth - kLabels - kValues);
    }
};

std::string escaped(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '&') {
            out += "&amp;";
        } else if (c == '<') {
            out += "&lt;";
        } else if (static_cast<unsigned char>(c) < 0x20) {
            out += ' ';
        } else {
            out += c;
        }
    }
    return out;
}

const char* color_of(const Technique& technique) {
    if (technique.lit_by_image()) return "#d55e00";
    if (technique.tabulated()) return "#7b5ea7";
    if (technique.variant != gpu::ShadingVariant::full) return "#8b929b";
    return technique.method == Method::normal_map ? "#0072b2" : "#1b8a6b";
}

std::vector<Bar>& bars_for(Panel& panel, const Technique& technique) {
    if (technique.lit_by_image()) return panel.image_light;
    return technique.tabulated() ? panel.tabulated : panel.one_light;
}

Panel panel_of(const FrameCaseCost& of, Clock clock) {
    Panel panel;
    panel.title =
        fmt::format("{} x {}, {} triangles", of.asked.width, of.asked.height, of.triangles);
    for (const TechniqueCost& cost : of.costs) {
        const Estimated value = of.against_gouraud(cost, clock);
        if (!value) continue;
        bars_for(panel, cost.technique)
            .push_back({cost.technique.name, *value, k12_cost(cost.technique.name),
                        color_of(cost.technique), cost.samples.empty()});
    }
    return panel;
}

// Ends at a tick of 1, 2 or 5 times a power of ten, three to eight of them.
Scale scale_for(double largest) {
    Scale scale;
    const double rough = std::max(largest, 1e-3) / 5.0;
    const double power = std::pow(10.0, std::floor(std::log10(rough)));
    for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
        scale.step = factor * power;
        if (scale.step >= rough) break;
    }
    scale.most = scale.step * std::ceil(largest / scale.step);
    return scale;
}

template <typename Members>
Scale shared_scale(const std::vector<Panel>& panels, Members bars) {
    double largest = 0;
    for (const Panel& panel : panels)
        for (const Bar& bar : panel.*bars)
            largest =
                std::max({largest, bar.value.median + bar.value.spread, bar.paper.value_or(0.0)});
    return scale_for(largest);
}

std::string text_at(double x, double y, const char* anchor, double size, std::string_view words,
                    const char* color = kInk) {
    return fmt::format(
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"{}\" "
        "fill=\"{}\">{}</text>\n",
        x, y, anchor, size, color, escaped(words));
}

std::string line(double x1, double y1, double x2, double y2, const char* color, double width) {
    return fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" "
        "stroke-width=\"{}\"/>\n",
        x1, y1, x2, y2, color, width);
}

std::string diamond(double x, double y) {
    return fmt::format("<path d=\"M{:.1f} {:.1f}l5 -5l5 5l-5 5z\" fill=\"{}\" stroke=\"#fff\"/>\n",
                       x - 5, y, kPaperInk);
}

std::string draw_bar(const Bar& bar, const Scale& scale, double y) {
    const double middle = y + kRow / 2, left = scale.x(0);
    const double end = scale.x(bar.value.median);
    std::string svg = text_at(left - 8, middle + 4, "end", 12.5, bar.name);
    svg += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\"/>\n", left,
        middle - kBar / 2, end - left, kBar, bar.color);
    const double low = scale.x(bar.value.median - bar.value.spread);
    const double high = scale.x(bar.value.median + bar.value.spread);
    if (!bar.unit) {
        svg += line(low, middle, high, middle, kInk, 1.2);
        for (const double x : {low, high}) svg += line(x, middle - 3, x, middle + 3, kInk, 1.2);
    }
    double after = high;
    if (bar.paper) {
        svg += diamond(scale.x(*bar.paper), middle);
        after = std::max(after, scale.x(*bar.paper) + 5);
    }
    const std::string value =
        bar.unit ? "1" : fmt::format("{:.2f} ± {:.2f}", bar.value.median, bar.value.spread);
    return svg + text_at(after + 7, middle + 4, "start", 12, value);
}

// Grid, bars and the numbers below; returns the height used.
double draw_bars(const std::vector<Bar>& bars, const Scale& scale, double y, std::string& svg) {
    const double height = kRow * static_cast<double>(bars.size());
    for (double tick = 0; tick <= scale.most * (1 + 1e-9); tick += scale.step) {
        svg += line(scale.x(tick), y, scale.x(tick), y + height, kFaint, 1);
        svg += text_at(scale.x(tick), y + height + 15, "middle", 11, fmt::format("{:g}", tick));
    }
    for (std::size_t i = 0; i < bars.size(); ++i)
        svg += draw_bar(bars[i], scale, y + kRow * static_cast<double>(i));
    return height + kAxis;
}

double height_of(const Panel& panel) {
    double height = kTitle;
    for (const auto* bars : {&panel.one_light, &panel.image_light, &panel.tabulated})
        if (!bars->empty()) height += kRow * static_cast<double>(bars->size()) + kAxis;
    return height;
}

std::string draw_panel(const Panel& panel, const Scale& one_light, const Scale& image_light,
                       const Scale& tabulated) {
    std::string svg = text_at(kLabels, 18, "start", 14, panel.title);
    double y = kTitle;
    if (!panel.one_light.empty()) y += draw_bars(panel.one_light, one_light, y, svg);
    if (!panel.image_light.empty()) y += draw_bars(panel.image_light, image_light, y, svg);
    if (!panel.tabulated.empty()) draw_bars(panel.tabulated, tabulated, y, svg);
    return svg;
}

std::string head(const FrameCost& cost) {
    std::string svg = text_at(0, 22, "start", 19, "What a frame costs, Gouraud shading = 1");
    svg += text_at(0, 43, "start", 12.5,
                   fmt::format("{}, {}; {} threads of {}", cost.device,
                               cost.timer.usable ? "device time" : "wall clock", cost.threads,
                               cost.processor));
    svg += text_at(0, 61, "start", 12.5,
                   fmt::format("medians of {} interleaved rounds with half the distance between "
                               "the quartiles; {}",
                               cost.rounds, cost.date.substr(0, 10)));
    svg += diamond(5, 77) +
           text_at(16, 81, "start", 12.5, "K12 Table I, on a Radeon HD 5670", kPaperInk);
    return svg;
}

}  // namespace

std::string frame_cost_svg(const FrameCost& cost) {
    std::vector<Panel> panels;
    for (const FrameCaseCost& of : cost.cases) panels.push_back(panel_of(of, cost.clock()));
    const Scale one_light = shared_scale(panels, &Panel::one_light);
    const Scale image_light = shared_scale(panels, &Panel::image_light);
    const Scale tabulated = shared_scale(panels, &Panel::tabulated);

    const std::size_t columns = panels.size() > 1 ? 2 : 1;
    std::string body;
    double y = kMargin + kHead, row_height = 0;
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const std::size_t column = i % columns;
        if (column == 0 && i > 0) y += row_height + kGap;
        row_height = std::max(column == 0 ? 0.0 : row_height, height_of(panels[i]));
        body += fmt::format("<g transform=\"translate({:.1f} {:.1f})\">\n{}</g>\n",
                            kMargin + static_cast<double>(column) * (kPanelWidth + kGap), y,
                            draw_panel(panels[i], one_light, image_light, tabulated));
    }
    const double width = 2 * kMargin + static_cast<double>(columns) * (kPanelWidth + kGap) - kGap;
    const double height = y + row_height + kMargin;
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
        "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"DejaVu Sans, Helvetica, sans-serif\">\n"
        "<title>What a frame costs</title>\n<desc>burnish {2}: {3}</desc>\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n"
        "<g transform=\"translate({4:.0f} {4:.0f})\">\n{5}</g>\n{6}</svg>\n",
        width, height, version(), escaped(cost.command), kMargin, head(cost), body);
}

}  // namespace burnish
