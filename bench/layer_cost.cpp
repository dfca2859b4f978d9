// Ratio of the frame times of a surface under a layer and of the surface alone: the same torus, brushed and bumped, one
// sample a pixel, under one light, under samples of the environment and under its look-ups.
#include <fmt/format.h>

#include <memory>
#include <string>

#include "bench/frame/interleave.hpp"
#include "burnish/context.hpp"
#include "burnish/environments.hpp"
#include "burnish/layered_materials.hpp"
#include "burnish/load_model.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/renderer.hpp"
#include "report.hpp"

namespace burnish::bench {

namespace {

constexpr int kTriangles = 102400;

struct Layer {
    const char* name;
    std::vector<std::pair<const char*, const char*>> values;
    double budget;
};

const Layer kLayers[] = {
    {"clear coat", {{"coat", "1"}}, 1.5},
    {"tinted coat", {{"coat", "1"}, {"coat_tint", "0.8,0.3,0.1"}, {"coat_roughness", "0.2"}}, 1.5},
    {"sheen", {{"sheen_color", "0.4,0.3,0.3"}, {"sheen_roughness", "0.5"}}, 0.0}};

Scene bare_scene() {
    Scene scene = load_model("builtin:torus", kTriangles);
    ParameterValues values;
    values.set("alpha_x", "0.2", "bench");
    values.set("alpha_y", "0.45", "bench");
    values.set("metallic", "0.5", "bench");
    values.set("method", "follow-grain", "bench");
    values.set("normal_map", "builtin:bumps", "bench");
    apply_material_parameters(scene, values);
    return scene;
}

Scene layered_scene(const Layer& layer) {
    Scene scene = bare_scene();
    ParameterValues values;
    for (const auto& [name, value] : layer.values) values.set(name, value, "bench");
    apply_material_parameters(scene, values);
    return scene;
}

class LitSubject {
  public:
    LitSubject(gpu::Context& context, Scene scene, ImageLight light, const Environment& studio)
        : scene_(with_light(std::move(scene), light)),
          renderer_(context, scene_, light == ImageLight::off ? nullptr : &studio) {
        const Bounds bounds = bounds_of(scene_);
        camera_.target = bounds.center();
        camera_.position =
            bounds.center() + glm::vec3{0.0f, 1.6f * bounds.radius(), 1.9f * bounds.radius()};
        options_.width = 1280;
        options_.height = 720;
        options_.samples = 1;
        options_.image_light = light;
        options_.background = BackgroundKind::color;
        options_.shadows = false;
    }

    gpu::FrameTimes time(int frames) {
        return renderer_.measure_frames(camera_, options_, frames, frames > 1 ? 1 : 0,
                                        gpu::ShadingVariant::full);
    }

  private:
    static Scene with_light(Scene scene, ImageLight light) {
        Light one;
        one.direction = {-0.4f, -0.6f, -0.7f};
        one.intensity = 3.0f;
        if (light == ImageLight::off) scene.lights = {one};
        return scene;
    }

    Scene scene_;
    Camera camera_;
    RenderSettings options_;
    gpu::Renderer renderer_;
};

}  // namespace

void measure_layers(Report& report) {
    gpu::Context context;
    report.device = context.renderer();
    InterleaveOptions options;
    options.rounds = 15;
    options.sample_s = 0.1;
    const Environment studio = load_environment("builtin:studio");
    constexpr std::pair<ImageLight, const char*> kLights[] = {
        {ImageLight::off, "one light"},
        {ImageLight::importance, "importance"},
        {ImageLight::prefiltered, "prefiltered"}};
    for (const auto& [light, light_name] : kLights) {
        LitSubject bare(context, bare_scene(), light, studio);
        for (const Layer& layer : kLayers) {
            LitSubject layered(context, layered_scene(layer), light, studio);
            LitSubject* const subjects[] = {&layered, &bare};
            const RoundSamples samples = interleave(
                2, options, [&](std::size_t i, int frames) { return subjects[i]->time(frames); },
                [](double) {});
            const Estimate e = ratio(samples, 0, 1, Clock::wall).value();
            report.rows.push_back({fmt::format("{} against none, {}", layer.name, light_name),
                                   layer.budget, e.median, e.spread, "x"});
        }
    }
}

}  // namespace burnish::bench
