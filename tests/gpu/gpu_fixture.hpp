// Tests that need an OpenGL context: skipped with a message where there is none.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "burnish/context.hpp"
#include "burnish/error.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/renderer.hpp"
#include "support/picture_checks.hpp"

namespace burnish::test {

class GpuTest : public testing::Test {
  protected:
    void SetUp() override {
        try {
            context = std::make_unique<gpu::Context>();
        } catch (const Error& error) {
            GTEST_SKIP() << "SKIPPED, nothing was tested: " << error.what();
        }
    }

    std::unique_ptr<gpu::Context> context;
};

// A camera at distance `z` on +z that sees half a height of 1 at the origin.
inline Camera camera_on_z(float z = 4.0f, float half_height = 1.0f) {
    Camera camera;
    camera.position = {0.0f, 0.0f, z};
    camera.yfov = 2.0f * std::atan(half_height / z);
    return camera;
}

inline RenderSettings small_picture(int width = 48, int height = 48, int samples = 1) {
    RenderSettings options;
    options.shadows = false;
    options.width = width;
    options.height = height;
    options.samples = samples;
    options.background = BackgroundKind::color;
    options.background_color = glm::vec3(0.0f);
    return options;
}

inline glm::vec3 rgb(const Image& image, int x, int y) {
    const float* p = image.at(x, y);
    return {p[0], p[1], p[2]};
}

}  // namespace burnish::test
