#include "bench/frame/timer_check.hpp"

#include <fmt/format.h>

#include <cmath>

#include "burnish/renderer.hpp"

namespace burnish {

namespace {

constexpr int kTriples = 3;
constexpr int kTimes = 4;        // ratio of the heavy work to the light work
constexpr double kLight = 0.02;  // seconds; submitting and waking up are a small part
constexpr int kMostFrames = 1 << 14;

// Least ratio of device time to wall time. On a loaded machine this thread wakes late, which adds
// wall time only.
constexpr double kLeastShare = 0.5;
// Largest ratio of device time to wall time. The two clocks agree to about 1e-4, and the margin
// covers short work.
constexpr double kMostShare = 1.1;
// Bounds of the ratio of device times for kTimes the work. Noise may halve or double it; a constant
// time fails.
constexpr double kLeastGrowth = 2.0, kMostGrowth = 8.0;
// Least ratio of the device time of a single frame to that of a frame among others: without overlap
// it takes as long or longer.
constexpr double kLeastAlone = 0.5;

constexpr const char* kNoTime = "the device gave no time";

TimerProbe probe(const MeasureFrames& measure, int frames) {
    const gpu::FrameTimes times = measure(frames);
    return {frames, times.wall_s, times.device_s};
}

std::string doubt_about(const TimerProbe& p) {
    if (!p.device_s) return kNoTime;
    const bool too_little = !(*p.device_s >= kLeastShare * p.wall_s);  // also for NaN
    const bool too_much = *p.device_s > kMostShare * p.wall_s;
    if (!too_little && !too_much) return "";
    return fmt::format("the device says {:.3f} ms where {:.3f} ms passed for {} frames",
                       1e3 * *p.device_s, 1e3 * p.wall_s, p.frames);
}

// Number of frames that take about kLight.
int light_work(const MeasureFrames& measure) {
    int frames = 1;
    while (frames < kMostFrames) {
        // The minimum of two: another process may disturb one of them.
        const double wall = std::min(measure(frames).wall_s, measure(frames).wall_s);
        if (wall >= kLight) break;
        // Grows at most tenfold: the first frames do not predict the others.
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
