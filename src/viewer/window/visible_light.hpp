// What the vertices of the shown scene see of one another, found off the frame.
//
// Threads: the one on which the window's context is current; the work is done on another. Lifetime: the destructor
// cancels what is in work and waits for it.
#pragma once

#include <future>
#include <memory>
#include <optional>

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

    // What follow() is told of: what has changed since the last call.
    struct Change {
        bool scene = false;      // meshes, instances or textures
        bool materials = false;  // not which of them blend
        bool light = false;      // environment, its rotation and intensity, lights, parameters
    };
    // Notes what is to be found. Where `change.scene`, the renderer's vertices see everything until it is.
    void follow(const Stage& stage, std::shared_ptr<const PreparedEnvironment> environment,
                const Change& change, gpu::Renderer& renderer);
    // Begins what is due, unless something is in work.
    void step();
    // Gives the renderer what is ready. False: there is nothing new.
    bool give(gpu::Renderer& renderer);
    bool working() const { return work_.valid() || next_.has_value(); }

  private:
    struct Request {
        std::optional<Scene> scene;  // none: that of the finder
        std::vector<Material> materials;
        std::vector<Texture> textures;  // of scene_for_visibility
        std::vector<Light> lights;
        std::shared_ptr<const PreparedEnvironment> environment;
        float intensity = 1.0f, rotation = 0.0f;
        int bounces = 0;
        VisibilitySettings settings;
    };
    struct Found {
        std::unique_ptr<VisibilityFinder> finder;
        std::shared_ptr<const Visibility> visibility;  // none: cancelled
    };
    static Found find(std::unique_ptr<VisibilityFinder> finder, const Request& request,
                      const Progress& progress);

    std::optional<Request> next_;
    std::unique_ptr<VisibilityFinder> finder_;  // while nothing is in work
    std::vector<Texture> textures_;
    CancelToken token_;
    bool stale_ = false;  // what is in work is of another scene
    std::future<Found> work_;
};

}  // namespace burnish::viewer
