// The offsets of samples in their pixel: where their mean is, and how evenly they fill the filter.
#include "scene/camera/pixel_offsets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace burnish::test {
namespace {

glm::dvec2 mean_of_first(const std::vector<glm::dvec2>& offsets, int n) {
    glm::dvec2 sum(0.0);
    for (int i = 0; i < n; ++i) sum += offsets[static_cast<std::size_t>(i)];
    return sum / static_cast<double>(n);
}

// The cumulative distribution of a tent of half width 1.
double share_below(double x) {
    return x < 0 ? 0.5 * (1 + x) * (1 + x) : 1 - 0.5 * (1 - x) * (1 - x);
}

// Opposite numbers cancel in any order but for rounding.
constexpr double kRounding = 1e-14;

TEST(PixelOffsets, HaveTheMeanZeroForEveryCount) {
    for (int n = 1; n <= 600; ++n) {
        const std::vector<glm::dvec2> offsets = pixel_offsets(n);
        ASSERT_EQ(offsets.size(), static_cast<std::size_t>(n));
        const glm::dvec2 mean = mean_of_first(offsets, n);
        EXPECT_LE(std::max(std::abs(mean.x), std::abs(mean.y)), kRounding) << n;
    }
}

// A progressive picture is shown after any number of samples. After one of a pair the mean is off by
// its offset, at most 1 px along each axis, over the number of samples.
TEST(PixelOffsets, KeepTheMeanNearZeroWhileTheyAreAdded) {
    for (const int count : {2, 5, 16, 64, 65, 250}) {
        const std::vector<glm::dvec2> offsets = pixel_offsets(count);
        for (int n = 1; n <= count; ++n) {
            const glm::dvec2 mean = mean_of_first(offsets, n);
            const double bound = n % 2 == count % 2 ? kRounding : 1.0 / n;
            EXPECT_LE(std::max(std::abs(mean.x), std::abs(mean.y)), bound) << n << " of " << count;
        }
    }
}

// One sample in each of n equal parts of the filter, along either axis.
TEST(PixelOffsets, FillTheTentEvenlyAlongBothAxes) {
    for (int n = 1; n <= 300; ++n) {
        std::vector<double> x, y;
        for (const glm::dvec2& p : pixel_offsets(n)) {
            x.push_back(share_below(p.x) * n);
            y.push_back(share_below(p.y) * n);
        }
        std::ranges::sort(x);
        std::ranges::sort(y);
        for (int i = 0; i < n; ++i) {
            EXPECT_NEAR(x[static_cast<std::size_t>(i)], i + 0.5, 1e-9) << n;
            EXPECT_NEAR(y[static_cast<std::size_t>(i)], i + 0.5, 1e-9) << n;
        }
    }
}

// The share of the pixel under random straight edges. Independent points would err by
// sqrt(s (1 - s) / n) at a share s, whose root mean square over these edges is 0.4 / sqrt(n). A first
// half of the set must be as even as a set of that size was before offsets knew their number: a
// quarter below independent points.
TEST(PixelOffsets, ResolveStraightEdges) {
    const auto error = [](const std::vector<glm::dvec2>& offsets, int n) {
        const std::vector<glm::dvec2> exact = pixel_offsets(20011);
        std::mt19937 generator(5);
        std::uniform_real_distribution<double> uniform(0, 1);
        double sum = 0;
        constexpr int kEdges = 400;
        for (int i = 0; i < kEdges; ++i) {
            const double angle = 6.2831853 * uniform(generator), place = 2 * uniform(generator) - 1;
            const auto share = [&](const std::vector<glm::dvec2>& points, int count) {
                return static_cast<double>(std::count_if(
                           points.begin(), points.begin() + count,
                           [&](glm::dvec2 p) {
                               return p.x * std::cos(angle) + p.y * std::sin(angle) < place;
                           })) /
                       count;
            };
            sum += std::pow(share(offsets, n) - share(exact, 20011), 2);
        }
        return std::sqrt(sum / kEdges);
    };
    for (const int n : {4, 6, 8, 16, 32, 64, 100}) {
        const double independent = 0.4 / std::sqrt(n);
        EXPECT_LT(error(pixel_offsets(n), n), 0.5 * independent) << n;
        if (n < 8) continue;
        EXPECT_LT(error(pixel_offsets(2 * n), n), 0.75 * independent) << n;
    }
}

}  // namespace
}  // namespace burnish::test
