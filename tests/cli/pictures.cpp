#include "pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <memory>

#include "burnish/context.hpp"
#include "burnish/error.hpp"
#include "burnish/renderer.hpp"
#include "burnish/stage.hpp"
#include "support/test_folder.hpp"

namespace burnish::test {
namespace {

struct Gl {
    std::unique_ptr<gpu::Context> context;
    std::string trouble;
};

const Gl& gl() {
    static const Gl made = [] {
        Gl result;
        try {
            result.context = std::make_unique<gpu::Context>();
        } catch (const Error& error) {
            result.trouble = error.what();
        }
        return result;
    }();
    return made;
}

}  // namespace

gpu::Context* gl_context() {
    return gl().context.get();
}

const std::string& gl_trouble() {
    return gl().trouble;
}

std::filesystem::path sample(const std::string& below_data) {
    const std::filesystem::path folder = sample_data();
    if (folder.empty() || !std::filesystem::exists(folder / below_data)) return {};
    return folder / below_data;
}

std::string sample_model(const std::string& name) {
    return sample("models/" + name + "/glTF-Binary/" + name + ".glb").string();
}

Stage stage_of(const std::string& input, const std::string& environment,
               const std::vector<std::string>& lights, const Settings& settings) {
    StageRequest request;
    request.input = input;
    request.environment = environment;
    request.lights = lights;
    request.values.set("shadows", "false", "shadows");
    for (const auto& [name, text] : settings) request.values.set(name, text, name);
    return set_stage(request);
}

Projection project(const FittedCamera& camera, glm::dvec3 place) {
    const glm::dvec3 ahead = glm::normalize(camera.target - camera.eye);
    const glm::dvec3 right = glm::normalize(glm::cross(ahead, glm::dvec3(0, 1, 0)));
    const glm::dvec3 up = glm::cross(right, ahead);
    const glm::dvec3 d = place - camera.eye;
    const double px_per_metre = camera.focal_px / glm::dot(d, ahead);
    return {px_per_metre * glm::dvec2(glm::dot(d, right), -glm::dot(d, up)), px_per_metre};
}

Stage stage_of_screenshot(const std::string& model, const FittedCamera& camera) {
    const auto xyz = [](glm::dvec3 v) { return fmt::format("{},{},{}", v.x, v.y, v.z); };
    const double fov = glm::degrees(2 * std::atan(camera.height / 2.0 / camera.focal_px));
    return stage_of(model, "none", {"-45,45,1", "135,-45,0.5"},
                    {{"camera_position", xyz(camera.eye)},
                     {"camera_target", xyz(camera.target)},
                     {"camera_fov", fmt::format("{}", fov)},
                     {"width", std::to_string(camera.width)},
                     {"height", std::to_string(camera.height)},
                     {"samples", "8"}});
}

Image picture_of(const Stage& stage) {
    const Environment* environment =
        stage.environment.radiance.empty() ? nullptr : &stage.environment;
    gpu::Renderer renderer(*gl_context(), stage.scene, environment);
    return renderer.render(stage.camera, stage.settings);
}

Image shown_in_steps(const Image& linear, ToneMap tone_map) {
    Image shown = to_display(linear, 0.0, tone_map);
    for (float& value : shown.pixels) value = std::round(std::clamp(value, 0.0f, 1.0f) * 255.0f);
    return shown;
}

}  // namespace burnish::test
