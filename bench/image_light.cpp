// Image light on a sphere with a map of one texel: errors relative to 4,096 samples and costs
// relative to 32 samples, in the cases of docs/evidence/image-light.md.
#include "image_light.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <glm/trigonometric.hpp>

#include "burnish/context.hpp"
#include "burnish/environments.hpp"
#include "burnish/render_settings.hpp"
#include "burnish/renderer.hpp"
#include "gpu/test_scene.hpp"
#include "report.hpp"

namespace burnish::bench {

namespace {

constexpr int kPairs = 9;

Scene tilted_sphere(const SphereCase& c) {
    Material m;
    m.mdf = c.mdf;
    m.method = c.method;
    m.lobe = AlphaLobe{c.alpha};
    Scene scene = test::one_object(test::uv_sphere(96, 48), m);
    const float t = glm::radians(c.tilt_deg);
    const glm::vec3 n(0.8f * std::sin(t), 0.6f * std::sin(t), std::cos(t));
    scene.textures.push_back(test::constant_texture(0.5f * n + 0.5f));
    scene.materials[0].normal_texture.texture = 0;
    return scene;
}

Camera camera_before_sphere() {
    Camera camera;
    camera.position = {0, 0, 8};
    camera.yfov = 2.0f * std::atan(1.02f / 8.0f);
    return camera;
}

RenderSettings picture(int side, ImageLight light, int samples) {
    RenderSettings o;
    o.shadows = false;
    o.width = o.height = side;
    o.samples = 1;
    o.image_light = light;
    o.image_light_samples = samples;
    o.background = BackgroundKind::color;
    o.background_color = glm::vec3(0.0f);
    return o;
}

// RMSE over the square around the sphere, all channels.
double rmse(const Image& a, const Image& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const double d = i % 4 == 3 ? 0.0 : double{a.pixels[i]} - double{b.pixels[i]};
        sum += d * d;
    }
    return std::sqrt(sum / (0.75 * static_cast<double>(a.pixels.size())));
}

RenderSettings plain_picture(int side, int samples) {
    RenderSettings o = picture(side, ImageLight::importance, samples);
    o.filter_image_samples = false;
    return o;
}

// Number of plain samples of the unfiltered environment with the error of the look-ups: 32 times a
// power of two, at most 1,024.
int plain_samples_for(gpu::Renderer& renderer) {
    const Camera camera = camera_before_sphere();
    const Image truth = renderer.render(camera, picture(40, ImageLight::importance, 4096));
    const double ours =
        rmse(renderer.render(camera, picture(40, ImageLight::prefiltered, 1)), truth);
    int samples = 32;
    while (samples < 1024 &&
           rmse(renderer.render(camera, plain_picture(40, samples)), truth) > ours) {
        samples *= 2;
    }
    return samples;
}

// Ratio of the look-ups' time to that of a plain loop with the same error.
Row speed_at_equal_error(gpu::Context& context, const Environment& environment, glm::vec2 alpha) {
    const SphereCase c{Mdf::ggx, Method::follow_grain, alpha, 30.0f};
    gpu::Renderer renderer(context, tilted_sphere(c), &environment);
    const int samples = plain_samples_for(renderer);
    const Camera camera = camera_before_sphere();
    std::vector<double> ratios;
    for (int i = 0; i < 5; ++i) {
        const double plain = renderer.time_frames(camera, plain_picture(200, samples), 1);
        ratios.push_back(renderer.time_frames(camera, picture(200, ImageLight::prefiltered, 1), 8) /
                         8 / plain);
    }
    const std::string work = fmt::format(
        "image light, prefiltered: time over {} plain samples (as exact{}), {}, alphas {}, {}",
        samples, samples == 1024 ? " or less" : "",
        std::filesystem::path(environment.name).stem().string(), alpha.x, alpha.y);
    return {work, 0.125, median(ratios), half_quartile_distance(ratios), "x"};
}

// Ratio of the time of 32 samples to that of `light`.
Row speed(gpu::Context& context, const Environment& environment, Mdf mdf) {
    const SphereCase c{mdf, Method::follow_grain, {0.1f, 0.4f}, 20.0f};
    gpu::Renderer renderer(context, tilted_sphere(c), &environment);
    const Camera camera = camera_before_sphere();
    const auto plain = picture(480, ImageLight::importance, 32);
    const auto ours = picture(480, ImageLight::prefiltered, 1);
    std::vector<double> ratios;
    for (int i = 0; i < kPairs; ++i) {
        const double slow = renderer.time_frames(camera, plain, 1);
        ratios.push_back(4.0 * slow / renderer.time_frames(camera, ours, 4));
    }
    return {"", 0, median(ratios), half_quartile_distance(ratios), "x"};
}

}  // namespace

std::vector<Environment> sample_environments() {
    const char* data = std::getenv("BURNISH_DATA");
    const std::filesystem::path folder =
        std::filesystem::path(data != nullptr ? data : BURNISH_SOURCE_DIR "/../shared/data") /
        "environments";
    std::vector<Environment> list;
    for (const char* name : {"venice_sunset_1k.hdr", "royal_esplanade_1k.hdr"}) {
        if (std::filesystem::exists(folder / name)) {
            list.push_back(load_environment((folder / name).string()));
        }
    }
    return list;
}

SphereErrors sphere_errors(gpu::Context& context, const Environment& environment,
                           const SphereCase& c) {
    gpu::Renderer renderer(context, tilted_sphere(c), &environment);
    const auto seen = [&](ImageLight light, int samples) {
        return renderer.render(camera_before_sphere(), picture(40, light, samples));
    };
    const Image truth = seen(ImageLight::importance, 4096);
    return {rmse(seen(ImageLight::bent_normal, 1), truth),
            rmse(seen(ImageLight::importance, 32), truth),
            rmse(seen(ImageLight::prefiltered, 1), truth)};
}

void measure_image_light(Report& report) {
    gpu::Context context;
    const std::vector<Environment> environments = sample_environments();
    if (environments.empty()) return;
    double lowest = 1e9;
    for (const Environment& environment : environments) {
        for (const glm::vec2 alpha : {glm::vec2(0.1f, 0.4f), glm::vec2(0.2f, 0.6f)}) {
            for (const float tilt : {0.0f, 15.0f, 30.0f, 45.0f}) {
                const SphereErrors e = sphere_errors(context, environment,
                                                     {Mdf::ggx, Method::follow_grain, alpha, tilt});
                lowest = std::min(lowest, e.bent_normal / e.prefiltered);
            }
        }
    }
    report.rows.push_back({"image light, prefiltered: error over the bent normal's, worst case",
                           0.25, 1.0 / lowest, 0, "x"});
    for (const Mdf mdf : {Mdf::ggx, Mdf::ashikhmin_shirley}) {
        Row row = speed(context, environments.front(), mdf);
        row.work = fmt::format("image light, prefiltered: time over 32 filtered samples, {}",
                               name_of(mdf));
        row.spread /= row.reached * row.reached;
        row.reached = 1.0 / row.reached;
        report.rows.push_back(row);
    }
    for (const Environment& environment : environments) {
        for (const glm::vec2 alpha : {glm::vec2(0.1f, 0.4f), glm::vec2(0.2f, 0.6f)}) {
            report.rows.push_back(speed_at_equal_error(context, environment, alpha));
        }
    }
}

}  // namespace burnish::bench
