// Times of the sections of a frame, by the device. Off at first, when a section costs one comparison.
//
// Where the device has a timer that can be believed, its queries are read later, so that no section
// waits. On a software renderer, whose timer counts too little (device_timer.hpp), and where there is
// no timer, a section is the wall clock between two glFinish: the sections of a frame then no longer
// overlap, and the frame takes longer than without.
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <vector>

#include "burnish/context.hpp"
#include "gpu/device/device_timer.hpp"

namespace burnish::gpu {

// The context must be current in every call and outlive the timer.
class SectionTimer {
  public:
    SectionTimer(const Context& context, std::size_t sections);

    void measure(bool on);  // forgets what was measured before
    bool by_device() const { return by_device_; }

    // Its life is time of a section. Sections do not nest.
    class Scope {
      public:
        Scope(SectionTimer& timer, std::size_t section) : timer_(timer.on_ ? &timer : nullptr) {
            if (timer_ != nullptr) timer_->begin(section);
        }
        ~Scope() {
            if (timer_ != nullptr) timer_->end();
        }
        Scope(const Scope&) = delete;
        Scope& operator=(const Scope&) = delete;

      private:
        SectionTimer* timer_;
    };

    // Seconds of each section since the last call. Waits for the device where it has not finished.
    std::vector<double> take();

  private:
    struct Query {
        std::size_t section = 0;
        std::unique_ptr<DeviceTimer> timer;
    };
    void begin(std::size_t section);
    void end();

    const Context& context_;
    bool on_ = false, by_device_ = false;
    std::size_t section_ = 0;  // in progress
    std::chrono::steady_clock::time_point start_;
    std::vector<double> seconds_;
    std::vector<Query> pending_;
    std::vector<std::unique_ptr<DeviceTimer>> idle_;
};

}  // namespace burnish::gpu
