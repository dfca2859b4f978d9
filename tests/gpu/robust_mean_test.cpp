// The mean in which bright samples count less: against the samples themselves, with transparency, in
// tiles, and in views.
#include <algorithm>
#include <cmath>
#include <vector>

#include "burnish/context.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/renderer.hpp"
#include "edited_scenes.hpp"
#include "gpu_fixture.hpp"
#include "test_scene.hpp"

namespace burnish::test {
namespace {

class RobustMean : public GpuTest {
  protected:
    // A plate turned by 20 degrees within the picture that emits `radiance`, before a dim background.
    static Scene bright_plate(glm::vec3 radiance) {
        Material m;
        m.emissive = radiance;
        Scene scene = one_object(unit_plane(), m);
        const float c = 0.6f * std::cos(0.35f), s = 0.6f * std::sin(0.35f);
        scene.instances[0].transform = glm::mat4(1.0f);
        scene.instances[0].transform[0] = glm::vec4(c, s, 0, 0);
        scene.instances[0].transform[1] = glm::vec4(-s, c, 0, 0);
        return scene;
    }
    static RenderSettings settings(int samples, float limit) {
        RenderSettings o = small_picture(20, 20, samples);
        o.background_color = glm::vec3(0.2f);
        o.robust_limit = limit;
        return o;
    }
    Camera camera_ = camera_on_z(4.0f, 1.1f);
};

// The samples are the differences of the plain means of a series. Sums of 30 of 8 samples round at 1e-5.
TEST_F(RobustMean, WeighsEachSampleByItsBrightestChannel) {
    constexpr int kSamples = 8;
    constexpr float kLimit = 2.0f;
    gpu::Renderer renderer(*context, bright_plate({30.0f, 3.0f, 1.0f}), nullptr);
    const RenderSettings plain = settings(kSamples, 0.0f);
    std::vector<Image> means;
    renderer.begin(camera_, plain);
    for (int i = 0; i < kSamples; ++i) {
        renderer.add_sample();
        means.push_back(renderer.picture());
    }
    const Image robust = renderer.render(camera_, settings(kSamples, kLimit));
    int mixed = 0;
    for (int y = 0; y < plain.height; ++y) {
        for (int x = 0; x < plain.width; ++x) {
            glm::dvec3 sum(0.0), before(0.0);
            double weights = 0;
            for (int i = 0; i < kSamples; ++i) {
                const glm::dvec3 all =
                    glm::dvec3(rgb(means[static_cast<std::size_t>(i)], x, y)) * (i + 1.0);
                const glm::dvec3 sample = all - before;
                before = all;
                const double brightest = std::max({sample.x, sample.y, sample.z});
                const double weight = std::min(1.0, kLimit / std::max(brightest, 1e-9));
                sum += weight * sample;
                weights += weight;
            }
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(robust.at(x, y)[c], sum[c] / weights, 1e-4) << x << " " << y;
            EXPECT_EQ(robust.at(x, y)[3], 1.0f);
            const float first = means.back().at(x, y)[0];
            mixed += first > 0.21f && first < 29.9f ? 1 : 0;
        }
    }
    EXPECT_GT(mixed, 20) << "no edge to look at";
}

TEST_F(RobustMean, LeavesPicturesBelowTheLimitAsTheyAre) {
    const Scene scene = busy_scene();
    const Environment sky = sky_environment();
    gpu::Renderer renderer(*context, scene, &sky);
    RenderSettings o = small_picture(40, 30, 3);
    o.image_light_samples = 4;
    for (const BackgroundKind background :
         {BackgroundKind::environment, BackgroundKind::transparent}) {
        o.background = background;
        o.robust_limit = 0.0f;
        const Image plain = renderer.render(camera_, o);
        o.robust_limit = 1e6f;
        EXPECT_TRUE(close_pictures(renderer.render(camera_, o), plain, 1e-5, 1e-6));
    }
}

// Coverage is geometry: how bright a sample is does not change it. The color of a plate of one color is
// that color wherever it is seen at all.
TEST_F(RobustMean, KeepsCoverageAndTheColorOfWhatIsSeenInPart) {
    gpu::Renderer renderer(*context, bright_plate({30.0f, 3.0f, 1.0f}), nullptr);
    RenderSettings o = settings(8, 0.0f);
    o.background = BackgroundKind::transparent;
    const Image plain = renderer.render(camera_, o);
    o.robust_limit = 2.0f;
    const Image robust = renderer.render(camera_, o);
    for (int y = 0; y < o.height; ++y) {
        for (int x = 0; x < o.width; ++x) {
            EXPECT_EQ(robust.at(x, y)[3], plain.at(x, y)[3]);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(robust.at(x, y)[c], plain.at(x, y)[c], 1e-5 * plain.at(x, y)[c]);
        }
    }
}

TEST_F(RobustMean, DoesNotDependOnTiles) {
    gpu::Renderer renderer(*context, bright_plate({30.0f, 3.0f, 1.0f}), nullptr);
    RenderSettings o = settings(8, 2.0f);
    const Image whole = renderer.render(camera_, o);
    o.tile_size = 7;
    EXPECT_TRUE(close_pictures(renderer.render(camera_, o), whole, 1e-2, 1e-5));
}

TEST_F(RobustMean, LeavesViewsOfQuantitiesAsTheyAre) {
    const Scene scene = busy_scene();
    gpu::Renderer renderer(*context, scene, nullptr);
    RenderSettings o = small_picture(24, 24, 4);
    for (const SurfaceView view : {SurfaceView::normal, SurfaceView::albedo}) {
        o.view = view;
        o.robust_limit = 0.0f;
        const Image plain = renderer.render(camera_, o);
        o.robust_limit = 0.1f;
        EXPECT_TRUE(equal_pictures(renderer.render(camera_, o), plain, 0));
    }
}

TEST_F(RobustMean, RefusesALimitThatIsNoRadiance) {
    gpu::Renderer renderer(*context, bright_plate(glm::vec3(1.0f)), nullptr);
    for (const float limit : {-1.0f, std::nanf(""), HUGE_VALF})
        EXPECT_THROW(renderer.render(camera_, settings(1, limit)), Error);
}

}  // namespace
}  // namespace burnish::test
