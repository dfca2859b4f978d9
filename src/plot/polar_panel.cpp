// The polar cut as a panel: half a disk, one line per model.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "burnish/plot/brdf_plot.hpp"
#include "core/constants.hpp"
#include "plot/axes.hpp"

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

void draw_curve(Canvas& canvas, const Half& half, const Scale& scale,
                const std::vector<Point>& curve, const Stroke& stroke) {
    std::vector<Point> line;
    line.push_back(half.origin);
    for (const Point& p : curve) {
        const double r = scale.position(p.y);
        // 4: beyond the rim, which cuts the line, and within cairo's range of coordinates.
        line.push_back(half.at(p.x, r > 0 ? std::min(r, 4.0) : 0.0));
    }
    line.push_back(half.origin);
    canvas.polyline(line, stroke);
}

}  // namespace

Panel polar_panel(const PolarPlot& plot, std::string title, double width) {
    const double cut = plot.cut_deg.value_or(plot.azimuth_deg);
    const Direction<double> wi = incident(plot.incidence_deg, plot.azimuth_deg);
    std::vector<std::vector<Point>> curves;
    double most = 0;
    const double seen = std::max(kSeen, plot.incidence_deg * kDegree);
    for (const BrdfSubject& subject : plot.subjects) {
        curves.push_back(polar_cut(subject, wi, cut));
        for (const Point& p : curves.back())
            if (std::abs(p.x) <= seen) most = std::max(most, p.y);
    }
    const Scale scale = scale_to(plot.kind, plot.high.value_or(most));
    std::string cut_off;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        double top = 0;
        for (const Point& p : curves[i]) top = std::max(top, p.y);
        if (top > 1.01 * scale.high)
            cut_off += (cut_off.empty() ? "leaves the plot: " : "; ") + plot.subjects[i].label +
                       ", to " + number_text(top, 2);
    }
    // The light lies in the cut, on the one side or on the other.
    const double across =
        std::sin((plot.azimuth_deg - cut) * kDegree) * std::sin(plot.incidence_deg * kDegree);
    const bool in_plane = std::abs(across) < 1e-6;
    const double side = std::cos((plot.azimuth_deg - cut) * kDegree) < 0 ? -1 : 1;
    Panel panel{
        std::move(title), width, std::floor((width - 2 * kSide) / 2) + kTop + kBelow, {}, {}};
    panel.note = cut_off;
    panel.draw = [=, incidence = plot.incidence_deg](Canvas& canvas, const Box& box) {
        const Half half = half_of(box);
        draw_polar_grid(canvas, half, scale);
        if (in_plane) draw_light(canvas, half, side * incidence);
        {
            const auto clip = canvas.clip_to_circle(half.origin, half.radius);
            for (std::size_t i = 0; i < curves.size(); ++i)
                draw_curve(canvas, half, scale, curves[i],
                           {.color = series_color(i), .width = 1.8, .dash = series_dash(i)});
        }
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

}  // namespace burnish::plot
