// Tables that the prefiltered light of a moving picture needs, computed off the frame.
//
// Threads: the one on which the window's context is current; tables are computed on another. Lifetime:
// the destructor waits for the table in work.
#pragma once

#include <future>
#include <utility>
#include <vector>

#include "burnish/context.hpp"
#include "burnish/scene.hpp"

namespace burnish::viewer {

class MotionTables {
  public:
    // Whether every material of the scene has its table, or needs none. Uploads a table that was computed,
    // and begins the next one.
    bool ready(gpu::Context& context, const std::vector<std::pair<Brdf, Mdf>>& models);

  private:
    std::pair<Brdf, Mdf> computed_{};
    std::future<std::vector<float>> work_;
};

// The models of the scene's materials that need a table, each once.
std::vector<std::pair<Brdf, Mdf>> models_with_tables(const Scene& scene);

}  // namespace burnish::viewer
