// A scene whose frames are timed from above, 1280x720, one sample a pixel.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "burnish/context.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/renderer.hpp"
#include "burnish/scene.hpp"
#include "report.hpp"

namespace burnish::bench {

class FrameSubject {
  public:
    // `environment`: null for ImageLight::off.
    FrameSubject(gpu::Context& context, Scene scene, ImageLight light = ImageLight::off,
                 const Environment* environment = nullptr);
    gpu::FrameTimes time(int frames);
    gpu::Renderer& renderer() { return renderer_; }

  private:
    Scene scene_;
    Camera camera_;
    RenderSettings options_;
    gpu::Renderer renderer_;
};

// Median and spread of the ratio of the frame times of two subjects, interleaved.
Row ratio_of(FrameSubject& subject, FrameSubject& base, std::string work, double budget);

// The built-in torus under parameters of a material.
using Values = std::vector<std::pair<const char*, const char*>>;
Scene torus_with(int triangles, const Values& values);

// Directional, from above.
Light lamp_from_above();

}  // namespace burnish::bench
