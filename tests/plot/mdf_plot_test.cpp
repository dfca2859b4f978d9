// Plots of distributions against what they are said to show: pixels against colors of D, grids
// against the maps as K11 prints them, spikes that must not be lost.
#include "burnish/plot/mdf_plot.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "burnish/error.hpp"

namespace burnish::plot {
namespace {

using Vec = Direction<double>;

MdfSubject subject(Mdf mdf, double p0, double p1, Method method, double tilt, double azimuth) {
    return {mdf, p0, p1, method, tilted_normal(tilt, azimuth), Normalization::paper};
}

Box area_of(const DrawnFigure& drawn, const std::string& name) {
    for (const DataArea& area : drawn.areas)
        if (area.name == name) return area.box;
    ADD_FAILURE() << "no area " << name;
    return {};
}

DrawnFigure drawn(const Panel& panel, double ratio = 2) {
    Figure figure;
    figure.rows = {{"", {panel}}};
    return draw_figure(figure, ratio);
}

// The pixel that holds a point of the disk, and the half vector of its centre.
struct Pixel {
    const float* rgb;
    Vec h;
};
Pixel pixel_at(const DrawnFigure& d, const Box& disk, double hx, double hy) {
    const double side = disk.width * d.pixel_ratio;
    const int column = static_cast<int>((hx + 1) / 2 * side);
    const int row = static_cast<int>((1 - hy) / 2 * side);
    const double x = 2 * (column + 0.5) / side - 1, y = 1 - 2 * (row + 0.5) / side;
    return {d.image.at(static_cast<int>(disk.x * d.pixel_ratio) + column,
                       static_cast<int>(disk.y * d.pixel_ratio) + row),
            {x, y, std::sqrt(1 - x * x - y * y)}};
}

TEST(MdfPlot, PixelsOfTheDiskHaveTheColorOfD) {
    for (const ScaleKind kind : {ScaleKind::linear, ScaleKind::gamma, ScaleKind::log}) {
        for (const Method method :
             {Method::none, Method::normal_map, Method::deform_smooth, Method::follow_grain}) {
            const MdfSubject s = subject(Mdf::ashikhmin_shirley, 200, 10, method, 30, 40);
            const Scale scale = scale_to(kind, 7.48);
            const DrawnFigure d = drawn(disk_panel(s, scale, "title"));
            const Box disk = area_of(d, "disk");
            // Away from the cross at (0.38, 0.32).
            for (const auto& [x, y] : {std::pair{0.0, 0.02},
                                       {0.3, 0.1},
                                       {0.1, 0.5},
                                       {-0.6, 0.3},
                                       {0.25, 0.6},
                                       {0.02, -0.3}}) {
                const Pixel p = pixel_at(d, disk, x, y);
                const Rgb color = sequential_color(scale.position(s.D(p.h)));
                // A code of 8 bits, rounded.
                EXPECT_NEAR(static_cast<double>(p.rgb[0]), color.r, 0.51 / 255) << x << " " << y;
                EXPECT_NEAR(static_cast<double>(p.rgb[1]), color.g, 0.51 / 255) << x << " " << y;
                EXPECT_NEAR(static_cast<double>(p.rgb[2]), color.b, 0.51 / 255) << x << " " << y;
            }
        }
    }
}

TEST(MdfPlot, TheCrossIsAtThePerturbedNormal) {
    const MdfSubject s = subject(Mdf::ggx, 0.3, 0.3, Method::none, 50, 200);
    const DrawnFigure d = drawn(disk_panel(s, scale_to(ScaleKind::linear, 1e9), ""));
    const Box disk = area_of(d, "disk");
    const Pixel p = pixel_at(d, disk, s.n.x, s.n.y);  // all else is near black: the scale is high
    EXPECT_GT(p.rgb[0] + p.rgb[1] + p.rgb[2], 2.9f);
    const Pixel beside = pixel_at(d, disk, s.n.x + 0.15, s.n.y);
    EXPECT_LT(beside.rgb[0] + beside.rgb[1] + beside.rgb[2], 0.3f);
}

// The values of the shading tests' own entry points, through another path: mdf_values.
TEST(MdfPlot, NormalizationsAreThoseOfMdfEval) {
    const Vec h = tilted_normal(20, 70);
    for (const Mdf mdf : {Mdf::ashikhmin_shirley, Mdf::ward, Mdf::beckmann, Mdf::ggx}) {
        const double p = mdf == Mdf::ashikhmin_shirley ? 30 : 0.3;
        MdfSubject s = subject(mdf, p, p / 2, Method::deform_smooth, 30, 40);
        const MdfValues<double> values = mdf_values(mdf, p, p / 2, s.method, s.n, h);
        EXPECT_DOUBLE_EQ(s.D(h), values.D);
        s.normalization = Normalization::projected;
        EXPECT_DOUBLE_EQ(s.D(h), values.D_proj);
        s.normalization = Normalization::conserving;
        // The factor is multiplied in at another place: a rounding.
        EXPECT_NEAR(s.D(h), values.D_conserving, 1e-14 * values.D_conserving);
    }
}

// ---- grids
// ----------------------------------------------------------------------------------------

// |R p| / |R C| with R on the rim, where the ray from C through p meets it: by the quadratic, as
// K11 Fig 7 draws it.
double rim_fraction(Point p, Point C) {
    const double vx = p.x - C.x, vy = p.y - C.y;
    const double a = vx * vx + vy * vy, b = C.x * vx + C.y * vy, c = C.x * C.x + C.y * C.y - 1;
    const double s = (-b + std::sqrt(b * b - a * c)) / a;
    return 1 - 1 / s;
}

TEST(MdfPlot, GridOfDeformLinearIsK11Eq3) {
    const MdfSubject s = subject(Mdf::ashikhmin_shirley, 200, 10, Method::deform_linear, 50, 110);
    for (const GridLine& line : warped_grid(s)) {
        ASSERT_EQ(line.from.size(), line.to.size());
        for (std::size_t i = 0; i < line.from.size(); ++i) {
            const Vec m = line.from[i], h = line.to[i];
            if (std::hypot(m.x, m.y) < 1e-9) continue;
            const double share = rim_fraction({m.x, m.y}, {0, 0});
            EXPECT_NEAR(h.x, m.x + share * s.n.x, 1e-12);
            EXPECT_NEAR(h.y, m.y + share * s.n.y, 1e-12);
        }
    }
}

// deform-smooth is K11 Eq 5, which goes from the moved point back.
TEST(MdfPlot, GridOfDeformSmoothGoesBackByK11Eq5) {
    for (const double tilt : {10.0, 30.0, 60.0}) {
        const MdfSubject s =
            subject(Mdf::ashikhmin_shirley, 200, 10, Method::deform_smooth, tilt, 40);
        double worst = 0;
        for (const GridLine& line : warped_grid(s)) {
            for (std::size_t i = 0; i < line.from.size(); ++i) {
                const Vec m = line.from[i], h = line.to[i];
                if (std::hypot(h.x - s.n.x, h.y - s.n.y) < 1e-9) continue;
                const double share = rim_fraction({h.x, h.y}, {s.n.x, s.n.y});
                const double root = std::sqrt(std::max(share, 0.0));
                worst =
                    std::max(worst, std::hypot(h.x - root * s.n.x - m.x, h.y - root * s.n.y - m.y));
            }
        }
        // The root search halves at worst: 2^-18 of the disk; at the rim the square root of
        // rounding, 1e-8, is added.
        EXPECT_LT(worst, 1e-5) << tilt;
    }
}

TEST(MdfPlot, GridOfARotationKeepsAnglesAndTakesTheNormalAlong) {
    for (const Method method :
         {Method::gram_schmidt, Method::rotate_exact, Method::rotate_arc, Method::follow_grain}) {
        const MdfSubject s = subject(Mdf::ggx, 0.1, 0.4, method, 40, 25);
        for (const GridLine& line : warped_grid(s)) {
            for (std::size_t i = 1; i < line.from.size(); ++i) {
                EXPECT_NEAR(dot(line.from[i - 1], line.from[i]), dot(line.to[i - 1], line.to[i]),
                            1e-12);
                EXPECT_NEAR(line.from[i].z, dot(line.to[i], s.n), 1e-12);
            }
        }
    }
}

TEST(MdfPlot, NormalMapHasNoGrid) {
    EXPECT_THROW(forward(subject(Mdf::ggx, 0.1, 0.4, Method::normal_map, 30, 0), {0, 0, 1}),
                 UsageError);
}

// ---- spikes and other ends
// ------------------------------------------------------------------------

float brightest(const Image& values) {
    float most = 0;
    for (const float v : values.pixels)
        if (v > most) most = v;
    return most;
}

TEST(MdfPlot, ASpikeNarrowerThanATexelIsSeen) {
    for (const Method method : {Method::none, Method::normal_map, Method::rotate_exact,
                                Method::deform_linear, Method::deform_smooth}) {
        for (const double tilt : {0.0, 35.0, 85.0}) {
            const MdfSubject s = subject(Mdf::ashikhmin_shirley, 1e6, 1e6, method, tilt, 77);
            const Peak peak = peak_of(s);
            const Image values = disk_values(s, 101);
            // The peak itself has been put into its texel.
            EXPECT_GE(static_cast<double>(brightest(values)), 0.999 * peak.D)
                << name_of(method) << tilt;
            EXPECT_GT(peak.D, 1e4) << name_of(method) << tilt;
        }
    }
}

TEST(MdfPlot, ALineNarrowerThanATexelHasNoGaps) {
    const MdfSubject s = subject(Mdf::ashikhmin_shirley, 1e6, 5, Method::rotate_exact, 20, 30);
    const int side = 200;
    const Image values = disk_values(s, side);
    const double half = 0.5 * peak_of(s).D;
    int rows = 0, found = 0;
    // Rows in which the line's crest is above half the peak: |h_y - n~_y| < 0.4 for e = 5.
    for (int row = 0; row < side; ++row) {
        const double y = 1 - 2 * (row + 0.5) / side;
        if (std::abs(y - s.n.y) > 0.3) continue;
        ++rows;
        for (int column = 0; column < side; ++column)
            if (static_cast<double>(*values.at(column, row)) > half) {
                ++found;
                break;
            }
    }
    EXPECT_GT(rows, 50);
    EXPECT_EQ(found, rows);
}

TEST(MdfPlot, TheRingAroundASpikeIsDrawn) {
    const MdfSubject s = subject(Mdf::ashikhmin_shirley, 1e6, 1e6, Method::rotate_arc, 30, 0);
    const DrawnFigure d = drawn(disk_panel(s, scale_to(ScaleKind::linear, peak_of(s).D), ""));
    const Box disk = area_of(d, "disk");
    const double r = 2 * 13 / disk.width;  // on the ring, diagonally from the cross
    const Pixel p = pixel_at(d, disk, s.n.x + r * std::sqrt(0.5), s.n.y + r * std::sqrt(0.5));
    EXPECT_GT(p.rgb[0], 0.8f);
    EXPECT_GT(p.rgb[2], 0.8f);
}

TEST(MdfPlot, EndsOfTheRangesHaveFiniteValues) {
    struct Case {
        Mdf mdf;
        double p0, p1;
    };
    for (const Case c : {Case{Mdf::ashikhmin_shirley, 0, 0},
                         {Mdf::ashikhmin_shirley, 0, 1e6},
                         {Mdf::ward, 1.5, 0.001},
                         {Mdf::beckmann, 1.5, 1.5},
                         {Mdf::ggx, 0.001, 1.5},
                         {Mdf::ggx, 0.001, 0.001}}) {
        for (int method = 0; method < 9; ++method) {
            for (const double tilt : {0.0, 85.0, 89.9}) {
                const MdfSubject s =
                    subject(c.mdf, c.p0, c.p1, static_cast<Method>(method), tilt, 45);
                const Peak peak = peak_of(s);
                EXPECT_TRUE(std::isfinite(peak.D) && peak.D > 0);
                EXPECT_GE(peak.h.z, 0);
                const Image values = disk_values(s, 24);
                for (int i = 0; i < 24 * 24; ++i) {
                    const double x = 2 * (i % 24 + 0.5) / 24 - 1, y = 2 * (i / 24 + 0.5) / 24 - 1;
                    const float v = values.pixels[static_cast<std::size_t>(i)];
                    EXPECT_EQ(std::isfinite(v), x * x + y * y <= 1);
                }
            }
        }
    }
}

TEST(MdfPlot, TheBarSaysWhenNormalMapReachesBeyondIt) {
    const MdfSubject bent = subject(Mdf::beckmann, 0.15, 0.5, Method::normal_map, 60, 0);
    MdfSubject plain = bent;
    plain.method = Method::follow_grain;
    const MdfSubject both[] = {plain, bent}, alone[] = {bent};
    const ColorBar bar = disk_bar(both, ScaleKind::linear);
    EXPECT_NEAR(bar.scale.high, 1 / (std::numbers::pi * 0.15 * 0.5), 1e-6);
    ASSERT_TRUE(bar.above);
    // Its exponential is that of the unperturbed lobe, times 1/(n~.h)^4: 16 at h = n, 60 degrees.
    EXPECT_GE(*bar.above, 15.9 * bar.scale.high);
    EXPECT_FALSE(disk_bar(alone, ScaleKind::linear).above);
    EXPECT_EQ(disk_bar(both, ScaleKind::linear, 3.0).scale.high, 3);
    EXPECT_NE(bar.label.find("linear"), std::string::npos);
    EXPECT_NE(disk_bar(both, ScaleKind::gamma).label.find("gamma 2.2"), std::string::npos);
}

TEST(MdfPlot, ProfilesAreDOnTheLineAndHoldThePeak) {
    const MdfSubject s = subject(Mdf::ashikhmin_shirley, 1e6, 50, Method::rotate_exact, 30, 40);
    for (const ProfileLine line : {ProfileLine::along_x, ProfileLine::along_y}) {
        const bool along_x = line == ProfileLine::along_x;
        double most = 0, before = -2;
        for (const Point& p : profile(s, line)) {
            EXPECT_GT(p.x, before);
            before = p.x;
            const double x = along_x ? p.x : s.n.x, y = along_x ? s.n.y : p.x;
            // 1e-8: an exponent of 1e6 turns a rounding of h into 1e-10 of D.
            const double D = s.D({x, y, std::sqrt(1 - x * x - y * y)});
            EXPECT_NEAR(p.y, D, 1e-8 * D);
            most = std::max(most, p.y);
        }
        EXPECT_NEAR(most, s.D(s.n), 1e-6 * most);
    }
}

}  // namespace
}  // namespace burnish::plot
