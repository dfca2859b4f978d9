#include "bench/frame/frame_bench.hpp"

#include <fmt/format.h>

#include <array>
#include <map>

#include "bench/frame/frame_tabulated.hpp"
#include "burnish/context.hpp"
#include "burnish/environments.hpp"
#include "burnish/error.hpp"
#include "burnish/layered_materials.hpp"
#include "burnish/load_model.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/renderer.hpp"
#include "core/memory.hpp"
#include "core/text.hpp"

namespace burnish {

namespace {

using gpu::ShadingVariant;

constexpr Technique by_method(Method method, std::string_view name) {
    return {name, method, ShadingVariant::full, ImageLight::off, BenchMaterial::steel};
}

constexpr Technique by_image(std::string_view name, ImageLight light) {
    return {name, Method::follow_grain, ShadingVariant::full, light, BenchMaterial::steel};
}

constexpr Technique by_table(std::string_view name, BenchMaterial material) {
    return {name, Method::follow_grain, ShadingVariant::full, ImageLight::off, material};
}

constexpr std::array<Technique, 17> kTechniques = {{
    {"gouraud", Method::normal_map, ShadingVariant::gouraud, ImageLight::off, BenchMaterial::steel},
    {"aniso", Method::none, ShadingVariant::anisotropic, ImageLight::off, BenchMaterial::steel},
    by_method(Method::normal_map, "normal-map"),
    by_method(Method::gram_schmidt, "gram-schmidt"),
    by_method(Method::rotate_exact, "rotate-exact"),
    by_method(Method::rotate_approx, "rotate-approx"),
    by_method(Method::rotate_arc, "rotate-arc"),
    by_method(Method::follow_grain, "follow-grain"),
    by_method(Method::deform_linear, "deform-linear"),
    by_method(Method::deform_smooth, "deform-smooth"),
    by_method(Method::slope_shift, "slope-shift"),
    by_method(Method::stretch, "stretch"),
    by_image("image-importance", ImageLight::importance),
    by_image("image-prefiltered", ImageLight::prefiltered),
    by_image("image-bent-normal", ImageLight::bent_normal),
    by_table("tabulated", BenchMaterial::texels),
    by_table("tabulated-one", BenchMaterial::one_texel),
}};

constexpr const char* kMesh = "builtin:torus";
constexpr const char* kNormalMap = "builtin:bumps";
constexpr const char* kEnvironment = "builtin:studio";

Scene make_scene(int triangles) {
    Scene scene = load_model(kMesh, triangles);
    ParameterValues values;
    values.set("mdf", "ashikhmin-shirley", "bench");
    values.set("e_x", "200", "bench");
    values.set("e_y", "10", "bench");
    values.set("metal", "steel", "bench");
    values.set("normal_map", kNormalMap, "bench");
    apply_material_parameters(scene, values);
    Light light;
    light.direction = {-0.4f, -0.6f, -0.7f};
    light.intensity = 3.0f;
    scene.lights = {light};
    // A material that is not on the mesh. It makes the renderer load the normal map for tables,
    // without the moments that widen lobes.
    scene.materials.push_back(scene.materials[0]);
    scene.materials.back().normal_filter = NormalFilter::mips;
    return scene;
}

// A camera for which the torus covers slightly more than a quarter of a 16:9 picture.
Camera camera_on(const Scene& scene) {
    Camera camera;
    const Bounds bounds = bounds_of(scene);
    camera.target = bounds.center();
    camera.position =
        bounds.center() + glm::vec3{0.0f, 1.6f * bounds.radius(), 1.9f * bounds.radius()};
    return camera;
}

RenderSettings options_for(const FrameCase& frame_case) {
    RenderSettings options;
    options.width = frame_case.width;
    options.height = frame_case.height;
    options.samples = 1;
    options.image_light = ImageLight::off;
    options.background = BackgroundKind::color;
    options.shadows = false;
    return options;
}

std::string size_text(int width, int height) {
    return fmt::format("{}x{}", width, height);
}

}  // namespace

std::span<const Technique> techniques() {
    return kTechniques;
}

const Technique& technique_named(std::string_view name, std::string_view where) {
    std::vector<std::string_view> names;
    names.reserve(kTechniques.size());
    for (const Technique& technique : kTechniques) names.push_back(technique.name);
    const int index = index_of_name(names, name, "technique", where);
    return kTechniques[static_cast<std::size_t>(index)];
}

void require_size(const gpu::Context& context, const FrameCase& frame_case) {
    const int most = context.max_texture_size();
    const std::string found = size_text(frame_case.width, frame_case.height);
    if (frame_case.width > most || frame_case.height > most)
        throw Error("picture size", "",
                    fmt::format("at most {} on {}", size_text(most, most), context.renderer()),
                    found);
    if (!context.is_software()) return;  // a driver of a device reports its own limits
    // Bytes per pixel: color 16, depth 4, two sums 32, surface 16 and 16 (gpu/targets.hpp), and a
    // margin of a fifth.
    constexpr std::uint64_t kBytesPerPixel = 101;
    const std::uint64_t needed = kBytesPerPixel * static_cast<std::uint64_t>(frame_case.width) *
                                 static_cast<std::uint64_t>(frame_case.height);
    const std::uint64_t there = available_memory();
    if (needed > there)
        throw Error("picture size", "",
                    fmt::format("a picture that fits {} MB of memory", there >> 20),
                    fmt::format("{}, which takes {} MB", found, needed >> 20));
}

FrameSubject frame_subject() {
    return {kMesh,
            "steel, ashikhmin-shirley e_x 200, e_y 10",
            kNormalMap,
            "one directional light, no shadows",
            kEnvironment,
            "4 exemplars of 32 x 96 on 64 x 64 texels, and one on one texel",
            RenderSettings{}.image_light_samples};
}

struct FrameBench::Stage {
    Stage(gpu::Context& context, const FrameCase& frame_case, bool image_light)
        : scene(make_scene(frame_case.triangles)),
          camera(camera_on(scene)),
          options(options_for(frame_case)),
          steel(scene.materials[0]),
          environment(image_light ? load_environment(kEnvironment) : Environment{}),
          renderer(context, scene, image_light ? &environment : nullptr) {}

