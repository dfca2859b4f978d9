// Ratio of the frame times of a surface under a layer and of the surface alone: the same torus, brushed and bumped, one
// sample a pixel, under one light, under samples of the environment and under its look-ups.
#include <fmt/format.h>

#include <utility>

#include "burnish/environments.hpp"
#include "frame_subject.hpp"

namespace burnish::bench {

namespace {

constexpr int kTriangles = 102400;

struct Layer {
    const char* name;
    Values values;
    double budget;
};

const Layer kLayers[] = {
    {"clear coat", {{"coat", "1"}}, 1.5},
    {"tinted coat", {{"coat", "1"}, {"coat_tint", "0.8,0.3,0.1"}, {"coat_roughness", "0.2"}}, 1.5},
    {"sheen", {{"sheen_color", "0.4,0.3,0.3"}, {"sheen_roughness", "0.5"}}, 0.0}};

Scene scene_under(ImageLight light, const Values& layer) {
    Values values = {{"alpha_x", "0.2"},
                     {"alpha_y", "0.45"},
                     {"metallic", "0.5"},
                     {"method", "follow-grain"},
                     {"normal_map", "builtin:bumps"}};
    values.insert(values.end(), layer.begin(), layer.end());
    Scene scene = torus_with(kTriangles, values);
    if (light == ImageLight::off) scene.lights = {lamp_from_above()};
    return scene;
}

}  // namespace

void measure_layers(Report& report) {
    gpu::Context context;
    report.device = context.renderer();
    const Environment studio = load_environment("builtin:studio");
    constexpr std::pair<ImageLight, const char*> kLights[] = {
        {ImageLight::off, "one light"},
        {ImageLight::importance, "importance"},
        {ImageLight::prefiltered, "prefiltered"}};
    for (const auto& [light, light_name] : kLights) {
        const Environment* sky = light == ImageLight::off ? nullptr : &studio;
        FrameSubject bare(context, scene_under(light, {}), light, sky);
        for (const Layer& layer : kLayers) {
            FrameSubject layered(context, scene_under(light, layer.values), light, sky);
            report.rows.push_back(
                ratio_of(layered, bare, fmt::format("{} against none, {}", layer.name, light_name),
                         layer.budget));
        }
    }
}

}  // namespace burnish::bench
