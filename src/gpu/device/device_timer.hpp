// Device time of OpenGL commands: GL_TIME_ELAPSED, on ES that of GL_EXT_disjoint_timer_query.
//
// What a driver answers is not always true: llvmpipe offers 64 bits of nanoseconds and counts
// almost nothing. Whoever reports the numbers checks them first (app/timer_check.hpp).
#pragma once

#include <optional>

#include "burnish/context.hpp"
#include "gpu/device/handles.hpp"

namespace burnish::gpu {

// The context must be current, and no other query of elapsed time under way.
class DeviceTimer {
  public:
    explicit DeviceTimer(const Context& context);
    ~DeviceTimer();
    DeviceTimer(const DeviceTimer&) = delete;
    DeviceTimer& operator=(const DeviceTimer&) = delete;

    bool available() const { return query_ != 0; }
    void begin() const;  // nothing where there is none
    void end() const;

    // Between `begin` and `end`, seconds; waits for the device. Empty where there is no query, or
    // where the device says that something has disturbed it.
    std::optional<double> seconds() const;

  private:
    bool disjoint_ = false;  // the functions of the ES extension
    GLuint query_ = 0;
};

}  // namespace burnish::gpu
