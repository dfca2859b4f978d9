// Ratio of the frame times under a rectangle light and under a point light: the bench's torus of brushed steel with a
// bump map, no shadows, one sample per pixel.
#include <fmt/format.h>

#include <memory>
#include <vector>

#include "bench/frame/interleave.hpp"
#include "burnish/context.hpp"
#include "burnish/layered_materials.hpp"
#include "burnish/load_model.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/renderer.hpp"
#include "report.hpp"

namespace burnish::bench {

namespace {

Light light_of(LightType type) {
    Light light;
    light.type = type;
    light.position = {1.0f, 1.5f, 1.8f};
    light.direction = {-0.40f, -0.60f, -0.69f};
    light.size = {1.0f, 0.5f};
    light.intensity = 5.0f;
    light.visible = false;
    return light;
}

Scene torus_under(LightType type) {
    Scene scene = load_model("builtin:torus", 102400);
    ParameterValues values;
    values.set("mdf", "ggx", "bench");
    values.set("alpha_x", "0.1", "bench");
    values.set("alpha_y", "0.4", "bench");
    values.set("metal", "steel", "bench");
    values.set("normal_map", "builtin:bumps", "bench");
    apply_material_parameters(scene, values);
    scene.lights = {light_of(type)};
    return scene;
}

RenderSettings settings() {
    RenderSettings options;
    options.width = 1280;
    options.height = 720;
    options.samples = 1;
    options.image_light = ImageLight::off;
    options.background = BackgroundKind::color;
    options.shadows = false;
    return options;
}

}  // namespace

void measure_area_lights(Report& report) {
    gpu::Context context;
    const Scene rectangle = torus_under(LightType::rectangle),
                point = torus_under(LightType::point);
    Camera camera;
    const Bounds bounds = bounds_of(point);
    camera.target = bounds.center();
    camera.position =
        bounds.center() + glm::vec3(0.0f, 1.6f * bounds.radius(), 1.9f * bounds.radius());
    gpu::Renderer under_rectangle(context, rectangle, nullptr),
        under_point(context, point, nullptr);
    const RoundSamples samples = interleave(
        2, {},
        [&](std::size_t subject, int frames) {
            gpu::Renderer& renderer = subject == 0 ? under_rectangle : under_point;
            return renderer.measure_frames(camera, settings(), frames, frames > 1 ? 1 : 0,
                                           gpu::ShadingVariant::full);
        },
        [](double) {});
    const Estimate e = ratio(samples, 0, 1, Clock::wall).value();
    report.rows.push_back(
        {"a rectangle light against a point light, 1280x720", 1.6, e.median, e.spread, "x"});
}

}  // namespace burnish::bench
