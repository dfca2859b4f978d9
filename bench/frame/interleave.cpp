#include "bench/frame/interleave.hpp"

#include <algorithm>
#include <cmath>

#include "burnish/renderer.hpp"
#include "core/statistics.hpp"

namespace burnish {

namespace {

int frames_for(const gpu::FrameTimes& one, const InterleaveOptions& options) {
    const double wanted = std::ceil(options.sample_s / std::max(one.wall_s, 1e-9));
    return static_cast<int>(std::clamp(wanted, 1.0, static_cast<double>(options.most_frames)));
}

std::optional<double> seconds_of(const FrameSample& sample, Clock clock) {
    switch (clock) {
        case Clock::wall:
            return sample.times.wall_s / sample.frames;
        case Clock::cpu:
            return sample.times.cpu_s / sample.frames;
        case Clock::device:
            if (!sample.times.device_s) return std::nullopt;
            return *sample.times.device_s / sample.frames;
    }
    return std::nullopt;
}

// Applies `combine` to the seconds per frame of both subjects in each round; it may reject a round.
Estimated by_rounds(
    const RoundSamples& samples, std::size_t subject, std::size_t base, Clock clock,
    const std::function<std::optional<double>(double subject_s, double base_s)>& combine) {
    std::vector<double> values;
    for (std::size_t round = 0; round < samples[subject].size(); ++round) {
        const auto a = seconds_of(samples[subject][round], clock);
        const auto b = seconds_of(samples[base][round], clock);
        const std::optional<double> value = a && b ? combine(*a, *b) : std::nullopt;
        if (!value) return std::nullopt;
        values.push_back(*value);
    }
    if (values.empty()) return std::nullopt;
    return estimate(values);
}

}  // namespace

RoundSamples interleave(std::size_t subjects, const InterleaveOptions& options,
                        const std::function<gpu::FrameTimes(std::size_t, int)>& measure,
                        const std::function<void(double)>& tick) {
    const double total = static_cast<double>(subjects) * (options.rounds + 1);
    double done = 0;
    std::vector<int> frames(subjects);
    for (std::size_t subject = 0; subject < subjects; ++subject, done += 1) {
        tick(done / total);
        measure(subject, 1);
        frames[subject] = frames_for(measure(subject, 1), options);
    }
    RoundSamples samples(subjects);
    for (int round = 0; round < options.rounds; ++round) {
        for (std::size_t place = 0; place < subjects; ++place, done += 1) {
            const std::size_t subject = round % 2 == 0 ? place : subjects - 1 - place;
            tick(done / total);
            samples[subject].push_back(
                {frames[subject], static_cast<int>(place), measure(subject, frames[subject])});
        }
    }
    return samples;
}

Estimate estimate(const std::vector<double>& values) {
    Estimate e;
    e.median = median(values);
    e.spread = half_quartile_distance(values);
    e.error = 1.2533 * (e.spread / 0.6745) / std::sqrt(static_cast<double>(values.size()));
    return e;
}

Estimated seconds_a_frame(const RoundSamples& samples, std::size_t subject, Clock clock) {
    return by_rounds(samples, subject, subject, clock,
                     [](double a, double) -> std::optional<double> { return a; });
}

Estimated ratio(const RoundSamples& samples, std::size_t subject, std::size_t base, Clock clock) {
    return by_rounds(samples, subject, base, clock, [](double a, double b) {
        return b > 0.0 ? std::optional<double>(a / b) : std::nullopt;
    });
}

Estimated difference(const RoundSamples& samples, std::size_t subject, std::size_t base,
                     Clock clock) {
    return by_rounds(samples, subject, base, clock,
                     [](double a, double b) -> std::optional<double> { return a - b; });
}

}  // namespace burnish
