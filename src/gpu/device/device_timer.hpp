// Device time of OpenGL commands: GL_TIME_ELAPSED, and GL_EXT_disjoint_timer_query on ES.
//
// The answer of a driver may be wrong: llvmpipe offers 64 bits of nanoseconds and counts almost
// nothing. Callers that report the numbers check them first (bench/frame/timer_check.hpp) or do not
// ask on a software renderer (section_timer.hpp).
#pragma once

#include <optional>

#include "burnish/context.hpp"
#include "gpu/device/handles.hpp"

namespace burnish::gpu {

// The context must be current, and no other query of elapsed time may be active.
class DeviceTimer {
  public:
    explicit DeviceTimer(const Context& context);
    ~DeviceTimer();
    DeviceTimer(const DeviceTimer&) = delete;
    DeviceTimer& operator=(const DeviceTimer&) = delete;

    bool available() const { return query_ != 0; }
    void begin() const;  // does nothing where there is no query
    void end() const;

    // Seconds between `begin` and `end`; waits for the device. Empty where there is no query, or
    // where the device reports a disjoint event.
    std::optional<double> seconds() const;

  private:
    bool disjoint_ = false;  // use the functions of the ES extension
    GLuint query_ = 0;
};

}  // namespace burnish::gpu
