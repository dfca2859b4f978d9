// Progress and cancellation of long work. Work calls `step`; whoever runs it decides what to show.
#pragma once

#include <functional>
#include <string_view>
#include <utility>

#include "burnish/api.hpp"

namespace BURNISH_API burnish {

class Progress {
  public:
    // `report(stage, done in [0,1])` is called from the working thread; it may throw Interrupted.
    using Report = std::function<void(std::string_view stage, double done)>;

    Progress() = default;
    explicit Progress(Report report) : report_(std::move(report)) {}

    // Throws Interrupted after Ctrl-C. `done` is clamped to [0,1].
    void step(std::string_view stage, double done) const;

  private:
    Report report_;
};

// Set by the signal handler of the command line (async-signal-safe); looked at by Progress::step.
void request_interrupt() noexcept;
bool interrupt_requested() noexcept;
void clear_interrupt() noexcept;  // for programs that go on after an interrupted job

}  // namespace burnish
