// Filtered bumps against a reference: the same picture drawn so large that every bump is resolved,
// box filtered.
#include <algorithm>
#include <cmath>
#include <functional>

#include "burnish/renderer.hpp"
#include "flicker.hpp"
#include "gpu_fixture.hpp"
#include "maps/normal/bumps.hpp"
#include "test_scene.hpp"

namespace burnish::test {
namespace {

constexpr int kTexels = 512;
constexpr int kTrueSide = 2048;  // 4 samples: a pixel is at most half a texel of the map

// The mean of the brightest twentieth of the pixels: the highlights, at any position.
double highlights(const Image& image) {
    std::vector<float> sorted = image.pixels;
    std::sort(sorted.begin(), sorted.end(), std::greater<>());
    sorted.resize(sorted.size() / 20);
    double sum = 0;
    for (const float v : sorted) sum += static_cast<double>(v);
    return sum;
}

double distance(const Image& a, const Image& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const double d = static_cast<double>(a.pixels[i]) - static_cast<double>(b.pixels[i]);
        sum += d * d;
    }
    return std::sqrt(sum / static_cast<double>(a.pixels.size()));
}

class NormalFilterTest : public GpuTest {
  protected:
    // A metal sphere with 32 bumps around it, 1,024 on it.
    Scene bumpy_sphere(Mdf mdf, glm::vec2 alpha, Method method, NormalFilter filter) {
        const Image normals = bump_normal_map(kTexels);
        std::vector<glm::vec3> texels;
        for (std::size_t i = 0; i < normals.pixels.size(); i += 3)
            texels.emplace_back(normals.pixels[i], normals.pixels[i + 1], normals.pixels[i + 2]);
        Material m;
        m.single_scattering = true;  // the filter alone: docs/theory/energy.md has the rest
        m.normal_texture.texture = 0;
        m.normal_texture.transform = glm::mat3(4, 0, 0, 0, 2, 0, 0, 0, 1);
        m.mdf = mdf;
        m.lobe = AlphaLobe{alpha};
        m.method = method;
        m.normal_filter = filter;
        Scene scene = one_object(uv_sphere(256, 128), m);
        scene.textures.push_back(float_texture(kTexels, kTexels, texels));
        scene.lights.push_back(directional({0.3f, 0.4f, 1.0f}));
        return scene;
    }

