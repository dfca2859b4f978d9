// AnisotropyStrengthTest against the screenshot that its authors ship with it: every sphere looks
// like theirs.
//
// Camera of the screenshot (1186 x 1120 pixels), fitted off line: centroids and areas of the
// outlines of the 49 spheres, told from the bluish background by their grey, and a pinhole camera
// with free principal point put through them: 0.06 pixels are left (rms).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "burnish/image_io.hpp"
#include "pictures.hpp"

namespace burnish::test {
namespace {

constexpr int kGrid = 7;
constexpr double kRadius = 0.4;  // of the spheres, one metre apart
constexpr glm::dvec2 kPrincipal{614.495, 585.907};
// The part of the screenshot with the principal point in its middle, to a tenth of a pixel.
constexpr int kWidth = 1143, kHeight = 1068, kLeft = 43, kTop = 52;
constexpr FittedCamera kCamera{
    {-2.885813, 4.711252, 11.099445}, {-0.445876, 2.608118, 0.0}, 1604.989, kWidth, kHeight};

struct Disc {
    glm::dvec2 middle;  // in the cut-out
    double radius;
};

Disc disc_of(int column, int row) {
    const Projection seen = project(kCamera, {column - 3, row, 0});
    return {kPrincipal - glm::dvec2(kLeft, kTop) + seen.offset_px, kRadius * seen.px_per_metre};
}

// Over the pixels of a sphere, green as displayed, 0 to 255.
struct Likeness {
    double mean_theirs = 0, mean_ours = 0, correlation = 0;
};

Likeness likeness(const Image& theirs, const Image& ours, const Disc& disc) {
    double n = 0, a = 0, b = 0, aa = 0, bb = 0, ab = 0;
    for (int y = 0; y < kHeight; ++y) {
        for (int x = 0; x < kWidth; ++x) {
            // Outlines and the few tenths of a pixel of the discs' ellipticity are left out.
            if (glm::distance(glm::dvec2(x + 0.5, y + 0.5), disc.middle) > disc.radius - 4)
                continue;
            const double p = 255.0 * static_cast<double>(theirs.at(x + kLeft, y + kTop)[1]);
            const double q = 255.0 * static_cast<double>(ours.at(x, y)[1]);
            n += 1;
            a += p;
            b += q;
            aa += p * p;
            bb += q * q;
            ab += p * q;
        }
    }
    const double spread = std::sqrt((aa - a * a / n) * (bb - b * b / n));
    return {a / n, b / n, (ab - a * b / n) / spread};
}

class AnisotropyStrengthScreenshot : public testing::Test {
  protected:
    void SetUp() override {
        BURNISH_REQUIRE_GL();
        const std::string model = sample_model("AnisotropyStrengthTest");
        BURNISH_REQUIRE_SAMPLE(model);
        stage_ = stage_of_screenshot(model, kCamera);
        // The renderer of the screenshot reflects light once.
        for (Material& material : stage_.scene.materials) material.single_scattering = true;
        theirs_ =
            read_image(sample("models/AnisotropyStrengthTest/screenshot/screenshot-large.png"),
                       {.as_data = true});
        ASSERT_EQ(theirs_.width, 1186);
        ASSERT_EQ(theirs_.height, 1120);
    }
    Image shown() const { return to_display(picture_of(stage_), 0.0, ToneMap::linear); }

    Stage stage_;
    Image theirs_;
};

// Roughness 0 is left out: lines narrower than a pixel, which the screenshot does not antialias.
TEST_F(AnisotropyStrengthScreenshot, EverySphereLooksAlikeAndTheOrderIsTheSame) {
    const Image ours = shown();
    std::array<std::array<Likeness, kGrid>, kGrid> all;
    for (int column = 1; column < kGrid; ++column) {
        for (int row = 0; row < kGrid; ++row) {
            const Likeness l = likeness(theirs_, ours, disc_of(column, row));
            const std::string where = fmt::format("roughness_{}_strength_{}", column, row);
            RecordProperty(where, fmt::format("{:.1f} theirs, {:.1f} ours, correlation {:.3f}",
                                              l.mean_theirs, l.mean_ours, l.correlation));
            EXPECT_GT(l.correlation, 0.98) << where;
            EXPECT_NEAR(l.mean_ours, l.mean_theirs, 5.0) << where;
            all[static_cast<std::size_t>(column)][static_cast<std::size_t>(row)] = l;
        }
    }
    // Which of two neighbours is brighter, where the screenshot tells them apart.
    int pairs = 0;
    for (std::size_t column = 1; column < kGrid; ++column) {
        for (std::size_t row = 0; row + 1 < kGrid; ++row) {
            const Likeness &low = all[column][row], &high = all[column][row + 1];
            const double step = high.mean_theirs - low.mean_theirs;
            if (std::abs(step) < 2) continue;
            ++pairs;
            EXPECT_GT((high.mean_ours - low.mean_ours) * step, 0.0)
                << "roughness " << column << "/6, strengths " << row << " and " << row + 1;
        }
    }
    EXPECT_GT(pairs, 15);
}

// That the measure sees strength: with a wrong one the spheres look otherwise.
TEST_F(AnisotropyStrengthScreenshot, AWrongStrengthIsSeen) {
    for (Material& material : stage_.scene.materials)
        std::get<GltfLobe>(material.lobe).anisotropy_strength *= 0.5f;
    const Image wrong = shown();
    EXPECT_LT(likeness(theirs_, wrong, disc_of(1, 6)).correlation, 0.96);
    EXPECT_LT(likeness(theirs_, wrong, disc_of(2, 6)).correlation, 0.97);
}

}  // namespace
}  // namespace burnish::test
