// Series of samples for a window: begin, add_sample, present, picture.
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <vector>

#include "burnish/display.hpp"
#include "edited_scenes.hpp"
#include "gpu/device/gl.hpp"
#include "gpu/device/handles.hpp"
#include "gpu/device/program.hpp"
#include "gpu_fixture.hpp"

namespace burnish::test {
namespace {

using gpu::Renderer;

// A window's framebuffer: 8 bits per channel.
class Window {
  public:
    Window(int width, int height) : width_(width), height_(height) {
        glBindTexture(GL_TEXTURE_2D, texture_.get());
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                     nullptr);
        glBindFramebuffer(GL_FRAMEBUFFER, target_.get());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.get(),
                               0);
    }
    unsigned framebuffer() const { return target_.get(); }

    // RGBA in [0, 1], row 0 at the top.
    Image shown() const {
        std::vector<std::uint8_t> bytes(static_cast<std::size_t>(width_ * height_ * 4));
        glBindFramebuffer(GL_FRAMEBUFFER, target_.get());
        glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
        Image image(width_, height_, 4);
        for (int y = 0; y < height_; ++y)
            for (int i = 0; i < 4 * width_; ++i)
                image.at(0, height_ - 1 - y)[i] =
                    static_cast<float>(bytes[static_cast<std::size_t>(4 * width_ * y + i)]) /
                    255.0f;
        return image;
    }

  private:
    int width_, height_;
    gpu::GlTexture texture_;
    gpu::Framebuffer target_;
};

class Series : public GpuTest {
  protected:
    static RenderSettings settings(int samples = 4) {
        RenderSettings o = small_picture(40, 30, samples);
        o.image_light_samples = 4;
        return o;
    }
    static Camera camera() { return camera_on_z(4.0f, 1.1f); }

    Scene scene_ = busy_scene();
    Environment sky_ = sky_environment();
};

TEST_F(Series, EndsAtThePictureOfRender) {
    Renderer renderer(*context, scene_, &sky_);
    const Image wanted = renderer.render(camera(), settings());
    EXPECT_EQ(renderer.samples_done(), 0);
    renderer.begin(camera(), settings());
    for (int i = 1; i <= 4; ++i) {
        renderer.add_sample();
        EXPECT_EQ(renderer.samples_done(), i);
    }
    // The number of lights is a constant in one shader and a uniform in the other, so rounding
    // differs.
    EXPECT_TRUE(close_pictures(renderer.picture(), wanted, 1e-2, 1e-4));
}

TEST_F(Series, IsShownAsToDisplayHasIt) {
    Renderer renderer(*context, scene_, &sky_);
    for (const BackgroundKind background :
         {BackgroundKind::transparent, BackgroundKind::environment, BackgroundKind::transparent}) {
        RenderSettings o = settings();
        o.background = background;
        // The sums of the plain and of the robust mean are divided by different numbers.
        o.robust_limit = background == BackgroundKind::transparent ? 0.2f : 0.0f;
        renderer.begin(camera(), o);
        renderer.add_sample();
        renderer.add_sample();
        const Window window(o.width, o.height);
        for (int tone_map = 0; tone_map < 4; ++tone_map) {
            for (const double exposure : {-1.0, 0.0, 2.5}) {
                const auto map = static_cast<ToneMap>(tone_map);
                renderer.present(window.framebuffer(), o.width, o.height, exposure, map);
                EXPECT_TRUE(equal_pictures(
                    window.shown(), to_display(renderer.picture(), exposure, map), 1.0 / 255))
                    << tone_map_names()[static_cast<std::size_t>(tone_map)] << " at " << exposure;
            }
        }
    }
}

// The color of the albedo is made on the device here and on the processor there.
TEST_F(Series, ShowsTheAlbedoAsItsPictureIs) {
    scene_.materials[0].method = Method::normal_map;  // gains energy: red as well as gray
    scene_.materials[0].lobe = AlphaLobe{{0.1f, 0.4f}};
    scene_.textures[0] = bump_texture(32, 4, 1.0f);
    Renderer renderer(*context, scene_, nullptr);
    for (const BackgroundKind background : {BackgroundKind::color, BackgroundKind::transparent}) {
        RenderSettings o = settings();
        o.view = SurfaceView::albedo;
        o.background = background;
        renderer.begin(camera(), o);
        renderer.add_sample();
        renderer.add_sample();
        const Window window(o.width, o.height);
        renderer.present(window.framebuffer(), o.width, o.height, 0.0, ToneMap::linear);
        const Image picture = renderer.picture();
        EXPECT_TRUE(
            equal_pictures(window.shown(), to_display(picture, 0.0, ToneMap::linear), 1.0 / 255));
        int red = 0;
        for (int y = 0; y < o.height; ++y)
            for (int x = 0; x < o.width; ++x)
                red += picture.at(x, y)[0] > 2 * picture.at(x, y)[1] + 0.01f ? 1 : 0;
        EXPECT_GT(red, 0);
    }
}

