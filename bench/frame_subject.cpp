#include "frame_subject.hpp"

#include <utility>

#include "bench/frame/interleave.hpp"
#include "burnish/layered_materials.hpp"
#include "burnish/load_model.hpp"

namespace burnish::bench {

FrameSubject::FrameSubject(gpu::Context& context, Scene scene, ImageLight light,
                           const Environment* environment)
    : scene_(std::move(scene)), renderer_(context, scene_, environment) {
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

gpu::FrameTimes FrameSubject::time(int frames) {
    return renderer_.measure_frames(camera_, options_, frames, frames > 1 ? 1 : 0,
                                    gpu::ShadingVariant::full);
}

Row ratio_of(FrameSubject& subject, FrameSubject& base, std::string work, double budget) {
    InterleaveOptions options;
    options.rounds = 15;
    options.sample_s = 0.1;
    FrameSubject* const subjects[] = {&subject, &base};
    const RoundSamples samples = interleave(
        2, options, [&](std::size_t i, int frames) { return subjects[i]->time(frames); },
        [](double) {});
    const Estimate e = ratio(samples, 0, 1, Clock::wall).value();
    return {std::move(work), budget, e.median, e.spread, "x"};
}

Scene torus_with(int triangles, const Values& list) {
    Scene scene = load_model("builtin:torus", triangles);
    ParameterValues values;
    for (const auto& [name, value] : list) values.set(name, value, "bench");
    apply_material_parameters(scene, values);
    return scene;
}

Light lamp_from_above() {
    Light light;
    light.direction = {-0.4f, -0.6f, -0.7f};
    light.intensity = 3.0f;
    return light;
}

}  // namespace burnish::bench
