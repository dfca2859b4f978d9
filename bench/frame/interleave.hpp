// Interleaved measurement: subjects are measured one after another, round after round, so that a
// slowdown of the machine affects all of them; the order alternates every round.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "burnish/renderer.hpp"

namespace burnish {

struct FrameSample {
    int frames = 0;
    int place = 0;  // position in the order of its round
    gpu::FrameTimes times;
};

// samples[subject][round]
using RoundSamples = std::vector<std::vector<FrameSample>>;

struct InterleaveOptions {
    int rounds = 15;
    double sample_s = 0.06;  // approximate length of a sample, which sets its number of frames
    int most_frames = 4096;
};

// `measure(subject, frames)` draws and times. Two measurements of each subject are discarded: the
// first compiles programs, the second determines the frames of a sample. `tick(done 0..1)` is
// called before each measurement; it may throw.
RoundSamples interleave(std::size_t subjects, const InterleaveOptions& options,
                        const std::function<gpu::FrameTimes(std::size_t, int)>& measure,
                        const std::function<void(double)>& tick);

enum class Clock { wall, cpu, device };

// Median over the rounds, spread (half the interquartile distance), and standard error of the
// median: 1.2533 sigma / sqrt(rounds), with sigma from the spread (0.6745 sigma for a normal
// distribution).
struct Estimate {
    double median = 0;
    double spread = 0;
    double error = 0;
};

Estimate estimate(const std::vector<double>& values);

// Each is empty if the clock gave no time for a sample, or a base took no time by it.
using Estimated = std::optional<Estimate>;
Estimated seconds_a_frame(const RoundSamples& samples, std::size_t subject, Clock clock);
Estimated ratio(const RoundSamples& samples, std::size_t subject, std::size_t base, Clock clock);
// Difference in seconds per frame between `subject` and `base`, round by round.
Estimated difference(const RoundSamples& samples, std::size_t subject, std::size_t base,
                     Clock clock);

}  // namespace burnish