TEST_F(Series, TimesThePassesThatItDraws) {
    Renderer renderer(*context, scene_, &sky_);
    const auto milliseconds = [](const gpu::PassTimes& times, gpu::Pass pass) {
        return 1000 * times.seconds[static_cast<std::size_t>(pass)];
    };
    for (const SurfacePass surfaces : {SurfacePass::forward, SurfacePass::deferred}) {
        RenderSettings o = settings();
        o.shadows = true;
        o.background = BackgroundKind::environment;
        o.surface_pass = surfaces;
        renderer.measure_passes(true);
        renderer.begin(camera(), o);
        const auto start = std::chrono::steady_clock::now();
        for (int i = 0; i < 3; ++i) renderer.add_sample();
        const Window window(o.width, o.height);
        renderer.present(window.framebuffer(), o.width, o.height, 0.0, ToneMap::linear);
        const gpu::PassTimes times = renderer.take_pass_times();
        const double passed_ms =
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
                .count();
        EXPECT_EQ(times.samples, 3);
        EXPECT_EQ(times.presents, 1);
        for (const gpu::Pass pass : {gpu::Pass::shadow_maps, gpu::Pass::shading,
                                     gpu::Pass::background, gpu::Pass::sum, gpu::Pass::display})
            EXPECT_GT(milliseconds(times, pass), 0)
                << gpu::pass_names()[static_cast<std::size_t>(pass)];
        EXPECT_EQ(milliseconds(times, gpu::Pass::surface_data) > 0,
                  surfaces == SurfacePass::deferred);
        EXPECT_EQ(milliseconds(times, gpu::Pass::ground), 0);
        EXPECT_EQ(milliseconds(times, gpu::Pass::blended), 0);
        double sum_ms = 0;
        for (const double s : times.seconds) sum_ms += 1000 * s;
        EXPECT_LE(sum_ms, passed_ms);
        // By the clock, what lies between the passes is the work of the processor alone.
        if (!times.by_device) {
            EXPECT_GT(sum_ms, 0.3 * passed_ms);
        }
    }
    renderer.measure_passes(false);
    renderer.add_sample();
    for (const double s : renderer.take_pass_times().seconds) EXPECT_EQ(s, 0);
}

TEST_F(Series, ShowsTheNearestPixelsInAWindowOfAnotherSize) {
    Renderer renderer(*context, scene_, &sky_);
    renderer.begin(camera(), settings());
    renderer.add_sample();
    const Window window(80, 60);
    renderer.present(window.framebuffer(), 80, 60, 0.0, ToneMap::aces);
    const Image small = to_display(renderer.picture(), 0.0, ToneMap::aces);
    Image large(80, 60, 4);
    for (int y = 0; y < 60; ++y)
        for (int x = 0; x < 80; ++x) std::copy_n(small.at(x / 2, y / 2), 4, large.at(x, y));
    EXPECT_TRUE(equal_pictures(window.shown(), large, 1.0 / 255));
}

TEST_F(Series, OfAnotherSizeDrawsAsManyPixels) {
    Renderer renderer(*context, scene_, &sky_);
    for (const int width : {24, 60, 24}) {
        RenderSettings o = settings(1);
        o.width = width;
        o.height = width / 2;
        renderer.begin(camera(), o);
        renderer.add_sample();
        Renderer fresh(*context, scene_, &sky_);
        fresh.begin(camera(), o);
        fresh.add_sample();
        EXPECT_TRUE(equal_pictures(renderer.picture(), fresh.picture())) << width;
    }
}

TEST_F(Series, BeginsAnewAfterAnEdit) {
    Renderer renderer(*context, scene_, &sky_);
    renderer.begin(camera(), settings());
    renderer.add_sample();
    renderer.add_sample();
    const Image before = renderer.picture();
    scene_.materials[1].base_color = {1, 0, 0, 1};
    renderer.update_material(1, scene_.materials[1]);
    EXPECT_EQ(renderer.samples_done(), 0);
    EXPECT_TRUE(equal_pictures(renderer.picture(), before));  // until the first sample
    renderer.add_sample();
    EXPECT_EQ(renderer.samples_done(), 1);
    Renderer fresh(*context, scene_, &sky_);
    fresh.begin(camera(), settings());
    fresh.add_sample();
    EXPECT_TRUE(equal_pictures(renderer.picture(), fresh.picture()));
}

TEST_F(Series, OfAnotherNumberOfLightsCompilesNothing) {
    RenderSettings o = settings(1);
    o.shadows = true;
    Renderer renderer(*context, scene_, &sky_);
    renderer.begin(camera(), o);
    renderer.add_sample();
    std::size_t compiled = context->programs().size();
    for (const std::size_t lights : {3U, 1U, 16U}) {
        scene_.lights.resize(lights, directional({0.2f, 1.0f, 0.5f}, {0.1f, 0.2f, 0.1f}));
        renderer.set_lights(scene_.lights);
        renderer.add_sample();
        EXPECT_EQ(context->programs().size(), compiled) << lights;
        const Image found = renderer.picture();
        Renderer fresh(*context, scene_, &sky_);
        EXPECT_TRUE(close_pictures(found, fresh.render(camera(), o), 1e-2, 1e-4)) << lights;
        // The programs of render are for its number of lights.
        compiled = context->programs().size();
    }
}

TEST_F(Series, ThatWasNotBegunIsRefusedInWords) {
    Renderer renderer(*context, scene_, &sky_);
    EXPECT_THROW(renderer.add_sample(), Error);
    EXPECT_THROW(renderer.picture(), Error);
    EXPECT_THROW(renderer.present(0, 8, 8, 0.0, ToneMap::linear), Error);
    EXPECT_THROW(renderer.begin(camera(), small_picture(0, 8)), Error);
    EXPECT_THROW(renderer.begin(camera(), small_picture(context->max_texture_size() + 1, 8)),
                 Error);
    renderer.begin(camera(), settings());
    EXPECT_THROW(renderer.present(0, 8, 8, 0.0, ToneMap::linear), Error);
}

}  // namespace
}  // namespace burnish::test
