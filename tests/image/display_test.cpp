// From radiance to display: fixed points and orders that the tone maps promise.
#include "burnish/display.hpp"

#include <gtest/gtest.h>

#include "burnish/image_io.hpp"

namespace burnish {
namespace {

Image gray(float value) {
    return Image(1, 1, 3, value);
}

float shown(float value, ToneMap tone_map, double exposure = 0) {
    return to_display(gray(value), exposure, tone_map).pixels[0];
}

TEST(Display, LinearIsTheSrgbCurveAndClips) {
    EXPECT_FLOAT_EQ(shown(0.18f, ToneMap::linear), srgb_from_linear(0.18f));
    EXPECT_FLOAT_EQ(shown(7.0f, ToneMap::linear), 1.0f);
    EXPECT_FLOAT_EQ(shown(0.0f, ToneMap::linear), 0.0f);
}

TEST(Display, OneStopOfExposureDoublesRadiance) {
    EXPECT_FLOAT_EQ(shown(0.2f, ToneMap::linear, 1.0), shown(0.4f, ToneMap::linear));
}

// The published closed forms at 1: Reinhard 1/2; Narkowicz 2.54/3.16; PBR Neutral: with the 0.04
// offset the peak is 0.96, compressed to 1 - 0.24^2/(0.96 + 0.24 - 0.76).
TEST(Display, KnownValuesAtOne) {
    EXPECT_NEAR(linear_from_srgb(shown(1.0f, ToneMap::reinhard)), 0.5, 1e-5);
    EXPECT_NEAR(linear_from_srgb(shown(1.0f, ToneMap::aces)), 2.54 / 3.16, 1e-5);
    EXPECT_NEAR(linear_from_srgb(shown(1.0f, ToneMap::khronos_neutral)),
                1 - 0.24 * 0.24 / (0.96 + 0.24 - 0.76), 1e-5);
}

TEST(Display, EveryToneMapIsMonotoneAndInRange) {
    for (const ToneMap map :
         {ToneMap::linear, ToneMap::reinhard, ToneMap::aces, ToneMap::khronos_neutral}) {
        float before = -1;
        for (float value = 0; value < 60000; value = value * 1.1f + 0.001f) {
            const float now = shown(value, map);
            EXPECT_GE(now, before - 1e-6f);
            EXPECT_LE(now, 1.0f);
            before = now;
        }
        EXPECT_GT(before, 0.99f);
    }
}

TEST(Display, NamesFollowTheEnumeration) {
    EXPECT_EQ(tone_map_names().size(), 4u);
    EXPECT_EQ(tone_map_names()[static_cast<std::size_t>(ToneMap::khronos_neutral)],
              "khronos-neutral");
}

}  // namespace
}  // namespace burnish