    Image draw(const Scene& scene, int side, int samples) {
        gpu::Renderer renderer(*context, scene, nullptr);
        return renderer.render(camera_on_z(4.0f, 1.1f), small_picture(side, side, samples));
    }
};

struct Surface {
    Mdf mdf;
    glm::vec2 alpha;
    Method method;
};

// One sample per pixel, as during rotation of a model. Lower bounds are loose: trilinear look-ups
// blur over more than a pixel, most near the limb.
TEST_F(NormalFilterTest, HighlightsAreNotBrighterThanTheTruth) {
    const Surface surfaces[] = {{Mdf::ggx, {0.1f, 0.4f}, Method::follow_grain},
                                {Mdf::beckmann, {0.1f, 0.4f}, Method::follow_grain},
                                {Mdf::ashikhmin_shirley, {0.3f, 0.3f}, Method::gram_schmidt},
                                {Mdf::ward, {0.3f, 0.3f}, Method::deform_linear}};
    for (const Surface& s : surfaces) {
        const Scene filtered = bumpy_sphere(s.mdf, s.alpha, s.method, NormalFilter::moments);
        const Scene plain = bumpy_sphere(s.mdf, s.alpha, s.method, NormalFilter::mips);
        const Image large = draw(plain, kTrueSide, 4);
        double brightest_plain = 0;
        for (const int side : {512, 128, 64, 32}) {
            const Image truth = reduced(large, kTrueSide / side);
            const Image with = reduced(draw(filtered, side, 1), 1);
            const Image without = reduced(draw(plain, side, 1), 1);
            const double ratio = highlights(with) / highlights(truth);
            const double plain_ratio = highlights(without) / highlights(truth);
            brightest_plain = std::max(brightest_plain, plain_ratio);
            const std::string what = std::string(name_of(s.mdf)) + " " + std::to_string(side);
            if (std::getenv("BURNISH_PRINT_FILTER") != nullptr) {
                std::printf(
                    "%-24s highlights %.3f (mips %.3f) mean %.3f (%.3f) rms error %.3f (%.3f)\n",
                    what.c_str(), ratio, plain_ratio, mean(with) / mean(truth),
                    mean(without) / mean(truth), distance(with, truth) / mean(truth),
                    distance(without, truth) / mean(truth));
            }
            EXPECT_LT(ratio, 1.01) << what;
            EXPECT_GT(ratio, 0.75) << what;
            EXPECT_NEAR(mean(with) / mean(truth), 1, 0.2) << what;
            // A deformation moves the far side of the lobe less than its peak, so widening fits it
            // less well.
            const double better = is_deformation(s.method) ? 1.0 : 0.85;
            if (side < 512) {
                EXPECT_LT(distance(with, truth), better * distance(without, truth)) << what;
            }
        }
        // Unfiltered bumps of the size of a pixel sparkle.
        EXPECT_GT(brightest_plain, 1.1) << name_of(s.mdf);
    }
}

// A still picture: finer mips and 16 samples.
TEST_F(NormalFilterTest, StillsConvergeToTheTruth) {
    const Scene scene =
        bumpy_sphere(Mdf::ggx, {0.1f, 0.4f}, Method::follow_grain, NormalFilter::moments);
    const Image truth = reduced(draw(scene, kTrueSide, 4), kTrueSide / 64);
    const Image still = reduced(draw(scene, 64, 16), 1);
    EXPECT_NEAR(mean(still) / mean(truth), 1, 0.03);
    EXPECT_LT(highlights(still) / highlights(truth), 1.0);
    EXPECT_GT(highlights(still) / highlights(truth), 0.88);
}

// Magnified bumps have no variance: both filters read the same normals, interpolated as slopes or
// as vectors.
TEST_F(NormalFilterTest, UpCloseBothAreOnePicture) {
    const Image a = reduced(
        draw(bumpy_sphere(Mdf::ggx, {0.2f, 0.4f}, Method::follow_grain, NormalFilter::moments),
             1536, 1),
        1);
    const Image b =
        reduced(draw(bumpy_sphere(Mdf::ggx, {0.2f, 0.4f}, Method::follow_grain, NormalFilter::mips),
                     1536, 1),
                1);
    EXPECT_LT(distance(a, b), 0.03 * mean(b));
}

// A turntable of 1 degree a frame: flicker is the second difference of a pixel over three frames.
TEST_F(NormalFilterTest, ATurntableFlickersAsTheTruthDoes) {
    constexpr int kSide = 96;
    const auto flicker_of = [&](NormalFilter filter, int side) {
        Scene scene = bumpy_sphere(Mdf::ggx, {0.1f, 0.4f}, Method::follow_grain, filter);
        return flicker_on_turntable(
            scene, [&](const Scene& s) { return reduced(draw(s, side, 1), side / kSide); });
    };
    const double truth = flicker_of(NormalFilter::mips, 16 * kSide);
    const double plain = flicker_of(NormalFilter::mips, kSide);
    const double filtered = flicker_of(NormalFilter::moments, kSide);
    if (std::getenv("BURNISH_PRINT_FILTER") != nullptr)
        std::printf("flicker: truth %.3f, mips %.3f, moments %.3f\n", truth, plain, filtered);
    EXPECT_LT(filtered, 1.1 * truth);
    EXPECT_GT(plain, 1.5 * truth);
}

// The map is uploaded in its other form, and the picture is that of a new renderer.
TEST_F(NormalFilterTest, TheFilterCanBeChanged) {
    Scene scene = bumpy_sphere(Mdf::ggx, {0.2f, 0.4f}, Method::follow_grain, NormalFilter::moments);
    gpu::Renderer edited(*context, scene, nullptr);
    const Image moments = edited.render(camera_on_z(), small_picture());
    scene.materials[0].normal_filter = NormalFilter::mips;
    edited.set_materials(scene.materials);
    const Image changed = edited.render(camera_on_z(), small_picture());
    const Image fresh =
        gpu::Renderer(*context, scene, nullptr).render(camera_on_z(), small_picture());
    EXPECT_EQ(changed.pixels, fresh.pixels);
    EXPECT_NE(changed.pixels, moments.pixels);
}

}  // namespace
}  // namespace burnish::test
