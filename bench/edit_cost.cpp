// Costs of edits of a scene on the device: one color among 100 materials relative to a frame, and
// an environment relative to loading it from its file.
#include <fmt/format.h>

#include <chrono>
#include <functional>
#include <glm/vec4.hpp>

#include "burnish/builtin_meshes.hpp"
#include "burnish/context.hpp"
#include "burnish/environments.hpp"
#include "burnish/image_io.hpp"
#include "burnish/prepared_environment.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/renderer.hpp"
#include "report.hpp"
#include "support/glb_writer.hpp"

namespace burnish::bench {

namespace {

constexpr int kRounds = 15;

double seconds_of(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// 10 x 10 spheres of 1024 triangles, each with its own material and normal map.
Scene hundred_materials() {
    Scene scene;
    scene.name = "hundred materials";
    scene.meshes = {make_builtin_mesh("sphere", 1024)};
    for (int i = 0; i < 100; ++i) {
        const float x = static_cast<float>(i % 10), y = static_cast<float>(i / 10);
        Material material;
        material.lobe = AlphaLobe{{0.1f + 0.04f * x, 0.1f + 0.04f * y}};
        material.base_color = glm::vec4(0.1f * x, 0.1f * y, 0.5f, 1.0f);
        scene.materials.push_back(material);
        Instance instance;
        instance.material = i;
        instance.transform[3] = glm::vec4(2.2f * x - 10.0f, 2.2f * y - 10.0f, 0.0f, 1.0f);
        scene.instances.push_back(instance);
    }
    scene.lights.resize(1);
    scene.lights[0].direction = {-0.4f, -0.6f, -0.7f};
    return scene;
}

Row ratio_row(std::string work, const std::vector<double>& ratios) {
    return {std::move(work), 1.0, median(ratios), half_quartile_distance(ratios), "x"};
}

}  // namespace

void measure_edits(Report& report) {
    gpu::Context context;
    report.device = context.renderer();
    Scene scene = hundred_materials();
    const Environment studio = load_environment("builtin:studio");
    gpu::Renderer renderer(context, scene, &studio);
    RenderSettings settings;
    settings.width = 640;
    settings.height = 360;
    settings.samples = 1;
    Camera camera;
    camera.position = {0.0f, 0.0f, 40.0f};
    renderer.begin(camera, settings);
    renderer.add_sample();
    std::vector<double> colors;
    for (int round = 0; round < kRounds; ++round) {
        const double edit = seconds_of([&] {
            Material& material = scene.materials[static_cast<std::size_t>(7 * round % 100)];
            material.base_color.r = 1.0f - material.base_color.r;
            renderer.update_material(7 * round % 100, material);
        });
        const double frame = renderer.time_frames(camera, settings, 1);
        colors.push_back(edit / frame);
    }
    report.rows.push_back(
        ratio_row("changing a color among 100 materials against a frame of 640x360", colors));

    const TemporaryFolder folder;
    const auto path = folder.path() / "studio.exr";
    write_image(path, studio.radiance, {});
    std::vector<double> environments;
    std::vector<double> preparations;
    for (int round = 0; round < kRounds; ++round) {
        Environment loaded;
        const double load = seconds_of([&] { loaded = load_environment(path.string()); });
        std::shared_ptr<const PreparedEnvironment> prepared;
        preparations.push_back(
            seconds_of([&] { prepared = prepare_environment(std::move(loaded)); }) / load);
        environments.push_back(seconds_of([&] { renderer.set_environment(prepared); }) / load);
    }
    report.rows.push_back(
        ratio_row(fmt::format("changing an environment of {}x{} against loading it from .exr",
                              studio.radiance.width, studio.radiance.height),
                  environments));
    // No budget: a thread prepares it while frames are drawn.
    Row preparation = ratio_row("preparing that environment against loading it", preparations);
    preparation.budget = 0.0;
    report.rows.push_back(std::move(preparation));
}

}  // namespace burnish::bench
