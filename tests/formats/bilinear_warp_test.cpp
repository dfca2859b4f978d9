// The warp against its definition: areas under the bilinear density by quadrature, without the
// tables of the warp.
#include "formats/bsdf/bilinear_warp.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <span>
#include <utility>
#include <vector>

namespace burnish::test {
namespace {

constexpr std::size_t kColumns = 7, kRows = 5;

std::vector<float> random_table(unsigned seed, std::size_t slices) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<float> uniform(0.0F, 1.0F);
    std::vector<float> values(slices * kColumns * kRows);
    for (float& value : values) value = std::pow(uniform(generator), 3.0F);
    return values;
}

// The bilinear function of one slice, without normalization.
double literal(std::span<const float> values, std::size_t slice, double x, double y) {
    const double cx = x * (kColumns - 1), cy = y * (kRows - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(cx), kColumns - 2);
    const std::size_t j = std::min(static_cast<std::size_t>(cy), kRows - 2);
    const double tx = cx - static_cast<double>(i), ty = cy - static_cast<double>(j);
    const auto node = [&](std::size_t a, std::size_t b) {
        return static_cast<double>(values[(slice * kRows + j + b) * kColumns + i + a]);
    };
    return (1 - ty) * ((1 - tx) * node(0, 0) + tx * node(1, 0)) +
           ty * ((1 - tx) * node(0, 1) + tx * node(1, 1));
}

// Integral over [0, x] x [0, y] by the midpoint rule: exact except in steps that contain a node of
// the table, about 5e-6 of the total.
double area(std::span<const float> values, std::size_t slice, double x, double y) {
    constexpr int kSteps = 480;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i)
        for (int j = 0; j < kSteps; ++j)
            sum += literal(values, slice, x * (i + 0.5) / kSteps, y * (j + 0.5) / kSteps);
    return sum * x * y / (kSteps * kSteps);
}

TEST(BilinearWarp, TheSecondNumberIsTheShareOfTheAreaBelow) {
    const auto values = random_table(1, 1);
    const BilinearWarp warp(values, kColumns, kRows);
    const double all = area(values, 0, 1, 1);
    for (const double y : {0.1, 0.33, 0.5, 0.77, 0.98}) {
        const Warped back = warp.invert({}, 0.4, y);
        EXPECT_NEAR(back.y, area(values, 0, 1, y) / all, 1e-5) << y;  // error of the midpoint rule
        EXPECT_NEAR(back.density, literal(values, 0, 0.4, y) / all, 1e-4 * back.density);
    }
}

TEST(BilinearWarp, TheFirstNumberIsTheShareAlongTheRow) {
    const auto values = random_table(2, 1);
    const BilinearWarp warp(values, kColumns, kRows);
    for (const double x : {0.05, 0.3, 0.62, 0.95})
        for (const double y : {0.1, 0.45, 0.9}) {
            constexpr int kSteps = 20000;
            double before = 0, all = 0;
            for (int i = 0; i < kSteps; ++i) {
                before += literal(values, 0, x * (i + 0.5) / kSteps, y) * x;
                all += literal(values, 0, (i + 0.5) / kSteps, y);
            }
            EXPECT_NEAR(warp.invert({}, x, y).x, before / all, 1e-6) << x << ' ' << y;
        }
}

TEST(BilinearWarp, InvertUndoesSample) {
    const auto values = random_table(3, 4);
    const BilinearWarp warp(values, kColumns, kRows);
    const SliceMix mix{{0, 1, 2, 3}, {0.1, 0.2, 0.3, 0.4}};
    std::mt19937 generator(4);
    std::uniform_real_distribution<double> uniform(0, 1);
    for (int k = 0; k < 2000; ++k) {
        const double u = uniform(generator), v = uniform(generator);
        const Warped there = warp.sample(mix, u, v);
        const Warped back = warp.invert(mix, there.x, there.y);
        EXPECT_NEAR(back.x, u, 1e-12);
        EXPECT_NEAR(back.y, v, 1e-12);
        EXPECT_NEAR(back.density, there.density, 1e-9 * there.density);
        EXPECT_NEAR(warp.density(mix, there.x, there.y), there.density, 1e-9 * there.density);
    }
}

TEST(BilinearWarp, BetweenSlicesTheDensityIsTheMean) {
    const auto values = random_table(5, 2);
    const BilinearWarp warp(values, kColumns, kRows);
    const SliceMix both{{0, 1, 0, 0}, {0.25, 0.75, 0, 0}};
    const SliceMix first{{0, 0, 0, 0}, {1, 0, 0, 0}}, second{{1, 0, 0, 0}, {1, 0, 0, 0}};
    for (const double x : {0.0, 0.21, 0.8, 1.0})
        for (const double y : {0.0, 0.5, 0.93})
            EXPECT_NEAR(warp.density(both, x, y),
                        0.25 * warp.density(first, x, y) + 0.75 * warp.density(second, x, y),
                        1e-12);
}

TEST(BilinearWarp, WhereThereIsNoDensityNothingIsDrawn) {
    std::vector<float> values(kColumns * kRows, 0.0F);
    values[2 * kColumns + 3] = 1.0F;  // a tent about one node
    const BilinearWarp warp(values, kColumns, kRows);
    for (int i = 0; i <= 50; ++i)
        for (int j = 0; j <= 50; ++j) {
            const Warped drawn = warp.sample({}, i / 50.0, j / 50.0);
            EXPECT_LE(std::fabs(drawn.x * (kColumns - 1) - 3), 1 + 1e-6);
            EXPECT_LE(std::fabs(drawn.y * (kRows - 1) - 2), 1 + 1e-6);
            EXPECT_TRUE(std::isfinite(drawn.density));
        }
    EXPECT_EQ(warp.density({}, 0.05, 0.05), 0.0);
    const Warped outside = warp.invert({}, 0.05, 0.05);
    EXPECT_TRUE(outside.x >= 0 && outside.x <= 1 && outside.y >= 0 && outside.y <= 1);
}

TEST(SliceGrid, IsLinearBetweenItsValuesAndHeldBeyond) {
    const SliceGrid grid({-1, 0, 2}, {0.0, 0.5, 1.0});
    const auto total = [&](double phi, double theta) {
        const SliceMix mix = grid.at(phi, theta);
        double p = 0, t = 0, sum = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            p += mix.weight[i] * grid.phi()[mix.slice[i] / 3];
            t += mix.weight[i] * grid.theta()[mix.slice[i] % 3];
            sum += mix.weight[i];
        }
        EXPECT_NEAR(sum, 1, 1e-15);
        return std::pair(p, t);
    };
    EXPECT_EQ(total(1.0, 0.75), std::pair(1.0, 0.75));
    EXPECT_EQ(total(-1.0, 0.5), std::pair(-1.0, 0.5));
    EXPECT_EQ(total(9.0, 9.0), std::pair(2.0, 1.0));
    EXPECT_EQ(total(-9.0, -9.0), std::pair(-1.0, 0.0));
}

}  // namespace
}  // namespace burnish::test
