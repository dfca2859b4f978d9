// What the passes of a frame cost, while the panel Costs is open.
//
// Threads: the one on which the window's context is current. Lifetime: destroy it before the context.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include "burnish/context.hpp"
#include "gpu/device/section_timer.hpp"
#include "viewer/window/picture.hpp"

namespace burnish::viewer {

class Costs {
  public:
    explicit Costs(const gpu::Context& context) : interface_(context, 1) {}

    // Once a frame, before the picture is drawn: takes over what the last frame has measured. When
    // `wanted` becomes true, the picture starts anew: at rest there would be nothing to measure.
    void follow(bool wanted, Picture& picture);
    gpu::SectionTimer::Scope time_interface() { return {interface_, 0}; }

    bool measuring() const { return on_; }
    bool by_device() const { return by_device_; }  // else by the clock (gpu::PassTimes)

    // Milliseconds of a pass of gpu::pass_names(), of `interface`, and of all of them in `frame`: of one
    // sample of one pane, or of one frame for `display` and `interface`. A mean over about the last three
    // frames. Empty for another name.
    std::optional<double> ms(std::string_view name) const;

  private:
    bool on_ = false, by_device_ = false;
    gpu::SectionTimer interface_;
    std::array<double, gpu::kPassCount> passes_ms_{};
    double interface_ms_ = 0;
};

}  // namespace burnish::viewer
