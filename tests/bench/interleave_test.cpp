// Measuring by turns, on machines made up.
#include "bench/frame/interleave.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "burnish/error.hpp"
#include "burnish/renderer.hpp"
#include "core/statistics.hpp"

namespace burnish {
namespace {

const auto kNoTick = [](double) {};

gpu::FrameTimes taking(double seconds) {
    return {seconds, 2.0 * seconds, 0.5 * seconds};
}

TEST(Statistics, QuantilesLieBetweenNeighbors) {
    EXPECT_DOUBLE_EQ(median({3, 1, 2}), 2);
    EXPECT_DOUBLE_EQ(median({4, 1, 2, 3}), 2.5);
    EXPECT_DOUBLE_EQ(quantile({0, 10}, 0.25), 2.5);
    EXPECT_DOUBLE_EQ(half_quartile_distance({1, 2, 3, 4, 5, 6, 7, 8, 9}), 2);
    EXPECT_DOUBLE_EQ(median({7}), 7);
    EXPECT_TRUE(std::isnan(median({})));
}

TEST(Interleave, TurnsTheOrderEveryRound) {
    std::string order;
    InterleaveOptions options;
    options.rounds = 3;
    const RoundSamples samples = interleave(
        3, options,
        [&](std::size_t subject, int) {
            order += static_cast<char>('a' + subject);
            return taking(1.0);
        },
        kNoTick);
    EXPECT_EQ(order,
              "aabbcc"  // thrown away
              "abc"
              "cba"
              "abc");
    ASSERT_EQ(samples.size(), 3u);
    for (const auto& rounds : samples) EXPECT_EQ(rounds.size(), 3u);
    EXPECT_EQ(samples[2][0].place, 2);
    EXPECT_EQ(samples[2][1].place, 0);
}

// The first frame makes shaders: it must reach neither the number of frames nor any sample.
TEST(Interleave, TheFirstMeasurementDoesNotCount) {
    std::vector<int> calls(2);
    InterleaveOptions options;
    options.rounds = 4;
    options.sample_s = 0.1;
    const RoundSamples samples = interleave(
        2, options,
        [&](std::size_t subject, int frames) {
            const bool first = calls[subject]++ == 0;
            return taking(first ? 100.0 : frames * (subject == 0 ? 0.01 : 0.03));
        },
        kNoTick);
    for (const FrameSample& s : samples[0]) EXPECT_EQ(s.frames, 10);
    for (const FrameSample& s : samples[1]) EXPECT_EQ(s.frames, 4);
    EXPECT_NEAR(ratio(samples, 1, 0, Clock::wall)->median, 3.0, 1e-12);
    EXPECT_NEAR(seconds_a_frame(samples, 1, Clock::cpu)->median, 0.06, 1e-12);
    EXPECT_NEAR(difference(samples, 1, 0, Clock::device)->median, 0.01, 1e-12);
    EXPECT_EQ(ratio(samples, 1, 0, Clock::wall)->spread, 0.0);
}

TEST(Interleave, DrawsAtLeastOneFrameAndNoMoreThanAllowed) {
    InterleaveOptions options;
    options.rounds = 1;
    options.most_frames = 50;
    const RoundSamples samples = interleave(
        2, options,
        [](std::size_t subject, int frames) { return taking(subject == 0 ? 5.0 : 1e-6 * frames); },
        kNoTick);
    EXPECT_EQ(samples[0][0].frames, 1);
    EXPECT_EQ(samples[1][0].frames, 50);
}

// A machine that grows slower by 2 % a measurement: measured one after the other, not by turns,
// 20 rounds of each would differ by half.
TEST(Interleave, ADriftOfTheMachineDoesNotReachTheRatio) {
    InterleaveOptions options;
    options.rounds = 20;
    options.sample_s = 1e-9;
    double speed = 1.0;
    const RoundSamples samples = interleave(
        2, options,
        [&](std::size_t subject, int frames) {
            speed *= 1.02;
            return taking(frames * speed * (subject == 0 ? 1.0 : 1.5));
        },
        kNoTick);
    // Neighbours are 2 % apart, the other way round every other round.
    EXPECT_NEAR(ratio(samples, 1, 0, Clock::wall)->median, 1.5, 1.5 * 0.001);
}

TEST(Interleave, AClockThatIsSilentOnceSaysNothing) {
    int calls = 0;
    InterleaveOptions options;
    options.rounds = 3;
    const RoundSamples samples = interleave(
        1, options,
        [&](std::size_t, int) {
            gpu::FrameTimes times = taking(1.0);
            if (++calls == 4) times.device_s.reset();
            return times;
        },
        kNoTick);
    EXPECT_FALSE(seconds_a_frame(samples, 0, Clock::device));
    EXPECT_TRUE(seconds_a_frame(samples, 0, Clock::wall));
}

TEST(Interleave, ABaseThatTakesNoTimeHasNoRatio) {
    InterleaveOptions options;
    options.rounds = 3;
    const RoundSamples samples = interleave(
        2, options, [](std::size_t, int) { return taking(0.0); }, kNoTick);
    EXPECT_FALSE(ratio(samples, 1, 0, Clock::wall));
    EXPECT_TRUE(difference(samples, 1, 0, Clock::wall));
}

TEST(Interleave, CanBeStoppedAndSaysHowFarItIs) {
    double last = -1;
    const auto tick = [&](double done) {
        EXPECT_GT(done, last);
        EXPECT_LT(done, 1.0);
        last = done;
        if (done > 0.5) throw Interrupted();
    };
    EXPECT_THROW(interleave(
                     2, {}, [](std::size_t, int) { return taking(1.0); }, tick),
                 Interrupted);
    EXPECT_GT(last, 0.5);
}

// 1.2533 (2 / 0.6745) / sqrt(9), by hand.
TEST(Interleave, TheErrorOfTheMedianShrinksWithTheRounds) {
    const Estimate e = estimate({1, 2, 3, 4, 5, 6, 7, 8, 9});
    EXPECT_DOUBLE_EQ(e.median, 5);
    EXPECT_DOUBLE_EQ(e.spread, 2);
    EXPECT_NEAR(e.error, 1.2387, 1e-4);
}

}  // namespace
}  // namespace burnish
