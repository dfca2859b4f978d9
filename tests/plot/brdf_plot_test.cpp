// Plots of reflection models against the models, and albedo against docs/evidence/correctness.md.
#include "burnish/plot/brdf_plot.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "plot/surface_mesh.hpp"
#include "support/paths.hpp"

namespace burnish::plot {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

BrdfSubject subject(std::string_view name, std::array<double, kMostBrdfParameters> p) {
    for (const BrdfModel& model : brdf_models())
        if (model.name == name) return {&model, p, std::string(name)};
    ADD_FAILURE() << name;
    return {};
}

TEST(BrdfPlot, RadiusOfThePolarCutIsTheModelsValue) {
    const Direction<double> wi = incident(40, 30);
    for (const double cut : {30.0, 210.0, 75.0}) {
        const BrdfSubject s = subject("ward-gmd", {1, 0.15, 0.4});
        double before = -2;
        for (const Point& p : polar_cut(s, wi, cut)) {
            EXPECT_GT(p.x, before);
            before = p.x;
            // Positive angles are on the far side of the cut's azimuth.
            const Direction<double> wo = incident(p.x / kDegree, cut + 180);
            EXPECT_NEAR(p.y, s.f(wi, wo), 1e-9 * (1 + p.y));
        }
    }
}

TEST(BrdfPlot, ThePolarCutHoldsASpike) {
    for (const double incidence : {0.0, 33.3, 80.0}) {
        const BrdfSubject s = subject("ashikhmin-shirley", {1e6, 1e6, 1});
        const Direction<double> wi = incident(incidence, 0);
        double most = 0, at = 0;
        for (const Point& p : polar_cut(s, wi, 0))
            if (p.y > most) {
                most = p.y;
                at = p.x;
            }
        EXPECT_NEAR(at / kDegree, incidence, 0.02);
        EXPECT_NEAR(most, s.f(wi, {-wi.x, -wi.y, wi.z}), 1e-3 * most);
    }
}

// The line itself: pixels at the radius of f have its color, inside and outside they have not.
TEST(BrdfPlot, TheDrawnLineLiesAtF) {
    PolarPlot plot;
    plot.subjects = {subject("beckmann", {0.4, 0.4, 1})};
    plot.incidence_deg = 30;
    Figure figure;
    figure.rows = {{"", {polar_panel(plot, "")}}};
    const DrawnFigure drawn = draw_figure(figure, 2);
    const Box half = drawn.areas.at(0).box;
    const Direction<double> wi = incident(30, 0);
    double high = 0;
    // Beyond 85 degrees models leave their plots: the rim is the largest f up to there.
    for (const Point& p : polar_cut(plot.subjects[0], wi, 0))
        if (std::abs(p.x) <= 85 * kDegree) high = std::max(high, p.y);
    const Rgb color = series_color(0);
    const auto differs = [&](double theta, double r) {
        const double x = half.x + half.width / 2 + half.width / 2 * r * std::sin(theta);
        const double y = half.bottom() - half.height * r * std::cos(theta);
        const float* p = drawn.image.at(static_cast<int>(2 * x), static_cast<int>(2 * y));
        return std::abs(static_cast<double>(p[0]) - color.r) +
               std::abs(static_cast<double>(p[1]) - color.g) +
               std::abs(static_cast<double>(p[2]) - color.b);
    };
    for (const double degrees : {8.0, 22.0, 40.0, 52.0}) {
        const double theta = degrees * kDegree;
        const double r = plot.subjects[0].f(wi, {-std::sin(theta), 0, std::cos(theta)}) / high;
        EXPECT_LT(differs(theta, r), 0.05) << degrees;
        EXPECT_GT(differs(theta, r + 0.05), 0.2) << degrees;
        EXPECT_GT(differs(theta, r - 0.05), 0.2) << degrees;
    }
}

// docs/evidence/correctness.md: "| ward-gmd (1, 0.15, 0.4) | x, y | ..." at these angles.
TEST(BrdfPlot, AlbedoCurvesAreTheTabulatedNumbers) {
    const std::vector<double> angles = {0, 15, 30, 45, 60, 75, 80, 85};
    std::ifstream file(test::source_folder() / "docs/evidence/correctness.md");
    std::string line;
    while (std::getline(file, line) && line.find("### Albedo over the angle") == line.npos) {
    }
    int rows = 0;
    for (const BrdfSubject& s :
         {subject("ward", {1, 0.15, 0.4}), subject("ward-duer", {1, 0.15, 0.4}),
          subject("ward-gmd", {1, 0.15, 0.4}), subject("ggx", {0.15, 0.4, 1}),
          subject("ashikhmin-shirley", {200, 10, 1})}) {
        file.clear();
        file.seekg(0);
        while (std::getline(file, line) && line.find("### Albedo over the angle") == line.npos) {
        }
        while (std::getline(file, line) && line.find("| " + s.label + " (") != 0) {
        }
        ASSERT_TRUE(file) << s.label;
        ++rows;
        std::istringstream cells(line.substr(line.find(") |") + 3));
        const auto along_x = albedo_curve(s, 0), along_y = albedo_curve(s, 90);
        for (const double angle : angles) {
            double x = 0, y = 0;
            char comma = 0, bar = 0;
            cells >> x >> comma >> y >> bar;
            const auto at = [&](const std::vector<Point>& curve) {
                for (const Point& p : curve)
                    if (p.x == angle) return p.y;
                return std::nan("");
            };
            // The table has three digits.
            EXPECT_NEAR(at(along_x), x, 0.00051) << s.label << angle;
            EXPECT_NEAR(at(along_y), y, 0.00051) << s.label << angle;
        }
    }
    EXPECT_EQ(rows, 5);
}

TEST(BrdfPlot, PeaksAreFoundHoweverNarrow) {
    const Direction<double> wi = incident(50, 20);
    const BrdfSubject narrow = subject("ashikhmin-shirley", {1e6, 1e6, 1});
    const BrdfPeak peak = peak_of(narrow, wi);
    // The half vector of the mirror direction is the normal, where D is largest; 1/max(cosines)
    // moves the peak by less than the lobe's width.
    EXPECT_GT(dot(peak.wo, Direction<double>{-wi.x, -wi.y, wi.z}), 1 - 1e-5);
    EXPECT_GE(peak.f, narrow.f(wi, {-wi.x, -wi.y, wi.z}));
}

TEST(BrdfPlot, TheSurfaceIsFAndEndsAtTheHorizon) {
    const Direction<double> wi = incident(70, 10);
    for (const char* name : {"ggx", "beckmann"}) {
        const BrdfSubject s = subject(name, {0.3, 0.5, 1});
        const BrdfPeak peak = peak_of(s, wi);
        const Scale scale = scale_to(ScaleKind::linear, peak.f);
        const SurfaceMesh mesh = surface_mesh(s, wi, scale, peak.wo);
        double longest = 0;
        std::vector<bool> used(mesh.points.size());
        for (const auto& t : mesh.triangles)
            for (const std::size_t i : t) used[i] = true;
        for (std::size_t i = 0; i < mesh.points.size(); ++i) {
            if (!used[i]) continue;
            Direction<double> d = mesh.points[i];
            const double r = std::sqrt(dot(d, d));
            EXPECT_GE(d.z, 0);
            longest = std::max(longest, r);
            if (!make_unit(d) || r < 1e-6) continue;
            // 1e-5: near the horizon, by 1e-6, the direction is known to ten digits only.
            EXPECT_NEAR(r, scale.position(s.f(wi, d)), 1e-5);
        }
        EXPECT_NEAR(longest, 1, 1e-6);
    }
}

// Hidden parts are hidden: seen from straight above, a lobe about the normal hides the origin.
TEST(BrdfPlot, TheLobeHidesWhatIsBehindIt) {
    const BrdfSubject s = subject("ashikhmin-shirley-diffuse", {1, 0});
    Figure figure;
    figure.rows = {{"", {surface_panel(s, 40, 0, ScaleKind::linear, {-75, 90}, "")}}};
    const DrawnFigure drawn = draw_figure(figure, 1);
    const Box box = drawn.areas.at(0).box;
    // The light comes from +x at 40 degrees; its ray starts 1.18 from the origin, above a lobe of
    // radius 1, and ends inside it. Somewhere under the lobe there is the ground's grey: not seen.
    int blue = 0, gray = 0;
    for (int y = -20; y <= 20; ++y) {
        for (int x = -20; x <= 20; ++x) {
            if (std::hypot(x, y) < 12) continue;  // the n of the normal stands there
            const float* p = drawn.image.at(static_cast<int>(box.center().x) + x,
                                            static_cast<int>(box.center().y) + y);
            if (p[2] > p[0] + 0.15f) ++blue;
            if (std::abs(p[2] - p[0]) < 0.03f && p[0] > 0.8f) ++gray;
        }
    }
    EXPECT_GT(blue, 800);
    EXPECT_EQ(gray, 0);
}

}  // namespace
}  // namespace burnish::plot
