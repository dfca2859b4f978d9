// Compiles programs at rest that the next change needs, so that it shows in the next frame: coarse scratches
// in motion and the full ones at rest, then another method, distribution or reflection model.
//
// A renderer of its own draws a pixel of a small scene with the materials of the shown one: the context
// keeps the programs. Woven and tabulated materials are left out, because their tables would be made
// again.
//
// Threads: the one on which the window's context is current. Lifetime: destroy it before the context.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "burnish/context.hpp"
#include "burnish/renderer.hpp"
#include "burnish/stage.hpp"

namespace burnish::viewer {

class WarmUp {
  public:
    explicit WarmUp(gpu::Context& context) : context_(context) {}

    // The scene that is shown, and the settings of its picture at rest; `pass`: the one that it takes.
    void follow(const Stage& stage, SurfacePass pass);
    // Compiles the next program, for a tenth to half a second. `motion`: the settings of a picture that
    // moves. False: there is nothing left.
    bool step(const RenderSettings& motion);
    bool done() const { return next_ == looks_.size(); }
    std::size_t left() const { return looks_.size() - next_; }

  private:
    struct Look {
        std::function<void(Material&)> change;  // none: the materials as they are
        bool scratched = false, moving = false;
    };

    gpu::Context& context_;
    Scene scene_;
    Environment light_;
    RenderSettings settings_;
    std::vector<Material> scratched_;  // as many as the scene's
    std::vector<Look> looks_;
    std::size_t next_ = 0;
    std::unique_ptr<gpu::Renderer> renderer_;  // while there is something left
};

}  // namespace burnish::viewer
