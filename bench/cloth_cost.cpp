// Ratio of the frame times of procedural cloth and a textured normal map: the same torus, lobe and
// method, one light, one sample per pixel.
#include <fmt/format.h>

#include <string>

#include "bench/frame/interleave.hpp"
#include "burnish/context.hpp"
#include "burnish/layered_materials.hpp"
#include "burnish/load_model.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/renderer.hpp"
#include "report.hpp"

namespace burnish::bench {

namespace {

// Distances from close (a pixel shows a point of a yarn) to far (a pixel shows the mean of many
// yarns). The camera stays, so that all frames cover equally many pixels.
struct Distance {
    const char* name;
    const char* yarns;
};
constexpr Distance kDistances[] = {
    {"close, points of yarns", "24"}, {"yarns of about two pixels", "320"}, {"far, means", "6000"}};

Scene make_scene(int triangles, const char* detail, const char* value, const char* yarns) {
    Scene scene = load_model("builtin:torus", triangles);
    ParameterValues values;
    values.set("mdf", "ggx", "bench");
    values.set("alpha_x", "0.2", "bench");
    values.set("alpha_y", "0.45", "bench");
    values.set("metallic", "0", "bench");
    values.set("method", "follow-grain", "bench");
    values.set(detail, value, "bench");
    if (yarns) values.set("weave_yarns", yarns, "bench");
    apply_material_parameters(scene, values);
    Light light;
    light.direction = {-0.4f, -0.6f, -0.7f};
    light.intensity = 3.0f;
    scene.lights = {light};
    return scene;
}

class Subject {
  public:
    Subject(gpu::Context& context, Scene scene)
        : scene_(std::move(scene)), renderer_(context, scene_, nullptr) {
        const Bounds bounds = bounds_of(scene_);
        camera_.target = bounds.center();
        camera_.position =
            bounds.center() + glm::vec3{0.0f, 1.6f * bounds.radius(), 1.9f * bounds.radius()};
        options_.width = 1280;
        options_.height = 720;
        options_.samples = 1;
        options_.image_light = ImageLight::off;
        options_.background = BackgroundKind::color;
        options_.shadows = false;
    }

    gpu::FrameTimes time(int frames) {
        return renderer_.measure_frames(camera_, options_, frames, frames > 1 ? 1 : 0,
                                        gpu::ShadingVariant::full);
    }

  private:
    Scene scene_;
    Camera camera_;
    RenderSettings options_;
    gpu::Renderer renderer_;
};

}  // namespace

void measure_cloth(Report& report) {
    gpu::Context context;
    report.device = context.renderer();
    InterleaveOptions options;
    options.rounds = 15;
    options.sample_s = 0.1;
    for (const int triangles : {102400, 4096}) {
        Subject map(context, make_scene(triangles, "normal_map", "builtin:bumps", nullptr));
        for (const Distance& distance : kDistances) {
            Subject cloth(context, make_scene(triangles, "weave", "twill-2-2", distance.yarns));
            Subject* const subjects[] = {&cloth, &map};
            const RoundSamples samples = interleave(
                2, options, [&](std::size_t i, int frames) { return subjects[i]->time(frames); },
                [](double) {});
            const Estimate e = ratio(samples, 0, 1, Clock::wall).value();
            report.rows.push_back({fmt::format("cloth against a normal map, {} k triangles: {}",
                                               triangles / 1000, distance.name),
                                   1.5, e.median, e.spread, "x"});
        }
    }
}

}  // namespace burnish::bench
