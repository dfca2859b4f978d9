// Drawing of distributions on the disk and of their maps.
#include <algorithm>
#include <cmath>
#include <utility>

#include "burnish/plot/mdf_plot.hpp"
#include "plot/axes.hpp"
#include "plot/mdf_evaluator.hpp"

namespace burnish::plot {
namespace {

constexpr double kDiskLeft = 42, kDiskTop = 6, kDiskRight = 6, kDiskBelow = 27;
const Rgb kMoved = series_color(0);  // the warped grid
const Rgb kMove = series_color(1);   // arrows of moves

// The largest square inside the panel, at whole pixels.
Box disk_box(const Box& outer) {
    Box box = outer.inset(kDiskLeft, kDiskTop, kDiskRight, kDiskBelow);
    box.width = box.height = std::floor(std::min(box.width, box.height));
    return box;
}

Point on_disk(const Box& box, double x, double y) {
    return {box.x + (x + 1) / 2 * box.width, box.y + (1 - y) / 2 * box.height};
}

Point on_disk(const Box& box, Direction<double> h) {
    return on_disk(box, h.x, h.y);
}

void draw_disk_axes(Canvas& canvas, const Box& box) {
    const Scale scale{ScaleKind::linear, -1, 1};
    TextStyle number = kAxisNumber, label = kAxisLabel;
    number.align = label.align = Align::center;
    number.stand = label.stand = Stand::top;
    for (const double at : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
        const double p = scale.position(at);
        const double x = box.x + p * box.width, y = box.bottom() - p * box.height;
        canvas.line({x, box.bottom()}, {x, box.bottom() + 4}, {.width = 0.8});
        canvas.line({box.x - 4, y}, {box.x, y}, {.width = 0.8});
        if (at == 0.5 || at == -0.5) continue;
        const std::string text = at < 0 ? "\u22121" : at > 0 ? "1" : "0";
        canvas.text({x, box.bottom() + 7}, text, number);
        TextStyle side = kAxisNumber;
        side.align = Align::right;
        side.stand = Stand::middle;
        canvas.text({box.x - 8, y}, text, side);
    }
    canvas.text({box.center().x + box.width / 4, box.bottom() + 8}, "h_{x}", label);
    label.align = Align::right;
    label.stand = Stand::middle;
    canvas.text({box.x - 8, box.center().y - box.height / 4}, "h_{y}", label);
    canvas.frame(box, {.color = kFaint, .width = 0.8});
}

// Colors of the values; texels just outside take the value of the rim, which the circle cuts.
Image colored(const MdfSubject& subject, const Image& values, const Scale& scale) {
    const MdfEvaluator lobe(subject);
    const int side = values.width;
    Image image(side, side, 3, 1.0f);
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            const double x = 2 * (column + 0.5) / side - 1, y = 1 - 2 * (row + 0.5) / side;
            if (std::hypot(x, y) > 1 + 4.0 / side) continue;
            const float known = *values.at(column, row);
            // 1e-6: just inside the rim. On the rim D is 0 because h_z = 0.
            const double value = std::isnan(known)
                                     ? lobe.D(lifted(x * (1 - 1e-6) / std::hypot(x, y),
                                                     y * (1 - 1e-6) / std::hypot(x, y)))
                                     : static_cast<double>(known);
            const Rgb color = sequential_color(scale.position(value));
            image.at(column, row)[0] = static_cast<float>(color.r);
            image.at(column, row)[1] = static_cast<float>(color.g);
            image.at(column, row)[2] = static_cast<float>(color.b);
        }
    }
    return image;
}

// D over the disk with its axes; returns where the disk lies.
Box draw_disk(Canvas& canvas, const MdfSubject& subject, const Scale& scale, const Box& outer) {
    const Box box = disk_box(outer);
    draw_disk_axes(canvas, box);
    const int side = static_cast<int>(std::lround(box.width * canvas.pixel_ratio()));
    const double radius = box.width / 2;
    if (side > 0) {
        const auto clip = canvas.clip_to_circle(box.center(), radius);
        canvas.image(box, colored(subject, disk_values(subject, side), scale));
    }
    canvas.circle(box.center(), radius, {.color = kInk, .width = 1});
    const Footprint footprint = footprint_of(subject);
    // A lobe of less than six pixels across is not noticed, however bright.
    if (footprint.wide * radius < 3) {
        const Point at = on_disk(box, peak_of(subject).h);
        canvas.circle(at, 13, {.color = kBlack, .width = 3.4});
        canvas.circle(at, 13, {.color = kWhite, .width = 1.6});
    }
    canvas.mark_area("disk", box);
    return box;
}

void draw_point(Canvas& canvas, Point at, Point away, const std::string& label, const Rgb& color) {
    canvas.disk(at, 4.2, kWhite);
    canvas.disk(at, 3, color);
    const double length = std::max(std::hypot(away.x, away.y), 1e-9);
    TextStyle style{.size = 13, .bold = true, .color = color};
    style.align = Align::center;
    style.stand = Stand::middle;
    style.halo = kWhite;
    canvas.text({at.x + 14 * away.x / length, at.y + 14 * away.y / length}, label, style);
}

// The points of K11 Fig 7 for a point p of the original disk.
struct Concept {
    Point p, p_moved, C, C_moved, R;
    bool has_rim_point;  // only deformations have R
    Point away;          // direction for labels: away from the moves
};

