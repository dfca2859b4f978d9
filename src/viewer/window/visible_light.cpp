#include "viewer/window/visible_light.hpp"

#include <chrono>
#include <utility>

#include "burnish/error.hpp"

namespace burnish::viewer {
namespace {

// Nothing is known yet: every vertex sees everything. Programs are those that know.
std::shared_ptr<const Visibility> unknown(const Scene& scene) {
    auto none = std::make_shared<Visibility>();
    none->instances.resize(scene.instances.size());
    return none;
}

}  // namespace

VisibleLight::~VisibleLight() {
    token_.cancel();
    if (work_.valid()) work_.wait();
}

void VisibleLight::follow(const Stage& stage, std::shared_ptr<const PreparedEnvironment> environment,
                          const Change& change, gpu::Renderer& renderer) {
    const bool wanted = stage.settings.visibility && environment != nullptr &&
                        stage.settings.environment_intensity > 0.0f &&
                        stage.settings.image_light != ImageLight::off;
    if (!wanted) {
        token_.cancel();
        stale_ = work_.valid();
        next_.reset();
        finder_.reset();
        return renderer.set_visibility(nullptr);
    }
    const bool anew = change.scene || (!finder_ && !work_.valid()) ||
                      (next_.has_value() && next_->scene.has_value());
    if (!anew && !change.materials && !change.light && !next_) return;
    Request request;
    if (anew) {
        token_.cancel();
        stale_ = work_.valid();
        finder_.reset();
        request.scene = scene_for_visibility(stage.scene);
        textures_ = request.scene->textures;
        renderer.set_visibility(unknown(stage.scene));
    }
    request.materials = stage.scene.materials;
    request.textures = textures_;
    request.lights = stage.scene.lights;
    request.environment = std::move(environment);
    request.intensity = stage.settings.environment_intensity;
    request.rotation = stage.settings.environment_rotation;
    request.bounces = stage.values.integer("bounces");
    request.settings.rays = stage.values.integer("visibility_rays");
    next_ = std::move(request);
}

VisibleLight::Found VisibleLight::find(std::unique_ptr<VisibilityFinder> finder, const Request& request,
                                       const Progress& progress) {
    try {
        if (request.scene)
            finder = std::make_unique<VisibilityFinder>(*request.scene, request.settings, progress);
        else
            finder->set_materials(request.materials, request.textures);
        auto visibility =
            finder->lit({request.environment, request.intensity, request.rotation, request.lights},
                        request.bounces, progress);
        return {std::move(finder), std::move(visibility)};
    } catch (const Interrupted&) {
        return {};
    }
}

void VisibleLight::step() {
    if (!next_ || work_.valid()) return;
    token_ = CancelToken();
    stale_ = false;
    work_ = std::async(std::launch::async,
                       [finder = std::move(finder_), request = std::move(*next_),
                        progress = Progress(token_)]() mutable {
                           return find(std::move(finder), request, progress);
                       });
    next_.reset();
}

bool VisibleLight::give(gpu::Renderer& renderer) {
    if (!work_.valid() || work_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return false;
    Found found = work_.get();
    if (std::exchange(stale_, false) || !found.visibility) return false;
    finder_ = std::move(found.finder);
    renderer.set_visibility(found.visibility);
    return true;
}

}  // namespace burnish::viewer
