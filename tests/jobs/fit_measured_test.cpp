// Fits a material written by the test with the model that it was made of, from file to table.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "jobs/models/brdf_fit.hpp"
#include "jobs/models/brdf_fit_plot.hpp"
#include "jobs/models/brdf_fit_table.hpp"
#include "support/bsdf_writer.hpp"
#include "support/test_folder.hpp"

namespace burnish::test {
namespace {

// The material has separable visibility and no Fresnel factor: f cos(theta_i) = c D / (4
// sigma(wo)), which is c D G1(wo) / (4 cos(theta_o)). GGX with F0 = 1 differs only by the shadowing
// of wi, which is near 1 away from grazing angles.
KnownMaterial ggx_like(double alpha_x, double alpha_y) {
    KnownMaterial material;
    material.surface = {alpha_x, alpha_y};
    material.color = [](double, double) { return std::array{0.8, 0.5, 0.2}; };
    material.normals = 96;
    if (alpha_x != alpha_y) {
        material.phis = 9;
        material.thetas = 5;
    }
    return material;
}

MeasuredFitOptions quick() {
    MeasuredFitOptions options;
    options.samples = 1500;
    return options;
}

TEST(FitMeasured, TheModelThatAMaterialWasMadeOfComesFirst) {
    const ScratchFolder folder;
    const auto file = folder.write("ggx.bsdf", ggx_like(0.25, 0.25).text());
    const std::vector<std::string> models = {"phong", "ward", "ggx", "lafortune"};
    const MeasuredFit fit = fit_measured(file, models, {}, quick());
    ASSERT_EQ(fit.fits.size(), 4U);
    EXPECT_EQ(fit.fits[0].model, "ggx");
    EXPECT_NEAR(fit.fits[0].lobe[0], 0.25, 0.025);  // the file omits the shadowing of wi
    EXPECT_EQ(fit.fits[0].lobe[0], fit.fits[0].lobe[1]);
    for (std::size_t i = 1; i < fit.fits.size(); ++i)
        EXPECT_GE(fit.fits[i].rms, fit.fits[i - 1].rms);
    EXPECT_TRUE(fit.isotropic);
    EXPECT_EQ(fit.description, "made by a test");
    EXPECT_GT(fit.of_black.rms, fit.fits.back().rms);
}

TEST(FitMeasured, AnisotropicFilesAreFittedWithTwoWidths) {
    const ScratchFolder folder;
    const auto file = folder.write("brushed.bsdf", ggx_like(0.4, 0.2).text());
    const MeasuredFit fit = fit_measured(file, std::vector<std::string>{"ggx"}, {}, quick());
    EXPECT_FALSE(fit.isotropic);
    EXPECT_NEAR(fit.fits[0].lobe[0], 0.4, 0.06);
    EXPECT_NEAR(fit.fits[0].lobe[1], 0.2, 0.03);
}

// The samples are a quadrature: their mean of cos theta_i over solid angle is known for every
// material. Int cos dw over the cap / area = (1 - cos^2) / 2 / (1 - cos), with cos of 80 degrees.
TEST(FitMeasured, SamplesStandForTheirSolidAngle) {
    const std::string text = ggx_like(0.15, 0.15).text();
    const auto* bytes = reinterpret_cast<const std::byte*>(text.data());
    const RglBrdf brdf(TensorFile("made.bsdf", {bytes, bytes + text.size()}));
    MeasuredFitOptions options;
    options.samples = 20000;
    double sum = 0, weights = 0;
    for (const BrdfSample& sample : measured_samples(brdf, options)) {
        sum += sample.weight * sample.wi.z;
        weights += sample.weight;
        EXPECT_GT(sample.wi.z, std::cos(80 * std::numbers::pi / 180) - 1e-12);
    }
    const double edge = std::cos(80 * std::numbers::pi / 180);
    EXPECT_NEAR(sum / weights, 0.5 * (1 - edge * edge) / (1 - edge), 0.01);
    // Weights sum to the solid angle of the cap of wi times 1 - cos of the cap of wo.
    EXPECT_NEAR(weights / (2 * std::numbers::pi * (1 - edge) * (1 - edge)), 1, 0.02);
}

TEST(FitMeasured, CurvesHoldWhatWasMeasuredAndFitted) {
    const ScratchFolder folder;
    const auto file = folder.write("ggx.bsdf", ggx_like(0.25, 0.25).text());
    const MeasuredFit fit =
        fit_measured(file, std::vector<std::string>{"ggx", "ward"}, {}, quick());
    ASSERT_EQ(fit.curves.size(), 3U);
    for (const PlaneCurve& curve : fit.curves) {
        ASSERT_EQ(curve.measured.size(), curve.theta_deg.size());
        ASSERT_EQ(curve.fitted.size(), 2U);
        ASSERT_EQ(curve.fitted[0].size(), curve.theta_deg.size());
        // Both peak on the side of the mirror direction.
        const auto peak = [&](const std::vector<FitRgb>& values) {
            const auto most =
                std::max_element(values.begin(), values.end(),
                                 [](const FitRgb& a, const FitRgb& b) { return a[1] < b[1]; });
            return curve.theta_deg[static_cast<std::size_t>(most - values.begin())];
        };
        EXPECT_GT(peak(curve.measured), 0.5 * curve.theta_o_deg);
        EXPECT_GT(peak(curve.fitted[0]), 0.5 * curve.theta_o_deg);
    }
}

TEST(FitMeasured, TablesSayWhatWasFitted) {
    const ScratchFolder folder;
    MeasuredFitRequest request;
    request.inputs = {folder.write("a \"b\".bsdf", ggx_like(0.25, 0.25).text()).string()};
    request.models = {"ggx", "ward"};
    request.options = quick();
    request.command = "burnish brdf fit ...";
    request.output = (folder / "t.csv").string();
    const std::string text = fit_measured_files(request, {});
    EXPECT_NE(text.find("ggx"), std::string::npos);
    std::ifstream csv(request.output);
    std::vector<std::string> lines;
    for (std::string line; std::getline(csv, line);) lines.push_back(line);
    ASSERT_EQ(lines.size(), 5U);
    EXPECT_EQ(lines[0].find("# burnish "), 0U);
    EXPECT_NE(lines[3].find("a \"\"b\"\".bsdf\",rms,1,ggx,"), std::string::npos) << lines[3];

    request.output = (folder / "t.json").string();
    fit_measured_files(request, {});
    std::ifstream json(request.output);
    const auto document = nlohmann::json::parse(json);
    const auto& fit = document["materials"][0]["fits"][0];
    EXPECT_EQ(fit["model"], "ggx");
    EXPECT_TRUE(fit["shape"].contains("alpha_x") && fit["shape"].contains("F0"));
    EXPECT_EQ(document["materials"][0]["curves"].size(), 3U);
    EXPECT_EQ(document["made"]["command"], request.command);
}

// Every number at a bound has a star behind it, and a line says what the stars are.
TEST(FitMeasured, TablesMarkNumbersAtABound) {
    MeasuredFit fit;
    fit.fits.resize(1);
    BrdfFit& one = fit.fits[0];
    one.model = "cook-torrance";
    one.lobe = {1, 0.25, 1};
    one.lobe_size = 3;
    one.kd = {0, 0.5, 0.25};
    one.ks = {0.75, 1, 1};
    one.converged = true;
    const std::vector<MeasuredFit> fits = {fit};
    EXPECT_EQ(fit_lines(fit).find('*'), std::string::npos) << fit_lines(fit);
    EXPECT_NE(fit_csv(fits, "").find(",1,0.25,1,,,\n"), std::string::npos) << fit_csv(fits, "");
    std::vector<MeasuredFit> marked = fits;
    BrdfFit& other = marked[0].fits[0];
    other.kd_at_bound = {true, false, false};
    other.ks_at_bound = {false, true, true};
    other.lobe_at_bound[2] = true;
    const std::string lines = fit_lines(marked[0]);
    for (const char* word : {"0* 0.5 0.25 ", "0.75 1* 1* ", "m 0.25, F0 1*\n", "  * at an end"})
        EXPECT_NE(lines.find(word), std::string::npos) << word << "\n" << lines;
    EXPECT_NE(fit_csv(marked, "").find(",1,0.25,1,,,kd_r ks_g ks_b F0\n"), std::string::npos);
    const auto json = nlohmann::json::parse(fit_json(marked, ""));
    EXPECT_EQ(json["materials"][0]["fits"][0]["at_bound"],
              (std::vector<std::string>{"kd_r", "ks_g", "ks_b", "F0"}));
}

// The lines of the figure are the numbers of the curves: measured and fitted, one panel an incident
// direction, in both scales.
TEST(FitMeasured, TheFigureHasTheMeasurementBesideItsFits) {
    const ScratchFolder folder;
    const auto file = folder.write("ggx.bsdf", ggx_like(0.25, 0.25).text());
    const std::vector<MeasuredFit> fits = {
        fit_measured(file, std::vector<std::string>{"ggx", "ward", "phong"}, {}, quick())};
    const plot::Figure figure = fit_figure(fits, 2, 0);
    ASSERT_EQ(figure.rows.size(), 2U);
    for (const plot::PanelRow& row : figure.rows) EXPECT_EQ(row.panels.size(), 3U);
    ASSERT_EQ(figure.legend.size(), 3U);
    EXPECT_EQ(figure.legend[0].label, "measured");
    EXPECT_EQ(figure.legend[1].label, "ggx");
    // The line of the best fit goes through its own value, in the linear panel of light at about 50
    // degrees, and so does the line of the measurement where it is drawn alone. Where both lie on one
    // another they take turns in dashes: 40 % of the fit is seen at least.
    const auto luminance = [](const FitRgb& f) {
        return 0.2126 * f[0] + 0.7152 * f[1] + 0.0722 * f[2];
    };
    const PlaneCurve& curve = fits[0].curves[1];
    const auto largest = [&](const std::vector<FitRgb>& values) {
        double most = 0;
        for (const FitRgb& f : values) most = std::max(most, luminance(f));
        return most;
    };
    const auto expect_line = [&](std::size_t models, const std::vector<FitRgb>& values, double most,
                                 const plot::Rgb& color, double least) {
        const plot::DrawnFigure drawn = plot::draw_figure(fit_figure(fits, models, 0), 2);
        ASSERT_EQ(drawn.areas.at(1).name, "polar");
        const plot::Box half = drawn.areas.at(1).box;
        int seen = 0, looked_at = 0;
        for (double degrees = 10; degrees <= 75; degrees += 0.5) {
            const auto i = static_cast<std::size_t>(2 * (degrees + 85));
            ASSERT_EQ(curve.theta_deg[i], degrees);
            const double r = luminance(values[i]) / most;
            const double theta = degrees * std::numbers::pi / 180;
            const double x = half.x + half.width / 2 * (1 + r * std::sin(theta));
            const double y = half.bottom() - half.height * r * std::cos(theta);
            double nearest = 3;
            for (int k = 0; k < 9; ++k) {  // within a pixel, for rounding
                const float* p = drawn.image.at(static_cast<int>(2 * x) + k % 3 - 1,
                                                static_cast<int>(2 * y) + k / 3 - 1);
                nearest = std::min(nearest, std::abs(static_cast<double>(p[0]) - color.r) +
                                                std::abs(static_cast<double>(p[1]) - color.g) +
                                                std::abs(static_cast<double>(p[2]) - color.b));
            }
            seen += nearest < 0.1;
            ++looked_at;
        }
        EXPECT_GE(seen, least * looked_at) << models;
    };
    const double measured = largest(curve.measured), fitted = largest(curve.fitted[0]);
    expect_line(0, curve.measured, measured, plot::kInk, 1);
    expect_line(1, curve.fitted[0], std::max(measured, fitted), plot::series_color(0), 0.4);
}

TEST(FitMeasured, WrongWishesAreRefusedInOneLine) {
    const ScratchFolder folder;
    const auto file = folder.write("a.bsdf", ggx_like(0.25, 0.25).text()).string();
    const auto line = [&](MeasuredFitRequest request) {
        request.inputs = {file};
        return error_line<UsageError>([&] { fit_measured_files(request, {}); });
    };
    MeasuredFitRequest request;
    request.output = "table.txt";
    EXPECT_NE(line(request).find(".csv or .json"), std::string::npos);
    request = {};
    request.options.samples = 10;
    EXPECT_NE(line(request).find("--samples"), std::string::npos);
    request = {};
    request.options.most_deg = 90;
    EXPECT_NE(line(request).find("--most-angle"), std::string::npos);
    request = {};
    request.models = {"gxg"};
    EXPECT_NE(line(request).find("ggx"), std::string::npos);
    EXPECT_THROW(parse_fit_models("ggx,", "--model"), UsageError);
    EXPECT_THROW(parse_fit_models("ggx,ggx", "--model"), UsageError);
    EXPECT_TRUE(parse_fit_models("all", "--model").empty());
    EXPECT_EQ(parse_fit_models("ggx,he", "--model"), (std::vector<std::string>{"ggx", "he"}));
}

TEST(FitMeasured, OneIncidentDirectionIsEnoughAndNoneIsAnError) {
    KnownMaterial material = ggx_like(0.25, 0.25);
    material.thetas = 1;
    auto parts = material.parts();
    const auto parse = [&] {
        const std::string text = tensor_text(parts);
        const auto* bytes = reinterpret_cast<const std::byte*>(text.data());
        return RglBrdf(TensorFile("made.bsdf", {bytes, bytes + text.size()}));
    };
    EXPECT_FALSE(measured_samples(parse(), quick()).empty());
    const float grazing = 1.5F;  // radians: 86 degrees
    for (TensorPart& part : parts)
        if (part.name == "theta_i")
            part.data.assign(reinterpret_cast<const char*>(&grazing), sizeof grazing);
    const std::string line = error_line([&] { measured_samples(parse(), quick()); });
    EXPECT_NE(line.find("theta_i"), std::string::npos) << line;
}

}  // namespace
}  // namespace burnish::test