Concept concept_of(const MdfSubject& subject, const Box& box, Point p) {
    const bool deforms =
        subject.method == Method::deform_linear || subject.method == Method::deform_smooth;
    const double r = std::hypot(p.x, p.y);
    const Direction<double> moved = forward(subject, lifted(p.x, p.y));
    Concept c{};
    c.p = on_disk(box, p.x, p.y);
    c.p_moved = on_disk(box, moved);
    c.C = on_disk(box, 0, 0);
    c.C_moved = on_disk(box, subject.n);
    c.has_rim_point = deforms && r > 1e-6;
    if (c.has_rim_point) c.R = on_disk(box, p.x / r, p.y / r);
    // Across the move of the centre, on the side of p.
    const double side = subject.n.x * p.y - subject.n.y * p.x < 0 ? -1 : 1;
    c.away = {-side * subject.n.y, -side * subject.n.x};
    if (std::hypot(c.away.x, c.away.y) < 1e-6) c.away = {0, -1};
    return c;
}

void draw_grid_line(Canvas& canvas, const Box& box, const std::vector<Direction<double>>& line,
                    const Stroke& stroke) {
    std::vector<Point> piece;
    const auto flush = [&] {
        if (piece.size() > 1) canvas.polyline(piece, stroke);
        piece.clear();
    };
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Direction<double> b = line[i];
        const bool visible = b.z >= 0;
        if (i > 0 && visible != (line[i - 1].z >= 0)) {
            // The line goes below the horizon here.
            const Direction<double> a = line[i - 1];
            const double u = a.z / (a.z - b.z);
            piece.push_back(on_disk(box, lifted(a.x + u * (b.x - a.x), a.y + u * (b.y - a.y))));
            if (!visible) flush();
        }
        if (visible) piece.push_back(on_disk(box, b));
    }
    flush();
}

void draw_moves(Canvas& canvas, const MdfSubject& subject, const Box& outer, Point p) {
    const Box box = disk_box(outer);
    draw_disk_axes(canvas, box);
    canvas.disk(box.center(), box.width / 2, {0.985, 0.985, 0.985});
    const std::vector<GridLine> grid = warped_grid(subject);
    for (const GridLine& line : grid)
        draw_grid_line(canvas, box, line.from, {.color = {0.80, 0.80, 0.83}, .width = 0.8});
    for (const GridLine& line : grid)
        draw_grid_line(canvas, box, line.to, {.color = kMoved, .width = 1.1, .opacity = 0.8});
    canvas.circle(box.center(), box.width / 2, {.color = kInk, .width = 1});
    const Concept c = concept_of(subject, box, p);
    const Stroke thread{.color = kInk, .width = 1, .dash = {4, 3}};
    if (c.has_rim_point) {
        canvas.line(c.C, c.R, thread);
        canvas.line(c.C_moved, c.R, thread);
    }
    const Stroke move{.color = kMove, .width = 2};
    canvas.arrow(c.C, c.C_moved, move, 9);
    canvas.arrow(c.p, c.p_moved, move, 9);
    const Point back{-c.away.x, -c.away.y};
    draw_point(canvas, c.C, back, "C", kInk);
    draw_point(canvas, c.C_moved, back, "C\u2032", kMove);
    draw_point(canvas, c.p, c.away, "p", kInk);
    draw_point(canvas, c.p_moved, c.away, "p\u2032", kMove);
    if (c.has_rim_point) {
        // Into the disk, along the rim's inward normal: outside are the axes.
        const Point inward{box.center().x - c.R.x, box.center().y - c.R.y};
        draw_point(canvas, c.R, {inward.x + 0.8 * inward.y, inward.y - 0.8 * inward.x}, "R", kInk);
    }
    canvas.mark_area("grid", box);
}

}  // namespace

Panel disk_panel(const MdfSubject& subject, const Scale& scale, std::string title, double side) {
    Panel panel{std::move(title), side, side, {}, {}};
    panel.middle = (kDiskLeft - kDiskRight) / 2;
    panel.height = side - kDiskLeft - kDiskRight + kDiskTop + kDiskBelow;
    panel.draw = [subject, scale](Canvas& canvas, const Box& outer) {
        const Box box = draw_disk(canvas, subject, scale, outer);
        canvas.cross(on_disk(box, subject.n), 6, {.color = kWhite, .width = 1.8}, kBlack);
    };
    return panel;
}

std::vector<Panel> grid_panels(const MdfSubject& subject, const Scale& scale, Point point,
                               double side) {
    MdfSubject original = subject;
    original.method = Method::none;
    const Panel blank = disk_panel(original, scale, "", side);
    std::vector<Panel> panels(3, blank);
    panels[0].title = "original D";
    panels[0].draw = [=](Canvas& canvas, const Box& outer) {
        const Box box = draw_disk(canvas, original, scale, outer);
        const Concept c = concept_of(subject, box, point);
        if (c.has_rim_point) canvas.line(c.C, c.R, {.color = kWhite, .width = 1, .dash = {4, 3}});
        draw_point(canvas, c.C, {-c.away.x, -c.away.y}, "C", kInk);
        draw_point(canvas, c.p, c.away, "p", kInk);
    };
    panels[1].title = std::string(name_of(subject.method));
    panels[1].draw = [=](Canvas& canvas, const Box& outer) {
        draw_moves(canvas, subject, outer, point);
    };
    panels[2].title = "moved D\u2032";
    panels[2].draw = [=](Canvas& canvas, const Box& outer) {
        const Box box = draw_disk(canvas, subject, scale, outer);
        const Concept c = concept_of(subject, box, point);
        draw_point(canvas, c.C_moved, {-c.away.x, -c.away.y}, "C\u2032", kMove);
        draw_point(canvas, c.p_moved, c.away, "p\u2032", kMove);
    };
    return panels;
}

}  // namespace burnish::plot
