// What the vertices of a stage see, for a renderer.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "burnish/prepared_environment.hpp"
#include "burnish/progress.hpp"
#include "burnish/renderer.hpp"
#include "burnish/stage.hpp"
#include "burnish/visibility.hpp"

namespace burnish {

class LitVisibility {
  public:
    // Finds nothing where the values say so, or where no environment lights the stage.
    LitVisibility(const Stage& stage, std::shared_ptr<const PreparedEnvironment> environment,
                  const Progress& progress);

    // Null: nothing was found. `lights` and `environment_rotation` (radians): those of this picture.
    std::shared_ptr<const Visibility> lit(std::span<const Light> lights, float environment_rotation,
                                          const Progress& progress);
    const std::vector<std::string>& warnings() const { return warnings_; }

  private:
    std::optional<VisibilityFinder> finder_;
    std::shared_ptr<const PreparedEnvironment> environment_;
    float intensity_ = 1.0f;
    int bounces_ = 0;
    std::vector<std::string> warnings_;
};

// Gives the renderer the stage's scene and environment, and what its vertices see. Returns the last, for pictures
// under other lights.
LitVisibility put_stage(gpu::Renderer& renderer, const Stage& stage, const Progress& progress);

}  // namespace burnish
