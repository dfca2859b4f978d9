// The warnings of a fit: each is given where its input asks for it, and not where it would be false.
#include "jobs/capture/capture_fit_judge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/constants.hpp"

namespace burnish::test {
namespace {

// 4 x 4 texels of one exemplar, all with the same rotation; D by the slope across and along.
TabulatedMaterial material_of(const std::function<double(double, double)>& d) {
    TabulatedMaterial m;
    m.exemplars = 1;
    for (int r = 0; r < m.grid.rings; ++r)
        for (int c = 0; c < m.grid.azimuths; ++c) {
            const double tan = std::tan(static_cast<double>(m.grid.theta(static_cast<float>(r))));
            const double phi = 2.0 * kPi * c / m.grid.azimuths;
            m.D.push_back(static_cast<float>(d(tan * std::cos(phi), tan * std::sin(phi))));
        }
    m.origin.assign(m.D.size(), NdfOrigin::measured);
    m.width = m.height = 4;
    m.exemplar.assign(16, 0);
    m.angle.assign(16, 0.0f);
    m.diffuse = Image(4, 4, 3, 0.2f);
    m.specular = Image(4, 4, 3, 0.04f);
    m.normal = Image(4, 4, 3, 0.0f);
    m.maps["fit.error"].assign(16, 0.0f);
    return m;
}

double gaussian(double x, double y, double along, double across) {
    return std::exp(-std::pow(x / across, 2) - std::pow(y / along, 2));
}

std::string warnings_for(const CaptureFitResult& result, bool normals = false) {
    CaptureFitRequest request;
    request.stack = "s.json";
    request.settings.normals = normals;
    std::vector<std::string> warnings;
    warn_of_fit(result, request, warnings);
    std::string all;
    for (const std::string& warning : warnings) all += warning + "\n";
    return all;
}

bool has(const std::string& text, const char* part) {
    return text.find(part) != text.npos;
}

CaptureFitResult result_of(double unexplained) {
    CaptureFitResult result;
    result.unexplained = result.fit.training_error = unexplained;
    result.exemplars.used = 1;
    return result;
}

TEST(FitJudge, ARoundLobeHasNoGrain) {
    const auto round = [](double x, double y) { return gaussian(x, y, 0.3, 0.3); };
    const auto grooved = [](double x, double y) { return gaussian(x, y, 0.2, 0.4); };
    EXPECT_EQ(judge_exemplars(material_of(round), 4.0).one_direction, 0);
    EXPECT_EQ(judge_exemplars(material_of(grooved), 4.0).one_direction, 1);
}

TEST(FitJudge, APeakBesideTheNormalIsNamed) {
    const auto hole = [](double x, double y) {
        return std::exp(-std::pow((std::hypot(x, y) - 0.21) / 0.05, 2));
    };
    const ExemplarJudgement judged = judge_exemplars(material_of(hole), 4.0);
    ASSERT_EQ(judged.hollow, 1);
    EXPECT_NEAR(judged.first_hollow.peak_deg, std::atan(0.21) / kDegree, 1.0);  // of a ring
    EXPECT_LT(judged.first_hollow.at_normal, 0.01);
    EXPECT_EQ(judge_exemplars(
                  material_of([](double x, double y) { return gaussian(x, y, 0.2, 0.2); }), 4.0)
                  .hollow,
              0);
    CaptureFitResult result = result_of(0.09);
    result.exemplars = judged;
    EXPECT_TRUE(has(warnings_for(result), "at 12 degrees from it): a pile such as velvet"));
    EXPECT_TRUE(has(warnings_for(result), "try --normals"));
    EXPECT_TRUE(has(warnings_for(result, true), "--seed"));
    result.unexplained = 0.01;  // a pile: what was seen is explained
    EXPECT_EQ(warnings_for(result), "");
}

TEST(FitJudge, DiffuseAloneIsSaidOfWhatIsExplained) {
    TabulatedMaterial m = material_of([](double, double) { return 1.0 / kPi; });
    m.specular = Image(4, 4, 3, 0.0f);
    CaptureFitResult card = result_of(0.01);
    card.exemplars = judge_exemplars(m, 4.0);
    ASSERT_EQ(card.exemplars.dark, 1);
    EXPECT_TRUE(has(warnings_for(card), "the material is diffuse alone"));
    m.maps["fit.error"].assign(16, 0.14f * 0.14f);
    CaptureFitResult wrong = result_of(0.14);
    wrong.exemplars = judge_exemplars(m, 4.0);
    EXPECT_NEAR(wrong.exemplars.dark_unexplained, 0.14, 1e-6);
    const std::string text = warnings_for(wrong);
    EXPECT_FALSE(has(text, "diffuse alone")) << text;
    EXPECT_FALSE(has(text, "show no highlight")) << text;
    EXPECT_TRUE(has(text, "leaves 14 % of their light unexplained")) << text;
}

TEST(FitJudge, NormalsAreAdvisedWhereTheyExplainMore) {
    CaptureFitResult result = result_of(0.14);
    result.fit.tilted_error = 0.004;
    std::string text = warnings_for(result);
    EXPECT_TRUE(has(text, "14 % of the light is unexplained")) << text;
    EXPECT_TRUE(has(text, "0.4 %: the sample does not seem flat: fit it with --normals")) << text;
    result.fit.tilted_error = 0.13;
    text = warnings_for(result);
    EXPECT_TRUE(has(text, "13 %")) << text;
    EXPECT_FALSE(has(text, "fit it with --normals")) << text;
    EXPECT_FALSE(has(warnings_for(result, true), "--normals"));
    // Little is unexplained, but normals explain it: leaning lobes took the place of the normals.
    result = result_of(0.02);
    result.fit.tilted_error = 0.005;
    EXPECT_TRUE(has(warnings_for(result), "fit it with --normals"));
    EXPECT_EQ(warnings_for(result_of(0.04)), "");  // 5 % of noise leaves as much
}

}  // namespace
}  // namespace burnish::test
