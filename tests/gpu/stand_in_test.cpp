// Materials whose programs are not compiled yet are drawn by a simple one.
#include <cmath>

#include "edited_scenes.hpp"
#include "gpu_fixture.hpp"

namespace burnish::test {
namespace {

using gpu::Renderer;

class StandIn : public GpuTest {
  protected:
    static RenderSettings settings(SurfacePass surfaces) {
        RenderSettings o = small_picture(60, 45, 2);
        o.image_light_samples = 4;
        o.surface_pass = surfaces;
        return o;
    }
    static Camera camera() { return camera_on_z(4.0f, 1.1f); }

    Scene scene_ = busy_scene();
    Environment sky_ = sky_environment();
};

double mean_of(const Image& picture) {
    double sum = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            for (int c = 0; c < 3; ++c) sum += static_cast<double>(picture.at(x, y)[c]);
    return sum / (3.0 * picture.width * picture.height);
}

// Whatever was stood in for, the mean is of the materials' own programs alone.
TEST_F(StandIn, GivesWayToThePictureItself) {
    for (const SurfacePass surfaces : {SurfacePass::forward, SurfacePass::deferred}) {
        gpu::Context other;
        Renderer plain(other, scene_, &sky_);
        plain.begin(camera(), settings(surfaces));
        for (int i = 0; i < 2; ++i) plain.add_sample();
        EXPECT_EQ(plain.stand_ins(), 0);
        const Image wanted = plain.picture();

        gpu::Context fresh;
        Renderer renderer(fresh, scene_, &sky_);
        renderer.set_compile_budget(0.0);
        renderer.begin(camera(), settings(surfaces));
        renderer.add_sample();
        EXPECT_EQ(renderer.stand_ins(), 3);  // materials
        EXPECT_EQ(renderer.samples_done(), 0);
        const double simple = mean_of(renderer.picture());
        renderer.add_sample();
        EXPECT_EQ(renderer.stand_ins(), 3);  // nothing may be compiled

        renderer.set_compile_budget(1e-9);  // one program a sample
        for (int left = 2; left >= 0; --left) {
            renderer.add_sample();
            EXPECT_EQ(renderer.stand_ins(), left);
            EXPECT_EQ(renderer.samples_done(), left == 0 ? 1 : 0);
        }
        renderer.add_sample();
        EXPECT_EQ(renderer.samples_done(), 2);
        EXPECT_TRUE(equal_pictures(renderer.picture(), wanted, 0.0));
        // Measured: 1.089. The simple picture knows no anisotropy and no bumps, but the same light.
        EXPECT_NEAR(simple / mean_of(wanted), 1.0, 0.15);
    }
}

TEST_F(StandIn, IsNotForOtherViewsNorForPicturesOfRender) {
    Renderer renderer(*context, scene_, &sky_);
    renderer.set_compile_budget(0.0);
    RenderSettings o = settings(SurfacePass::automatic);
    o.view = SurfaceView::normal;
    renderer.begin(camera(), o);
    renderer.add_sample();
    EXPECT_EQ(renderer.stand_ins(), 0);
    const Image picture = renderer.render(camera(), settings(SurfacePass::automatic));
    EXPECT_EQ(renderer.stand_ins(), 0);
    Renderer plain(*context, scene_, &sky_);
    EXPECT_TRUE(
        equal_pictures(plain.render(camera(), settings(SurfacePass::automatic)), picture, 0.0));
}

// A scene that only the simple program would leave black is compiled before it is shown.
TEST_F(StandIn, IsNotForScenesThatItDoesNotLight) {
    scene_.lights.clear();
    Renderer renderer(*context, scene_, nullptr);
    renderer.set_compile_budget(0.0);
    renderer.begin(camera(), settings(SurfacePass::automatic));
    renderer.add_sample();
    EXPECT_EQ(renderer.stand_ins(), 0);
    EXPECT_EQ(renderer.samples_done(), 1);
}

}  // namespace
}  // namespace burnish::test
