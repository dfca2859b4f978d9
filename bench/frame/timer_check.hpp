// Whether a device's timer queries can be believed: found out, never looked up by name.
//
// A heavy piece of work is timed by the wall clock, between two glFinish, and by the device. The
// device must account for most of the wall's time and for no more than all of it, for about four
// times as much when the work is four times as much, and for no less when a frame is drawn alone.
// (llvmpipe's timer starts anew with every piece of a picture: of a single frame it counts the last
// pieces only, of many frames all but the first.)
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "burnish/renderer.hpp"

namespace burnish {

// Draws so many frames of one kind, warmed up, and says what they took.
using MeasureFrames = std::function<gpu::FrameTimes(int frames)>;

struct TimerProbe {
    int frames = 0;
    double wall_s = 0;
    std::optional<double> device_s;
};

struct TimerVerdict {
    bool usable = false;
    std::string reason;              // why not, in words; empty when usable
    std::vector<TimerProbe> probes;  // what it was judged by
};

// Empty when the three can be believed, else what is wrong with them. `single` is one frame;
// `heavy` holds four times the frames of `light`.
std::string doubt_about(const TimerProbe& single, const TimerProbe& light, const TimerProbe& heavy);

// Three such triples, all of which must be believed: a timer that counts nothing now and then
// counts nothing. Takes a second at most where a frame takes less than 50 ms.
TimerVerdict check_timer(const MeasureFrames& measure);

}  // namespace burnish
