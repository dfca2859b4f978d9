#include "burnish/plot/panels.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "plot/axes.hpp"
#include "plot/curves_together.hpp"

namespace burnish::plot {
namespace {

Point placed(const LinePlot& plot, const Box& box, Point p) {
    // Points far outside are moved nearer, still outside: cairo's coordinates overflow at 2^23.
    const double x = std::clamp(plot.x.scale.position(p.x), -8.0, 9.0);
    const double y = std::clamp(plot.y.scale.position(p.y), -8.0, 9.0);
    return {box.x + x * box.width, box.bottom() - y * box.height};
}

bool is_drawn(Point p) {
    return !std::isnan(p.x) && !std::isnan(p.y);
}

DrawnCurve drawn_curve(const LinePlot& plot, const Series& line, const Box& box) {
    DrawnCurve curve{{}, {.color = line.color, .width = line.width, .dash = line.dash}};
    std::vector<Point> piece;
    const auto flush = [&] {
        if (piece.size() > 1) curve.pieces.push_back(std::move(piece));
        piece.clear();
    };
    for (const Point& p : line.points) {
        if (is_drawn(p)) {
            piece.push_back(placed(plot, box, p));
        } else {
            flush();
        }
    }
    flush();
    return curve;
}

void draw_lines(Canvas& canvas, const LinePlot& plot, const Box& box) {
    std::vector<DrawnCurve> curves;
    for (const Series& line : plot.lines) curves.push_back(drawn_curve(plot, line, box));
    const auto clip = canvas.clip_to(box);
    draw_curves(canvas, curves, [&](Point p) {
        // 1.5: within a stroke's width of the axis, where all that is 0 lies.
        return p.x >= box.x && p.x <= box.right() && p.y >= box.y && p.y < box.bottom() - 1.5;
    });
}

// Marks the place where a line leaves at the top by a small arrow in its color, just inside the
// box. `others`: the number of lines marked before, whose marks stand beside this one. True when
// marked.
bool mark_cut(Canvas& canvas, const LinePlot& plot, const Series& line, const Box& box,
              int others) {
    // 1.002: a line that only touches the top is not cut.
    const auto is_cut = [&](const Point& p) {
        return is_drawn(p) && plot.y.scale.position(p.y) > 1.002;
    };
    const auto highest = std::max_element(
        line.points.begin(), line.points.end(), [&](const Point& a, const Point& b) {
            return (is_cut(a) ? a.y : -INFINITY) < (is_cut(b) ? b.y : -INFINITY);
        });
    if (highest == line.points.end() || !is_cut(*highest)) return false;
    const double x =
        std::clamp(placed(plot, box, *highest).x - 10.0 * others, box.x + 5, box.right() - 5);
    canvas.arrow({x, box.y + 12}, {x, box.y + 1}, {.color = line.color, .width = 1.5}, 7);
    TextStyle style = kAxisNumber;
    style.size = 10.5;
    style.color = line.color;
    style.stand = Stand::top;
    style.align = x > box.center().x ? Align::right : Align::left;
    style.halo = kWhite;
    canvas.text({x + (style.align == Align::right ? -7 : 7), box.y + 4 + 15.0 * others},
                "to " + number_text(highest->y, 2), style);
    return true;
}

void draw_marks(Canvas& canvas, const LinePlot& plot, const Box& box) {
    TextStyle style = kAxisNumber;
    style.color = kGray;
    if (plot.level) {
        const double y = placed(plot, box, {plot.x.scale.low, plot.level->first}).y;
        canvas.line({box.x, y}, {box.right(), y}, {.color = kInk, .width = 1.1, .dash = {5, 3}});
        style.stand = Stand::bottom;
        canvas.text({box.x + 5, y - 2}, plot.level->second, style);
    }
    if (plot.place) {
        const double x = placed(plot, box, {plot.place->first, plot.y.scale.low}).x;
        canvas.line({x, box.y}, {x, box.bottom()}, {.color = kGray, .width = 1, .dash = {2, 3}});
        style.stand = Stand::top;
        const bool right = x > box.center().x;
        style.align = right ? Align::right : Align::left;
        canvas.text({x + (right ? -5 : 5), box.y + 5}, plot.place->second, style);
    }
}

void draw_line_plot(Canvas& canvas, const LinePlot& plot, const Box& outer) {
    const Box box = outer.inset(kAxisLeft, 8, kAxisRight, kAxisBelow);
    draw_x_axis(canvas, box, plot.x.scale, plot.x.label, true);
    draw_y_axis(canvas, box, plot.y.scale, plot.y.label, true);
    draw_marks(canvas, plot, box);
    draw_lines(canvas, plot, box);
    int marked = 0;
    for (const Series& line : plot.lines)
        if (mark_cut(canvas, plot, line, box, marked)) ++marked;
    canvas.frame(box, {.color = kInk, .width = 0.8});
    canvas.mark_area("lines", box);
}

constexpr double kBarRow = 26, kBarHeight = 15;

std::string text_behind(const Bar& bar) {
    return bar.text.empty() ? number_text(bar.value) : bar.text;
}

void draw_diamond(Canvas& canvas, Point center, const Rgb& color) {
    constexpr double kArm = 5;
    const Point corners[] = {{center.x - kArm, center.y},
                             {center.x, center.y - kArm},
                             {center.x + kArm, center.y},
                             {center.x, center.y + kArm},
                             {center.x - kArm, center.y}};
    canvas.polygon(corners, color);
    canvas.polyline(corners, {.color = kWhite, .width = 1});
}

// The bar in its row of the axes' box, whose middle is `y`.
void draw_bar(Canvas& canvas, const BarPlot& plot, const Bar& bar, const Scale& scale,
              const Box& box, double y) {
    TextStyle label = kAxisLabel, number = kAxisNumber;
    label.align = Align::right;
    label.stand = number.stand = Stand::middle;
    const auto width_of = [&](double value) { return scale.position(value) * box.width; };
    const double length = std::clamp(width_of(bar.value), 0.0, box.width);
    const Box area{box.x, y - kBarHeight / 2, length, kBarHeight};
    canvas.rectangle(area, bar.color);
    double end = length;
    if (bar.spread > 0) {
        const double spread = width_of(bar.spread);
        canvas.line({box.x + length - spread, y}, {box.x + length + spread, y},
                    {.color = kInk, .width = 1.4});
        end += spread;
    }
    if (bar.mark) {
        const double place = std::clamp(width_of(*bar.mark), 0.0, box.width);
        draw_diamond(canvas, {box.x + place, y}, plot.mark_color);
        end = std::max(end, place + 5);
    }
    canvas.text({box.x - 8, y}, bar.label, label);
    canvas.text({box.x + end + 6, y}, text_behind(bar), number);
    canvas.mark_area("bar " + bar.label, area);
}

void draw_bars(Canvas& canvas, const BarPlot& plot, const Box& outer) {
    double label_width = 0, text_width = 0, most = plot.most;
    for (const Bar& bar : plot.bars) {
        label_width = std::max(label_width, canvas.text_width(bar.label, kAxisLabel));
        text_width = std::max(text_width, canvas.text_width(text_behind(bar), kAxisNumber));
        if (plot.most > 0) continue;
        for (const double value : {bar.value + bar.spread, bar.mark.value_or(0)})
            if (std::isfinite(value)) most = std::max(most, value);
    }
    const Box box = outer.inset(label_width + 12, 2, text_width + 14, kAxisBelow);
    const Scale scale = scale_to(ScaleKind::linear, most);
    draw_x_axis(canvas, box, scale, plot.axis_label, true);
    canvas.mark_area("bars", box);
    for (std::size_t i = 0; i < plot.bars.size(); ++i)
        draw_bar(canvas, plot, plot.bars[i], scale, box,
                 box.y + (static_cast<double>(i) + 0.5) * kBarRow);
    canvas.line({box.x, box.y}, {box.x, box.bottom()}, {.width = 0.8});
}

}  // namespace

Panel picture_panel(const Image& image, std::string title, double width) {
    if (width <= 0) width = image.width / 2.0;
    Panel panel;
    panel.title = std::move(title);
    panel.width = width;
    panel.height = image.width > 0 ? width * image.height / image.width : width;
    // Shared, because a panel is copied with its figure.
    panel.draw = [kept = std::make_shared<const Image>(image)](Canvas& canvas, const Box& box) {
        canvas.image(box, *kept);
        canvas.mark_area("picture", box);
    };
    return panel;
}

Series series(std::size_t index, std::string label, std::vector<Point> points) {
    return {std::move(label), std::move(points), series_color(index), series_dash(index)};
}

std::vector<LegendEntry> legend_of(const std::vector<Series>& all) {
    std::vector<LegendEntry> legend;
    legend.reserve(all.size());
    for (const Series& one : all) legend.push_back({one.label, one.color, one.dash});
    return legend;
}

Panel line_panel(LinePlot plot, std::string title, double width, double height) {
    Panel panel{std::move(title), width, height, {}, {}};
    panel.middle = (kAxisLeft - kAxisRight) / 2;
    panel.draw = [plot = std::move(plot)](Canvas& canvas, const Box& box) {
        draw_line_plot(canvas, plot, box);
    };
    return panel;
}

Panel bar_panel(BarPlot plot, std::string title, double width) {
    const double height = kBarRow * static_cast<double>(plot.bars.size()) + 2 + kAxisBelow;
    Panel panel{std::move(title), width, height, {}, {}};
    panel.draw = [plot = std::move(plot)](Canvas& canvas, const Box& box) {
        draw_bars(canvas, plot, box);
    };
    return panel;
}

}  // namespace burnish::plot
