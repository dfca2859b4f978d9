// Whether timer queries are believed, with devices that tell the truth and devices that do not.
#include "bench/frame/timer_check.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "burnish/renderer.hpp"

namespace burnish {
namespace {

constexpr double kFrame = 0.002;  // seconds of wall time a frame

// A device whose timer answers `answer(wall seconds, index of the measurement)`.
MeasureFrames device(std::function<std::optional<double>(double, int)> answer) {
    return [answer = std::move(answer), calls = 0](int frames) mutable {
        gpu::FrameTimes times;
        times.wall_s = kFrame * frames;
        times.device_s = answer(times.wall_s, calls++);
        return times;
    };
}

TEST(TimerCheck, BelievesADeviceThatAccountsForTheTime) {
    const TimerVerdict verdict = check_timer(device([](double wall, int) { return 0.93 * wall; }));
    EXPECT_TRUE(verdict.usable) << verdict.reason;
    EXPECT_EQ(verdict.reason, "");
    ASSERT_EQ(verdict.probes.size(), 9u);
    EXPECT_EQ(verdict.probes[0].frames, 1);
    EXPECT_EQ(verdict.probes[2].frames, 4 * verdict.probes[1].frames);
    EXPECT_GE(verdict.probes[1].wall_s, 0.02);
}

TEST(TimerCheck, DoesNotBelieveADeviceThatCountsNothing) {
    for (const double nothing : {0.0, 3e-7}) {
        const TimerVerdict verdict =
            check_timer(device([nothing](double, int) { return nothing; }));
        EXPECT_FALSE(verdict.usable);
        EXPECT_NE(verdict.reason.find("0.000 ms where"), std::string::npos) << verdict.reason;
    }
}

TEST(TimerCheck, DoesNotBelieveADeviceThatAnswersNowAndThen) {
    // Four measurements find out how much work it takes: 1 frame, 10 frames, each twice. Then three
    // triples, measurements 4 to 12.
    for (const int silent : {4, 8, 11, 12}) {
        const TimerVerdict verdict = check_timer(
            device([silent](double wall, int call) { return call == silent ? 0.0 : 0.95 * wall; }));
        EXPECT_FALSE(verdict.usable) << silent;
    }
}

// What llvmpipe does: of many frames all but the first are counted, of one next to nothing. Many
// frames alone would be believed.
TEST(TimerCheck, DoesNotBelieveADeviceThatForgetsTheFirstFrame) {
    const TimerVerdict verdict =
        check_timer(device([](double wall, int) { return wall - 0.88 * kFrame; }));
    EXPECT_FALSE(verdict.usable);
    EXPECT_NE(verdict.reason.find("for a frame alone"), std::string::npos) << verdict.reason;
}

// A frame alone has nothing to overlap with: the device may say more.
TEST(TimerCheck, AFrameAloneMayTakeLonger) {
    const auto answer = [](double wall, int) { return wall < 1.5 * kFrame ? 3.0 * wall : wall; };
    EXPECT_TRUE(check_timer(device(answer)).usable);
}

TEST(TimerCheck, DoesNotBelieveADeviceWithoutAnAnswer) {
    const TimerVerdict verdict = check_timer(device([](double, int) { return std::nullopt; }));
    EXPECT_FALSE(verdict.usable);
    EXPECT_NE(verdict.reason.find("gave no time"), std::string::npos);
}

TEST(TimerCheck, DoesNotBelieveOtherUnits) {
    for (const double unit : {1e-3, 0.3, 1.5, 1e3, std::numeric_limits<double>::quiet_NaN(), -1.0})
        EXPECT_FALSE(check_timer(device([unit](double wall, int) { return unit * wall; })).usable)
            << unit;
}

TEST(TimerCheck, FourTimesTheWorkMustTakeMoreTime) {
    const TimerProbe single{1, 0.002, 0.0019}, light{10, 0.020, 0.019};
    EXPECT_EQ(doubt_about(single, light, {40, 0.080, 0.076}), "");
    // Both pass for themselves; together they say that work costs nothing.
    EXPECT_NE(doubt_about(single, light, {40, 0.025, 0.024}).find("1.26 times"), std::string::npos);
    EXPECT_NE(doubt_about(single, light, {40, 0.250, 0.240}), "");
}

TEST(TimerCheck, EndsOnADeviceThatTakesNoTimeAtAll) {
    const TimerVerdict verdict = check_timer([](int) { return gpu::FrameTimes{0.0, 0.0, 0.0}; });
    EXPECT_FALSE(verdict.usable);
}

}  // namespace
}  // namespace burnish
