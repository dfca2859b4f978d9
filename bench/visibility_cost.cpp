// What visibility costs: finding it, and a frame with it relative to one without.
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <string>

#include "bench/frame/interleave.hpp"
#include "burnish/context.hpp"
#include "burnish/environments.hpp"
#include "burnish/layered_materials.hpp"
#include "burnish/load_model.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/renderer.hpp"
#include "burnish/visibility.hpp"
#include "report.hpp"

namespace burnish::bench {
namespace {

constexpr int kTriangles = 102400;

Scene steel_torus() {
    Scene scene = load_model("builtin:torus", kTriangles);
    ParameterValues values;
    for (const auto& [name, value] :
         {std::pair{"metal", "steel"}, std::pair{"alpha_x", "0.1"}, std::pair{"alpha_y", "0.4"},
          std::pair{"normal_map", "builtin:bumps"}})
        values.set(name, value, "bench");
    apply_material_parameters(scene, values);
    return scene;
}

}  // namespace

void measure_visibility(Report& report) {
    using SteadyClock = std::chrono::steady_clock;
    gpu::Context context;
    report.device = context.renderer();
    const Scene scene = steel_torus();
    const auto environment = prepare_environment(load_environment("builtin:studio"));
    std::vector<double> found_s, lit_s;
    std::shared_ptr<const Visibility> visibility;
    for (int round = 0; round < 5; ++round) {
        const auto start = SteadyClock::now();
        VisibilityFinder finder(scene, {});
        const auto found = SteadyClock::now();
        visibility = finder.lit({environment, 1.0f, 0.0f, {}}, 2);
        found_s.push_back(std::chrono::duration<double>(found - start).count());
        lit_s.push_back(std::chrono::duration<double>(SteadyClock::now() - found).count());
    }
    const std::string size = fmt::format("{} k triangles", kTriangles / 1000);
    report.rows.push_back({fmt::format("visibility of {}", size), 3.0, median(found_s),
                           half_quartile_distance(found_s), "s"});
    report.rows.push_back({fmt::format("light between surfaces, two bounces, {}", size), 0.0,
                           median(lit_s), half_quartile_distance(lit_s), "s"});

    gpu::Renderer renderer(context);
    renderer.set_scene(scene);
    renderer.set_environment(environment);
    renderer.set_visibility(visibility);
    Camera camera;
    camera.position = {0.0f, 1.0f, 1.5f};
    RenderSettings settings;
    settings.width = 1280;
    settings.height = 720;
    settings.samples = 1;
    InterleaveOptions options;
    options.rounds = 15;
    options.sample_s = 0.1;
    for (const ImageLight light : {ImageLight::prefiltered, ImageLight::importance}) {
        settings.image_light = light;
        const RoundSamples samples = interleave(
            2, options,
            [&](std::size_t i, int frames) {
                settings.visibility = i == 0;
                return renderer.measure_frames(camera, settings, frames, frames > 1 ? 1 : 0,
                                               gpu::ShadingVariant::full);
            },
            [](double) {});
        const Estimate e = ratio(samples, 0, 1, Clock::wall).value();
        report.rows.push_back(
            {fmt::format("a frame with visibility against one without, {}, image light {}", size,
                         image_light_names()[static_cast<std::size_t>(light)]),
             1.1, e.median, e.spread, "x"});
    }
}

}  // namespace burnish::bench
