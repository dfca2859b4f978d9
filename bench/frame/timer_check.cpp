#include "bench/frame/timer_check.hpp"

#include <fmt/format.h>

#include <cmath>

#include "burnish/renderer.hpp"

namespace burnish {

namespace {

constexpr int kTriples = 3;
constexpr int kTimes = 4;        // how much heavier the heavy work is
constexpr double kLight = 0.02;  // seconds: so long that submitting and waking up are a small part
constexpr int kMostFrames = 1 << 14;

// Waiting for a loaded machine to wake this thread is wall time that the device does not spend.
constexpr double kLeastShare = 0.5;
// The two clocks are not one: crystals agree to 1e-4, and this is also true of short work.
constexpr double kMostShare = 1.1;
// Of kTimes the work: noise of either side may double or halve it, a constant may not pass.
constexpr double kLeastGrowth = 2.0, kMostGrowth = 8.0;
// A frame alone costs what it costs among others, or more: nothing overlaps with it.
constexpr double kLeastAlone = 0.5;

constexpr const char* kNoTime = "the device gave no time";

TimerProbe probe(const MeasureFrames& measure, int frames) {
    const gpu::FrameTimes times = measure(frames);
    return {frames, times.wall_s, times.device_s};
}

std::string doubt_about(const TimerProbe& p) {
    if (!p.device_s) return kNoTime;
    const bool too_little = !(*p.device_s >= kLeastShare * p.wall_s);  // not a number as well
    const bool too_much = *p.device_s > kMostShare * p.wall_s;
    if (!too_little && !too_much) return "";
    return fmt::format("the device says {:.3f} ms where {:.3f} ms passed for {} frames",
                       1e3 * *p.device_s, 1e3 * p.wall_s, p.frames);
}

// So many frames that they take kLight.
int light_work(const MeasureFrames& measure) {
    int frames = 1;
    while (frames < kMostFrames) {
        // Twice, since anything may keep the machine busy once.
        const double wall = std::min(measure(frames).wall_s, measure(frames).wall_s);
        if (wall >= kLight) break;
        // At most tenfold: the first frames are no measure of the others.
        const double wanted = frames * 1.2 * kLight / std::max(wall, 1e-9);
        frames = static_cast<int>(
            std::min({std::ceil(wanted), 10.0 * frames, static_cast<double>(kMostFrames)}));
    }
    return frames;
}

}  // namespace

std::string doubt_about(const TimerProbe& single, const TimerProbe& light,
                        const TimerProbe& heavy) {
    if (!single.device_s) return kNoTime;
    for (const TimerProbe* p : {&light, &heavy})
        if (std::string doubt = doubt_about(*p); !doubt.empty()) return doubt;
    const double growth = *heavy.device_s / *light.device_s;
    if (!(growth >= kLeastGrowth && growth <= kMostGrowth))
        return fmt::format("the device says {:.2f} times the time for {} times the work", growth,
                           kTimes);
    const double among_others = *heavy.device_s / heavy.frames;
    if (*single.device_s >= kLeastAlone * among_others) return "";
    return fmt::format("the device says {:.3f} ms for a frame alone, {:.3f} ms for one of many",
                       1e3 * *single.device_s, 1e3 * among_others);
}

TimerVerdict check_timer(const MeasureFrames& measure) {
    TimerVerdict verdict;
    const int frames = light_work(measure);
    for (int i = 0; i < kTriples && verdict.reason.empty(); ++i) {
        const TimerProbe single = probe(measure, 1), light = probe(measure, frames);
        const TimerProbe heavy = probe(measure, kTimes * frames);
        verdict.probes.insert(verdict.probes.end(), {single, light, heavy});
        verdict.reason = doubt_about(single, light, heavy);
    }
    verdict.usable = verdict.reason.empty();
    return verdict;
}

}  // namespace burnish
