// Properties of push-pull interpolation: dense samples stay, small gaps are filled smoothly,
// distant pixels stay empty.
#include "capture/solve/push_pull.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "table_support.hpp"

namespace burnish {
namespace {

using test::Random;

struct Sample {
    float x, y, value;
};

std::size_t at(const PushPullImage& image, int x, int y) {
    return static_cast<std::size_t>(y * image.side + x);
}

PushPullImage filled(int side, const std::vector<Sample>& samples, int reach) {
    PushPullImage image(side);
    for (const Sample& s : samples) image.splat(s.x, s.y, s.value);
    push_pull(image, reach);
    return image;
}

float distance_to(const std::vector<Sample>& samples, int x, int y) {
    float least = 1e9f;
    for (const Sample& s : samples)
        least = std::min(least, std::hypot(s.x - static_cast<float>(x) - 0.5f,
                                           s.y - static_cast<float>(y) - 0.5f));
    return least;
}

std::vector<Sample> scattered(int side, int count, std::uint32_t seed) {
    Random random(seed);
    std::vector<Sample> out;
    for (int i = 0; i < count; ++i)
        out.push_back({static_cast<float>(random.uniform(0, side)),
                       static_cast<float>(random.uniform(0, side)), 0.0f});
    return out;
}

TEST(PushPull, ConstantsAreReproduced) {
    std::vector<Sample> samples = scattered(64, 60, 1);
    for (Sample& s : samples) s.value = 2.5f;
    const PushPullImage image = filled(64, samples, 6);
    for (std::size_t i = 0; i < image.value.size(); ++i) {
        ASSERT_GT(image.weight[i], 0.0f) << i;  // six doublings of the distance reach all 64 pixels
        ASSERT_LE(image.weight[i], 1.0f) << i;
        EXPECT_NEAR(image.value[i], 2.5f, 1e-5f) << i;  // a weighted mean of equal numbers
    }
}

// A sample at the center of every pixel: there are no gaps.
TEST(PushPull, DenseSamplesAreKept) {
    Random random(2);
    std::vector<Sample> samples;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            samples.push_back({static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f,
                               static_cast<float>(random.uniform(-1, 1))});
    const PushPullImage image = filled(16, samples, 4);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        EXPECT_NEAR(image.value[i], samples[i].value, 1e-6f);
        EXPECT_NEAR(image.weight[i], 1.0f, 1e-6f);
    }
}

// Halfway between four centers the tents have equal weights, and all four get the sample's value.
TEST(PushPull, TentsShareASample) {
    PushPullImage image(8);
    image.splat(4.0f, 4.0f, 3.0f);
    push_pull(image, 0);
    int touched = 0;
    for (int y = 0; y < 8; ++y) {
        for (int x = 0; x < 8; ++x) {
            if (image.weight[at(image, x, y)] == 0) continue;
            ++touched;
            EXPECT_TRUE((x == 3 || x == 4) && (y == 3 || y == 4)) << x << " " << y;
            EXPECT_NEAR(image.value[at(image, x, y)], 3.0f, 1e-6f);
        }
    }
    EXPECT_EQ(touched, 4);
}

// Two samples within one pixel: their mean is weighted by distance.
TEST(PushPull, TentsWeighByDistance) {
    PushPullImage image(4);
    image.splat(1.5f, 1.5f, 1.0f);
    image.splat(2.0f, 1.5f, 4.0f);  // half its weight in pixel 1, half in pixel 2
    push_pull(image, 0);
    EXPECT_NEAR(image.value[at(image, 1, 1)], (1.0f + 0.5f * 4.0f) / 1.5f, 1e-5f);
    EXPECT_NEAR(image.value[at(image, 2, 1)], 4.0f, 1e-5f);
}

// Each level doubles the distance: a sample reaches about 2^reach pixels. At half that distance
// every pixel is filled; at three times it (a pixel of the coarsest level and its neighbor) none
// is.
TEST(PushPull, GapsAreFilledWithinReachOnly) {
    for (const int reach : {0, 1, 2, 3, 4}) {
        for (const float place : {64.5f, 71.3f, 60.0f}) {
            const std::vector<Sample> one = {{place, place, 1.5f}};
            const PushPullImage image = filled(128, one, reach);
            const float far = static_cast<float>(1 << reach);
            for (int y = 0; y < 128; ++y) {
                for (int x = 0; x < 128; ++x) {
                    const float d = distance_to(one, x, y);
                    const float weight = image.weight[at(image, x, y)];
                    if (d <= 0.5f * far) {
                        ASSERT_GT(weight, 0.0f) << reach << " at distance " << d;
                        ASSERT_NEAR(image.value[at(image, x, y)], 1.5f, 1e-5f);
                    }
                    if (d > 3.0f * far) {
                        ASSERT_EQ(weight, 0.0f) << reach << " at distance " << d;
                    }
                }
            }
        }
    }
}

// A filled value is a weighted mean and lies between the least and the largest sample.
TEST(PushPull, NothingIsOvershot) {
    std::vector<Sample> samples = scattered(64, 100, 4);
    Random random(5);
    float least = 1e9f, most = -1e9f;
    for (Sample& s : samples) {
        s.value = static_cast<float>(random.uniform(-2, 7));
        least = std::min(least, s.value), most = std::max(most, s.value);
    }
    const PushPullImage image = filled(64, samples, 5);
    for (std::size_t i = 0; i < image.value.size(); ++i) {
        if (image.weight[i] == 0) continue;
        EXPECT_GE(image.value[i], least - 1e-4f);
        EXPECT_LE(image.value[i], most + 1e-4f);
    }
}

// A ramp with a slope of one per pixel. With samples a few pixels apart, a mean of near samples has
// an error up to about their spacing. The bound is the hole at the pixel, plus the widths of the
// tents and of coarse pixels.
TEST(PushPull, RampsAreFollowed) {
    std::vector<Sample> samples = scattered(64, 500, 6);
    for (Sample& s : samples) s.value = s.x - 0.5f * s.y;
    const PushPullImage image = filled(64, samples, 4);
    double squares = 0;
    int count = 0;
    for (int y = 4; y < 60; ++y) {
        for (int x = 4; x < 60; ++x) {
            const float truth =
                static_cast<float>(x) + 0.5f - 0.5f * (static_cast<float>(y) + 0.5f);
            const float error = image.value[at(image, x, y)] - truth;
            ASSERT_GT(image.weight[at(image, x, y)], 0.0f);
            ASSERT_LT(std::abs(error), 1.5f * distance_to(samples, x, y) + 2.0f) << x << " " << y;
            squares += static_cast<double>(error * error);
            ++count;
        }
    }
    // 500 samples in 64^2 pixels are 2.9 pixels apart; a slope of 1.12 over an eighth of that is
    // 0.4.
    EXPECT_LT(std::sqrt(squares / count), 0.5);
}

TEST(PushPull, OrderDoesNotMatter) {
    std::vector<Sample> samples = scattered(32, 300, 8);
    Random random(9);
    for (Sample& s : samples) s.value = static_cast<float>(random.uniform(0, 3));
    const PushPullImage forward = filled(32, samples, 4);
    std::reverse(samples.begin(), samples.end());
    const PushPullImage backward = filled(32, samples, 4);
    for (std::size_t i = 0; i < forward.value.size(); ++i) {
        EXPECT_NEAR(forward.value[i], backward.value[i], 1e-5f);
        EXPECT_NEAR(forward.weight[i], backward.weight[i], 1e-5f);
    }
}

// A sample outside or on the rim must not write out of bounds (the sanitizers check).
TEST(PushPull, RimsAreSafe) {
    PushPullImage image(8);
    for (const float p : {0.0f, 0.25f, 7.75f, 8.0f}) {
        image.splat(p, p, 1.0f);
        image.splat(p, 4.0f, 1.0f);
        image.splat(4.0f, p, 1.0f);
    }
    push_pull(image, 3);
    for (std::size_t i = 0; i < image.value.size(); ++i) {
        EXPECT_TRUE(std::isfinite(image.value[i]));
        if (image.weight[i] > 0) {
            EXPECT_NEAR(image.value[i], 1.0f, 1e-5f);
        }
    }
}

TEST(PushPull, NoSamplesStayNone) {
    PushPullImage image(16);
    push_pull(image, 4);
    for (const float w : image.weight) EXPECT_EQ(w, 0.0f);
    PushPullImage one(1);
    one.splat(0.5f, 0.5f, 2.0f);
    push_pull(one, 3);
    EXPECT_NEAR(one.value[0], 2.0f, 1e-6f);
}

}  // namespace
}  // namespace burnish
