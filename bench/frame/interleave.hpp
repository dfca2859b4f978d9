// Measuring by turns: what is compared is measured one after the other, round after round, so that
// whatever slows the machine down slows all of it down; the order is turned every round.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "burnish/renderer.hpp"

namespace burnish {

struct FrameSample {
    int frames = 0;
    int place = 0;  // in the order of its round
    gpu::FrameTimes times;
};

// samples[subject][round]
using RoundSamples = std::vector<std::vector<FrameSample>>;

struct InterleaveOptions {
    int rounds = 15;
    double sample_s = 0.06;  // about how long one sample takes: frames are drawn until then
    int most_frames = 4096;
};

// `measure(subject, frames)` draws and times. Two measurements of each subject come first and are
// thrown away: the first makes programs, the second says how many frames make a sample. `tick(done
// 0..1)` is called before each measurement; it may throw.
RoundSamples interleave(std::size_t subjects, const InterleaveOptions& options,
                        const std::function<gpu::FrameTimes(std::size_t, int)>& measure,
                        const std::function<void(double)>& tick);

enum class Clock { wall, cpu, device };

// Median over the rounds, the spread (half the distance between the quartiles), and how far the
// median itself can be off: its standard error, 1.2533 sigma / sqrt(rounds), with sigma taken from
// the spread (0.6745 sigma for a normal distribution).
struct Estimate {
    double median = 0;
    double spread = 0;
    double error = 0;
};

Estimate estimate(const std::vector<double>& values);

// Each empty when the clock gave nothing for one of the samples, or a base took no time by it.
using Estimated = std::optional<Estimate>;
Estimated seconds_a_frame(const RoundSamples& samples, std::size_t subject, Clock clock);
Estimated ratio(const RoundSamples& samples, std::size_t subject, std::size_t base, Clock clock);
// Seconds a frame that `subject` takes longer than `base`, round by round.
Estimated difference(const RoundSamples& samples, std::size_t subject, std::size_t base,
                     Clock clock);

}  // namespace burnish
