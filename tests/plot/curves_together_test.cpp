// Curves that lie on one another: each color is seen.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "burnish/plot/brdf_plot.hpp"
#include "burnish/plot/figure.hpp"
#include "burnish/plot/mdf_plot.hpp"
#include "burnish/plot/panels.hpp"

namespace burnish::plot {
namespace {

// Pixels of the data area in exactly the color of a series, which only the middle of a stroke has.
std::size_t pixels_of(const DrawnFigure& drawn, std::size_t series) {
    const Box box = drawn.areas.at(0).box;
    const Rgb color = series_color(series);
    std::size_t count = 0;
    for (int y = static_cast<int>(2 * box.y); y < static_cast<int>(2 * box.bottom()); ++y)
        for (int x = static_cast<int>(2 * box.x); x < static_cast<int>(2 * box.right()); ++x) {
            const float* p = drawn.image.at(x, y);
            // 0.01: colors have 8 bits.
            count += std::abs(static_cast<double>(p[0]) - color.r) < 0.01 &&
                     std::abs(static_cast<double>(p[1]) - color.g) < 0.01 &&
                     std::abs(static_cast<double>(p[2]) - color.b) < 0.01;
        }
    return count;
}

DrawnFigure drawn(Panel panel) {
    Figure figure;
    figure.rows = {{"", {std::move(panel)}}};
    return draw_figure(figure, 2);
}

using Function = double (*)(double);

DrawnFigure lines(std::initializer_list<Function> functions) {
    LinePlot plot;
    plot.x = {"x", {ScaleKind::linear, 0, 1}};
    plot.y = {"y", {ScaleKind::linear, 0, 1}};
    for (const Function f : functions) {
        std::vector<Point> points;
        for (int i = 0; i <= 50; ++i) points.push_back({i / 50.0, f(i / 50.0)});
        plot.lines.push_back(series(plot.lines.size(), "", points));
    }
    return drawn(line_panel(std::move(plot), ""));
}

double bump(double x) {
    return 0.2 + 0.6 * std::exp(-20 * (x - 0.5) * (x - 0.5));
}
double rising(double x) {
    return 0.1 + 0.8 * x;
}
double falling(double x) {
    return 0.9 - 0.8 * x;
}
double half_bump(double x) {
    return x < 0.5 ? bump(x) : 0.8;
}

// Each of n equal curves shows its n-th part of the line. 25 %: ends of dashes are blurred, and a
// line need not hold whole periods.
TEST(CurvesTogether, EqualCurvesTakeTurns) {
    const auto whole = static_cast<double>(pixels_of(lines({bump}), 0));
    const DrawnFigure two = lines({bump, bump});
    for (const std::size_t i : {0U, 1U})
        EXPECT_NEAR(static_cast<double>(pixels_of(two, i)), whole / 2, 0.25 * whole / 2) << i;
    const DrawnFigure three = lines({bump, bump, bump});
    for (const std::size_t i : {0U, 1U, 2U})
        EXPECT_NEAR(static_cast<double>(pixels_of(three, i)), whole / 3, 0.25 * whole / 3) << i;
}

// A crossing needs no dashes, nor do curves that are 0 together.
TEST(CurvesTogether, CurvesThatMeetInAPointStaySolid) {
    const auto alone = static_cast<double>(pixels_of(lines({falling}), 0));
    const DrawnFigure crossed = lines({rising, falling});
    EXPECT_GT(static_cast<double>(pixels_of(crossed, 0)), 0.95 * alone);
    EXPECT_GT(static_cast<double>(pixels_of(crossed, 1)), 0.98 * alone) << "the upper one is whole";
    const DrawnFigure zero = lines({[](double) { return 0.0; }, [](double) { return 0.0; }});
    EXPECT_EQ(pixels_of(zero, 0), 0u) << "the later one covers it, as an axis does";
}

TEST(CurvesTogether, DashesEndWhereTheCurvesPart) {
    const auto whole = static_cast<double>(pixels_of(lines({bump}), 0));
    const DrawnFigure parted = lines({bump, half_bump});
    // The first curve is seen in its own half, and in half of the common half.
    EXPECT_NEAR(static_cast<double>(pixels_of(parted, 0)), 0.75 * whole, 0.12 * whole);
    EXPECT_GT(pixels_of(parted, 1), 0u);
}

// Without a tilt every method leaves the lobe as it is: the profiles of all are one line.
TEST(CurvesTogether, ProfilesOfMethodsThatAgreeAreAllSeen) {
    std::vector<MdfSubject> subjects(4);
    const Method methods[] = {Method::none, Method::normal_map, Method::deform_smooth,
                              Method::follow_grain};
    const std::vector<std::string> labels(4);
    for (std::size_t i = 0; i < 4; ++i) {
        subjects[i].mdf = Mdf::ggx;
        subjects[i].p0 = subjects[i].p1 = 0.4;
        subjects[i].n = {0, 0, 1};
        subjects[i].method = methods[i];
    }
    const DrawnFigure figure =
        drawn(profile_panel(subjects, labels, ProfileLine::along_x,
                            scale_to(ScaleKind::linear, peak_of(subjects[0]).D), ""));
    for (std::size_t i = 0; i < 4; ++i) EXPECT_GT(pixels_of(figure, i), 100u) << i;
}

TEST(CurvesTogether, PolarCurvesTakeTurnsToo) {
    PolarCurves polar;
    std::vector<Point> points;
    for (int i = -85; i <= 85; ++i) {
        const double theta = i * std::numbers::pi / 180;
        points.push_back({theta, std::cos(theta)});
    }
    polar.curves = {series(0, "", points)};
    const auto whole = static_cast<double>(pixels_of(drawn(polar_curves_panel(polar, "")), 0));
    polar.curves.push_back(series(1, "", points));
    const DrawnFigure two = drawn(polar_curves_panel(polar, ""));
    for (const std::size_t i : {0U, 1U})
        EXPECT_NEAR(static_cast<double>(pixels_of(two, i)), whole / 2, 0.25 * whole / 2) << i;
}

}  // namespace
}  // namespace burnish::plot
