// What is computed off the frame: tables of the prefiltered light and coarse meshes, which a picture in
// motion needs beyond one at rest, and the means of woven cloth that one at rest needs.
//
// Threads: the one on which the window's context is current; the work is done on another. Lifetime:
// the destructors wait for what is in work: a second for a mesh of a million triangles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <future>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "burnish/context.hpp"
#include "burnish/renderer.hpp"
#include "burnish/scene.hpp"
#include "maps/weave/weave_mean.hpp"
#include "models/albedo_table.hpp"

namespace burnish::viewer {

class MotionTables {
  public:
    // Whether every material of the scene has its table, or needs none. Uploads a table that was computed,
    // and begins the next one.
    bool ready(gpu::Context& context, const std::vector<std::pair<Brdf, Mdf>>& models);

  private:
    std::pair<Brdf, Mdf> computed_{};
    std::future<std::shared_ptr<const AlbedoTable>> work_;
};

class MotionMeshes {
  public:
    // Begins to make coarse meshes of a scene that has more triangles, all instances together, than
    // `most`.
    void follow(const Scene& scene, std::size_t most);
    // Gives the renderer of that scene what is ready. False: there is nothing new.
    bool give(gpu::Renderer& renderer);
    bool working() const { return work_.valid(); }

  private:
    using Coarse = std::vector<std::vector<std::uint32_t>>;  // by mesh; empty: as it is
    void begin();

    std::optional<std::vector<Mesh>> next_;  // positions and indices alone
    std::vector<std::size_t> wanted_;        // triangles by mesh
    bool stale_ = false;                     // what is in work is of another scene
    std::future<Coarse> work_;
};

// Full means of the cloths that renderers of the context draw by coarse ones (ClothStore).
class MotionCloths {
  public:
    explicit MotionCloths(gpu::Context& context) : context_(context) {}
    // Begins to compute the means of the next cloth, unless others are in work.
    void begin();
    // Gives the renderer what is ready. True: the renderer draws otherwise now.
    bool give(gpu::Renderer& renderer);
    // Computes at once what is left.
    void finish(gpu::Renderer& renderer);
    // Whether a cloth is drawn by coarse means.
    bool any() const;

  private:
    gpu::Context& context_;
    ClothLobe computed_;
    std::future<ClothMeans> work_;
    std::uint64_t given_ = 0;  // the version of the store that the renderer has
};

// The models of the scene's materials that need a table, each once.
std::vector<std::pair<Brdf, Mdf>> models_with_tables(const Scene& scene);

}  // namespace burnish::viewer
