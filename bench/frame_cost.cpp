// Frame cost: K11 Fig 11 and K12 Table I. A brushed torus, 1280x720, one directional light, one
// sub-pixel sample, no image light, on whatever runs the GL.
#include <fmt/format.h>

#include "gpu/renderer.hpp"
#include "report.hpp"
#include "scene/load.hpp"

namespace burnish::bench {

namespace {

using gpu::Renderer;
using gpu::ShadingVariant;

constexpr int kPairs = 15;
constexpr int kFrames = 6;

struct Setup {
    Scene scene;
    Camera camera;
    gpu::RenderOptions options;
};

Setup torus(int triangles) {
    Setup setup;
    setup.scene = load_model("builtin:torus", triangles);
    ParameterValues values;
    values.set("mdf", "ashikhmin-shirley", "bench");
    values.set("e_x", "200", "bench");
    values.set("e_y", "10", "bench");
    values.set("metal", "steel", "bench");
    values.set("normal_map", "builtin:bumps", "bench");
    apply_material_parameters(setup.scene, values);
    Light light;
    light.direction = {-0.4f, -0.6f, -0.7f};
    light.intensity = 3.0f;
    setup.scene.lights = {light};
    const Bounds bounds = bounds_of(setup.scene);
    setup.camera.target = bounds.center();
    // Near enough for the torus to cover a little over half of the picture.
    setup.camera.position =
        bounds.center() + glm::vec3{0.0f, 1.6f * bounds.radius(), 1.9f * bounds.radius()};
    setup.options.samples = 1;
    setup.options.image_light = gpu::ImageLight::off;
    setup.options.background = gpu::BackgroundKind::color;
    return setup;
}

struct Subject {
    Method method;
    ShadingVariant variant;
};

double seconds(Renderer& renderer, Setup& setup, const Subject& subject) {
    for (Material& material : setup.scene.materials) material.method = subject.method;
    renderer.set_materials(setup.scene.materials);
    return renderer.time_frames(setup.camera, setup.options, kFrames, subject.variant);
}

// Median and spread of subject/base over interleaved pairs, the order turned every time.
Row compare(Renderer& renderer, Setup& setup, const Subject& subject, const Subject& base) {
    seconds(renderer, setup, subject);  // compiles and warms both
    seconds(renderer, setup, base);
    std::vector<double> ratios;
    for (int i = 0; i < kPairs; ++i) {
        const bool subject_first = i % 2 == 0;
        const double first = seconds(renderer, setup, subject_first ? subject : base);
        const double second = seconds(renderer, setup, subject_first ? base : subject);
        ratios.push_back(subject_first ? first / second : second / first);
    }
    return {"", 0, median(ratios), half_quartile_distance(ratios), "x"};
}

}  // namespace

void measure_frames(Report& report) {
    gpu::Context context;
    report.device = context.renderer();
    const Subject normal_map{Method::normal_map, ShadingVariant::full};
    const Subject gouraud{Method::normal_map, ShadingVariant::gouraud};
    const Subject anisotropic{Method::none, ShadingVariant::anisotropic};
    for (const auto& [triangles, budget] : {std::pair{102400, 1.06}, std::pair{4096, 1.12}}) {
        Setup setup = torus(triangles);
        Renderer renderer(context, setup.scene, nullptr);
        const std::string size = fmt::format("{} k triangles", triangles / 1000);
        for (int m = static_cast<int>(Method::gram_schmidt);
             m <= static_cast<int>(Method::deform_smooth); ++m) {
            const auto method = static_cast<Method>(m);
            Row row = compare(renderer, setup, {method, ShadingVariant::full}, normal_map);
            row.work = fmt::format("{} against normal-map, {}", name_of(method), size);
            row.budget = budget;
            report.rows.push_back(row);
        }
        Row against_gouraud = compare(renderer, setup, normal_map, gouraud);
        against_gouraud.work = fmt::format("normal-map against Gouraud, {}", size);
        against_gouraud.budget = triangles > 100000 ? 2.0 : 0.0;
        report.rows.push_back(against_gouraud);
        Row aniso = compare(renderer, setup, anisotropic, gouraud);
        aniso.work = fmt::format("anisotropic without normal map against Gouraud, {}", size);
        report.rows.push_back(aniso);
    }
}

}  // namespace burnish::bench
