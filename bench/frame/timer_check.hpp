// Tests whether a device's timer queries are reliable, by measurement instead of by driver name.
//
// A heavy workload is timed by the wall clock, between two glFinish, and by the device. The device
// time must be most of the wall time and at most all of it; it must grow about fourfold with four
// times the work, and be no less for a frame drawn alone. (llvmpipe's timer restarts with every
// piece of a picture: for a single frame it counts only the last pieces, for many frames all but
// the first.)
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "burnish/renderer.hpp"

namespace burnish {

// Draws this number of equal frames after a warm-up and returns their times.
using MeasureFrames = std::function<gpu::FrameTimes(int frames)>;

struct TimerProbe {
    int frames = 0;
    double wall_s = 0;
    std::optional<double> device_s;
};

struct TimerVerdict {
    bool usable = false;
    std::string reason;              // why the timer is unusable; empty if usable
    std::vector<TimerProbe> probes;  // the measurements that decided
};

// The reason why the timer is unreliable by these three probes, or empty. `single` is one frame;
// `heavy` has four times the frames of `light`.
std::string doubt_about(const TimerProbe& single, const TimerProbe& light, const TimerProbe& heavy);

// Makes three triples of probes, all of which must pass, since a timer may fail intermittently.
// Takes at most a second if a frame takes less than 50 ms.
TimerVerdict check_timer(const MeasureFrames& measure);

}  // namespace burnish
