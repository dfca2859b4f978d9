// The polar cut as a panel: half a disk, one line per model.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "burnish/plot/brdf_plot.hpp"
#include "core/constants.hpp"
#include "plot/axes.hpp"
#include "plot/curves_together.hpp"

namespace burnish::plot {
namespace {

// Degrees from the normal. Beyond them an unbounded model would set the scale of all models.
constexpr double kSeen = 85 * kDegree;
constexpr double kSide = 30, kTop = 24, kBelow = 40;

struct Half {
    Point origin;
    double radius;
    Point at(double theta, double r) const {
        return {origin.x + radius * r * std::sin(theta), origin.y - radius * r * std::cos(theta)};
    }
};

Half half_of(const Box& box) {
    const double radius = std::floor((box.width - 2 * kSide) / 2);
    return {{std::round(box.x + box.width / 2), std::round(box.y + kTop + radius)}, radius};
}

void draw_arc(Canvas& canvas, const Half& half, double r, const Stroke& stroke) {
    std::vector<Point> arc;
    for (int i = 0; i <= 90; ++i) arc.push_back(half.at((2 * i - 90) * kDegree, r));
    canvas.polyline(arc, stroke);
}

void draw_polar_grid(Canvas& canvas, const Half& half, const Scale& scale) {
    const Stroke faint{.color = kFaint, .width = 0.8};
    TextStyle number = kAxisNumber;
    number.align = Align::center;
    number.stand = Stand::top;
    for (int angle = -90; angle <= 90; angle += 15)
        canvas.line(half.origin, half.at(angle * kDegree, 1), faint);
    for (const Tick& tick : scale.ticks(4)) {
        if (tick.label.empty() || tick.position < 0.02) continue;
        draw_arc(canvas, half, tick.position, faint);
        for (const double side : {-1.0, 1.0}) {
            const Point at = half.at(side * std::numbers::pi / 2, tick.position);
            canvas.line(at, {at.x, at.y + 4}, {.width = 0.8});
            canvas.text({at.x, at.y + 7}, tick.label, number);
        }
    }
    number.stand = Stand::middle;
    for (int angle = -90; angle <= 90; angle += 30) {
        if (angle == 90 || angle == -90) continue;
        const Point at = half.at(angle * kDegree, 1 + 13 / half.radius);
        canvas.text(at, std::to_string(std::abs(angle)) + "\u00b0", number);
    }
    draw_arc(canvas, half, 1, {.color = kInk, .width = 1});
    canvas.line(half.at(-std::numbers::pi / 2, 1), half.at(std::numbers::pi / 2, 1), {.width = 1});
}

// An arrow to the origin from the direction of the light, from outside the lobes.
void draw_light(Canvas& canvas, const Half& half, double incidence_deg) {
    const Rgb color = series_color(6);
    const double theta = -incidence_deg * kDegree;
    canvas.arrow(half.at(theta, 1.0), half.at(theta, 0.02),
                 {.color = color, .width = 1.6, .opacity = 0.85}, 10);
    canvas.line(half.origin, half.at(-theta, 1), {.color = color, .width = 1.1, .dash = {2, 4}});
    TextStyle style = kAxisNumber;
    style.color = color;
    style.bold = true;
    style.halo = kWhite;
    style.stand = Stand::middle;
    style.align = Align::left;
    const Point at = half.at(theta, 0.93);
    canvas.text({at.x + 8, at.y}, "light", style);
}

// The curve from the origin and back to it.
std::vector<Point> placed(const Half& half, const Scale& scale, const std::vector<Point>& curve) {
    std::vector<Point> line;
    line.push_back(half.origin);
    for (const Point& p : curve) {
        const double r = scale.position(p.y);
        // 4: beyond the rim, which cuts the line, and within cairo's range of coordinates.
        line.push_back(half.at(p.x, r > 0 ? std::min(r, 4.0) : 0.0));
    }
    line.push_back(half.origin);
    return line;
}

void draw_polar_curves(Canvas& canvas, const Half& half, const Scale& scale,
                       const std::vector<Series>& curves) {
    std::vector<DrawnCurve> drawn;
    for (const Series& curve : curves)
        drawn.push_back({{placed(half, scale, curve.points)},
                         {.color = curve.color, .width = curve.width, .dash = curve.dash}});
    const auto clip = canvas.clip_to_circle(half.origin, half.radius);
    draw_curves(canvas, drawn, [&](Point p) {
        const double r = std::hypot(p.x - half.origin.x, p.y - half.origin.y);
        // All curves meet at the origin and on the horizon, as all that is 0 does.
        return r > 6 && r <= half.radius && p.y < half.origin.y - 1.5;
    });
}

// "leaves the plot: ward, to 12; ..."
std::string beyond_rim(const std::vector<Series>& curves, double rim) {
    std::string text;
    for (const Series& curve : curves) {
        double top = 0;
        for (const Point& p : curve.points) top = std::max(top, p.y);
        // 1.01: a curve that only touches the rim is not cut.
        if (top > 1.01 * rim)
            text += (text.empty() ? "leaves the plot: " : "; ") + curve.label + ", to " +
                    number_text(top, 2);
    }
    return text;
}

double largest_within(const std::vector<Series>& curves, double angle) {
    double most = 0;
    for (const Series& curve : curves)
        for (const Point& p : curve.points)
            if (std::abs(p.x) <= angle) most = std::max(most, p.y);
    return most;
}

}  // namespace

Panel polar_curves_panel(const PolarCurves& plot, std::string title, double width) {
    const double seen = std::max(kSeen, std::abs(plot.light_deg.value_or(0)) * kDegree);
    const Scale scale = scale_to(plot.kind, plot.high.value_or(largest_within(plot.curves, seen)));
    Panel panel{
        std::move(title), width, std::floor((width - 2 * kSide) / 2) + kTop + kBelow, {}, {}};
    panel.note = beyond_rim(plot.curves, scale.high);
    panel.draw = [plot, scale](Canvas& canvas, const Box& box) {
        const Half half = half_of(box);
        draw_polar_grid(canvas, half, scale);
        if (plot.light_deg) draw_light(canvas, half, *plot.light_deg);
        draw_polar_curves(canvas, half, scale, plot.curves);
        TextStyle label = kAxisLabel;
        label.align = Align::center;
        label.stand = Stand::top;
        canvas.text({half.origin.x, half.origin.y + 23},
                    std::string("f [1/sr], ") +
                        std::string(scale_names()[static_cast<std::size_t>(scale.kind)]),
                    label);
        canvas.mark_area("polar", {half.origin.x - half.radius, half.origin.y - half.radius,
                                   2 * half.radius, half.radius});
    };
    return panel;
}

Panel polar_panel(const PolarPlot& plot, std::string title, double width) {
    const double cut = plot.cut_deg.value_or(plot.azimuth_deg);
    const Direction<double> wi = incident(plot.incidence_deg, plot.azimuth_deg);
    PolarCurves curves;
    for (std::size_t i = 0; i < plot.subjects.size(); ++i)
        curves.curves.push_back(
            series(i, plot.subjects[i].label, polar_cut(plot.subjects[i], wi, cut)));
    curves.kind = plot.kind;
    curves.high = plot.high.value_or(
        largest_within(curves.curves, std::max(kSeen, plot.incidence_deg * kDegree)));
    // The light lies in the cut, on the one side or on the other.
    const double across =
        std::sin((plot.azimuth_deg - cut) * kDegree) * std::sin(plot.incidence_deg * kDegree);
    if (std::abs(across) < 1e-6)
        curves.light_deg = std::cos((plot.azimuth_deg - cut) * kDegree) < 0 ? -plot.incidence_deg
                                                                            : plot.incidence_deg;
    return polar_curves_panel(curves, std::move(title), width);
}

}  // namespace burnish::plot
