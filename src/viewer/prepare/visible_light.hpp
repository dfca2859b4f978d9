// What the vertices of the shown scene see of one another, found off the frame.
//
// Threads: the one on which the window's context is current; the work is done on another. Lifetime: the destructor
// cancels what is in work and waits for it.
#pragma once

#include <atomic>
#include <future>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "burnish/prepared_environment.hpp"
#include "burnish/progress.hpp"
#include "burnish/renderer.hpp"
#include "burnish/stage.hpp"
#include "burnish/visibility.hpp"

namespace burnish::viewer {

class VisibleLight {
  public:
    VisibleLight() = default;
    ~VisibleLight();
    VisibleLight(const VisibleLight&) = delete;
    VisibleLight& operator=(const VisibleLight&) = delete;

    // What has changed since the last call.
    struct Change {
        bool geometry = false;  // meshes or instances
        bool textures = false;
        bool materials = false;
        bool light = false;  // the environment or lights
        bool forgotten =
            false;  // the renderer was given a scene, and knows nothing of what vertices see
    };
    // Notes what is to be found. Until then the renderer's vertices see what they saw, or where the geometry
    // has changed everything. `environment`: null for none.
    void follow(const Stage& stage, std::shared_ptr<const PreparedEnvironment> environment,
                Change change, gpu::Renderer& renderer);
    // Begins what is due, unless something is in work.
    void step();
    // While true, work in progress waits: a picture that moves needs every processor. It stops within 0.2 s.
    void hold(bool held) { held_->store(held, std::memory_order_relaxed); }
    // Gives the renderer what is ready. False: there is nothing new.
    bool give(gpu::Renderer& renderer);
    // The same, after waiting for all that is due: before a picture that is kept.
    void finish(gpu::Renderer& renderer);
    // What it was given last.
    void give_again(gpu::Renderer& renderer) const { renderer.set_visibility(known_); }
    bool working() const { return work_.valid() || next_.has_value(); }

  private:
    // What of the settings and materials it depends on.
    struct Settings {
        float intensity = 1.0f, rotation = 0.0f;
        int bounces = 0, rays = 0;
        std::vector<std::pair<bool, bool>> sides;  // of every material: double-sided, blends
        bool operator==(const Settings&) const = default;
    };
    struct Request {
        std::optional<Scene> scene;  // none: that of the finder
        std::vector<Material> materials;
        std::vector<Texture> textures;  // of scene_for_visibility
        std::vector<Light> lights;
        std::shared_ptr<const PreparedEnvironment> environment;
        Settings settings;
    };
    struct Found {
        std::unique_ptr<VisibilityFinder> finder;
        std::shared_ptr<const Visibility> visibility;  // none: cancelled
    };
    static Settings settings_of(const Stage& stage);
    static Found find(std::unique_ptr<VisibilityFinder> finder, const Request& request,
                      const Progress& progress);
    void forget();

    Settings settings_;
    std::optional<Request> next_;
    std::unique_ptr<VisibilityFinder> finder_;  // while nothing is in work
    std::shared_ptr<const Visibility> known_;   // that the renderer was given last
    CancelToken token_;
    std::shared_ptr<std::atomic<bool>> held_ = std::make_shared<std::atomic<bool>>(false);
    bool stale_ = false;  // what is in work is of another scene
    std::future<Found> work_;
};

}  // namespace burnish::viewer
