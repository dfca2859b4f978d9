// What a picture of few samples shows is where that of many shows it.
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "burnish/context.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/renderer.hpp"
#include "gpu_fixture.hpp"
#include "test_scene.hpp"

namespace burnish::test {
namespace {

class PixelFilter : public GpuTest {
  protected:
    // A plane that emits a round spot, whose edge is smooth.
    static Scene spot() {
        constexpr int kTexels = 64;
        std::vector<glm::vec3> texels;
        for (int y = 0; y < kTexels; ++y)
            for (int x = 0; x < kTexels; ++x) {
                const glm::vec2 from_middle = (glm::vec2(x, y) + 0.5f) / 32.0f - 1.0f;
                texels.emplace_back(std::exp(-glm::dot(from_middle, from_middle) / (2 * 0.04f)));
            }
        Material m;
        m.emissive = glm::vec3(1.0f);
        m.emissive_texture.texture = 0;
        Scene scene = one_object(unit_plane(), m);
        scene.textures.push_back(float_texture(kTexels, kTexels, texels));
        return scene;
    }

    static glm::dvec2 centroid(const Image& image) {
        glm::dvec2 sum(0.0);
        double weight = 0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                sum += glm::dvec2(x, y) * static_cast<double>(image.at(x, y)[0]);
                weight += image.at(x, y)[0];
            }
        return sum / weight;
    }

    static RenderSettings settings(int samples) {
        RenderSettings o = small_picture(24, 24, samples);
        o.background = BackgroundKind::color;
        o.background_color = glm::vec3(0.0f);
        return o;
    }
};

// Pixels. Offsets whose mean was not 0 displaced pictures of 2 samples by 0.4 px, of 16 by 0.2 px.
constexpr double kStill = 0.02;

TEST_F(PixelFilter, DisplacesNoPictureOfFewSamples) {
    gpu::Renderer renderer(*context, spot(), nullptr);
    const Camera camera = camera_on_z(4.0f, 1.1f);
    const glm::dvec2 still = centroid(renderer.render(camera, settings(256)));
    for (const int samples : {1, 2, 3, 4, 5, 8, 16, 64}) {
        const glm::dvec2 seen = centroid(renderer.render(camera, settings(samples)));
        EXPECT_NEAR(seen.x, still.x, kStill) << samples;
        EXPECT_NEAR(seen.y, still.y, kStill) << samples;
    }
}

// Every picture of a series of 64 after a whole pair, and after one of a pair by at most 1/n px.
TEST_F(PixelFilter, DisplacesNoPictureWhileSamplesAreAdded) {
    gpu::Renderer renderer(*context, spot(), nullptr);
    const Camera camera = camera_on_z(4.0f, 1.1f);
    const glm::dvec2 still = centroid(renderer.render(camera, settings(256)));
    renderer.begin(camera, settings(64));
    for (int n = 1; n <= 16; ++n) {
        renderer.add_sample();
        const glm::dvec2 seen = centroid(renderer.picture());
        const double bound = n % 2 == 0 ? kStill : 1.0 / n;
        EXPECT_NEAR(seen.x, still.x, bound) << n;
        EXPECT_NEAR(seen.y, still.y, bound) << n;
    }
}

}  // namespace
}  // namespace burnish::test
