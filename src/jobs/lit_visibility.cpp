#include "jobs/lit_visibility.hpp"

#include <utility>

namespace burnish {

LitVisibility::LitVisibility(const Stage& stage,
                             std::shared_ptr<const PreparedEnvironment> environment,
                             const Progress& progress)
    : environment_(std::move(environment)),
      intensity_(stage.settings.environment_intensity),
      bounces_(stage.settings.bounces) {
    const bool lit =
        environment_ && intensity_ > 0.0f && stage.settings.image_light != ImageLight::off;
    if (!lit || !stage.settings.visibility) return;
    VisibilitySettings settings;
    settings.rays = stage.settings.visibility_rays;
    finder_.emplace(stage.scene, settings, progress);
    warnings_ = finder_->visibility()->warnings;
}

std::shared_ptr<const Visibility> LitVisibility::lit(std::span<const Light> lights,
                                                     float environment_rotation,
                                                     const Progress& progress) {
    if (!finder_) return nullptr;
    return finder_->lit({environment_, intensity_, environment_rotation, lights}, bounces_,
                        progress);
}

LitVisibility put_stage(gpu::Renderer& renderer, const Stage& stage, const Progress& progress) {
    renderer.set_scene(stage.scene, progress);
    const auto environment = stage.environment.radiance.empty()
                                 ? nullptr
                                 : prepare_environment(stage.environment, progress);
    renderer.set_environment(environment);
    LitVisibility visibility(stage, environment, progress);
    renderer.set_visibility(
        visibility.lit(stage.scene.lights, stage.settings.environment_rotation, progress));
    return visibility;
}

}  // namespace burnish
