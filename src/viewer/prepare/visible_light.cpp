#include "viewer/prepare/visible_light.hpp"

#include <chrono>
#include <string_view>
#include <thread>

#include "burnish/error.hpp"

namespace burnish::viewer {
namespace {

// Nothing is known yet: every vertex sees everything. The renderer's programs are those that know.
std::shared_ptr<const Visibility> unknown(const Scene& scene) {
    auto none = std::make_shared<Visibility>();
    none->instances.resize(scene.instances.size());
    return none;
}

bool is_wanted(const Stage& stage) {
    return stage.settings.visibility && stage.settings.environment_intensity > 0.0f &&
           stage.settings.image_light != ImageLight::off;
}

// Progress whose steps wait while the work is held and not cancelled.
Progress progress_of(const CancelToken& token, const std::shared_ptr<std::atomic<bool>>& held) {
    const auto wait = [token, held](std::string_view, double) {
        while (held->load(std::memory_order_relaxed) && !token.cancelled())
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
    };
    return Progress(wait, token);
}

}  // namespace

VisibleLight::~VisibleLight() {
    token_.cancel();
    if (work_.valid()) work_.wait();
}

VisibleLight::Settings VisibleLight::settings_of(const Stage& stage) {
    const RenderSettings& o = stage.settings;
    Settings settings{
        o.environment_intensity, o.environment_rotation, o.bounces, o.visibility_rays, {}};
    for (const Material& material : stage.scene.materials)
        settings.sides.emplace_back(material.double_sided, material.alpha_mode == AlphaMode::blend);
    return settings;
}

void VisibleLight::forget() {
    token_.cancel();
    stale_ = work_.valid();
    finder_.reset();
    known_.reset();
}

void VisibleLight::follow(const Stage& stage,
                          std::shared_ptr<const PreparedEnvironment> environment, Change change,
                          gpu::Renderer& renderer) {
    if (environment == nullptr || !is_wanted(stage)) {
        forget();
        next_.reset();
        settings_ = {};
        return renderer.set_visibility(nullptr);
    }
    const Settings now = settings_of(stage);
    const bool due = next_ && next_->scene;  // a scene that was not begun
    const bool none = !finder_ && (!work_.valid() || stale_);
    const bool anew = change.geometry || due || none || now.rays != settings_.rays ||
                      now.sides != settings_.sides;
    const bool changed = anew || change.textures || change.materials || change.light ||
                         now != settings_ || next_.has_value();
    settings_ = now;
    if (anew) forget();
    if (anew || change.forgotten) renderer.set_visibility(known_ ? known_ : unknown(stage.scene));
    if (!changed) return;
    Request request;
    Scene scene = scene_for_visibility(stage.scene);
    request.textures = scene.textures;
    if (anew) request.scene = std::move(scene);
    request.materials = stage.scene.materials;
    request.lights = stage.scene.lights;
    request.environment = std::move(environment);
    request.settings = now;
    next_ = std::move(request);
}

VisibleLight::Found VisibleLight::find(std::unique_ptr<VisibilityFinder> finder,
                                       const Request& request, const Progress& progress) {
    try {
        if (request.scene)
            finder = std::make_unique<VisibilityFinder>(
                *request.scene, VisibilitySettings{request.settings.rays, true}, progress);
        else
            finder->set_materials(request.materials, request.textures);
        const SceneLight light{request.environment, request.settings.intensity,
                               request.settings.rotation, request.lights};
        auto visibility = finder->lit(light, request.settings.bounces, progress);
        return {std::move(finder), std::move(visibility)};
    } catch (const Interrupted&) {
        return {};
    }
}

void VisibleLight::step() {
    if (!next_ || work_.valid()) return;
    token_ = CancelToken();
    stale_ = false;
    work_ =
        std::async(std::launch::async, [finder = std::move(finder_), request = std::move(*next_),
                                        progress = progress_of(token_, held_)]() mutable {
            return find(std::move(finder), request, progress);
        });
    next_.reset();
}

void VisibleLight::finish(gpu::Renderer& renderer) {
    hold(false);
    while (working()) {
        step();
        work_.wait();
        give(renderer);
    }
}

bool VisibleLight::give(gpu::Renderer& renderer) {
    if (!work_.valid() || work_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return false;
    Found found = work_.get();
    if (std::exchange(stale_, false) || !found.visibility) return false;
    finder_ = std::move(found.finder);
    known_ = found.visibility;
    renderer.set_visibility(known_);
    return true;
}

}  // namespace burnish::viewer