    // A tabulated material is made at its first use.
    Material material_of(const Technique& technique) {
        Material material = steel;
        material.method = technique.method;
        if (!technique.tabulated()) return material;
        std::shared_ptr<const TabulatedMaterial>& table = tables[technique.material];
        if (!table) {
            table = std::make_shared<const TabulatedMaterial>(
                technique.material == BenchMaterial::one_texel ? bench_material_of_one()
                                                               : bench_material_of_texels());
        }
        material.lobe = Tabulated{table, {}};
        return material;
    }

    std::size_t count_covered() {
        RenderSettings plain = options;
        plain.background = BackgroundKind::transparent;
        const Image image = renderer.render(camera, plain);
        std::size_t count = 0;
        for (std::size_t i = 3; i < image.pixels.size(); i += 4) count += image.pixels[i] > 0.5f;
        return count;
    }

    Scene scene;
    Camera camera;
    RenderSettings options;
    Material steel;
    std::map<BenchMaterial, std::shared_ptr<const TabulatedMaterial>> tables;
    Environment environment;
    gpu::Renderer renderer;
};

FrameBench::FrameBench(gpu::Context& context, const FrameCase& frame_case, bool image_light) {
    require_size(context, frame_case);
    stage_ = std::make_unique<Stage>(context, frame_case, image_light);
    for (const Instance& instance : stage_->scene.instances)
        triangles_ +=
            stage_->scene.meshes[static_cast<std::size_t>(instance.mesh)].indices.size() / 3;
    covered_ = stage_->count_covered();
}

FrameBench::~FrameBench() = default;

gpu::FrameTimes FrameBench::time(const Technique& technique, int frames) {
    if (technique.lit_by_image() && stage_->environment.radiance.empty())
        throw Error(std::string(technique.name), "", "a bench made with image light",
                    "one without");
    stage_->scene.materials.assign(stage_->scene.materials.size(), stage_->material_of(technique));
    stage_->renderer.set_materials(stage_->scene.materials);
    stage_->options.image_light = technique.image_light;
    // No warm-up for a single frame: it is as long as a sample, so that the initial state matters
    // little.
    const int warm_up = frames > 1 ? 1 : 0;
    return stage_->renderer.measure_frames(stage_->camera, stage_->options, frames, warm_up,
                                           technique.variant);
}

RoundSamples FrameBench::interleave(std::span<const Technique* const> subjects,
                                    const InterleaveOptions& options,
                                    const std::function<void(double)>& tick) {
    return burnish::interleave(
        subjects.size(), options,
        [&](std::size_t subject, int frames) { return time(*subjects[subject], frames); }, tick);
}

}  // namespace burnish
