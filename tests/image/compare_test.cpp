#include "burnish/compare.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace burnish {
namespace {

TEST(SquaredErrorOf, IsTheRootOfTheMeanSquare) {
    SquaredError error;
    for (const double difference : {3.0, -4.0, 0.0, 12.0}) error.add(difference);
    EXPECT_EQ(error.count, 4u);
    EXPECT_EQ(error.squares, 169.0);
    EXPECT_EQ(error.rmse(), 6.5);
}

TEST(SquaredErrorOf, PartsMergeIntoTheWhole) {
    SquaredError whole, first, second;
    for (int k = 0; k < 20; ++k) {
        whole.add(k);  // whole numbers: sums are exact in any order
        (k < 7 ? first : second).add(k);
    }
    first.merge(second);
    EXPECT_EQ(first.count, whole.count);
    EXPECT_EQ(first.rmse(), whole.rmse());
    first.merge({});
    EXPECT_EQ(first.rmse(), whole.rmse());
}

TEST(SquaredErrorOf, NothingAddedIsNoError) {
    EXPECT_EQ(SquaredError{}.rmse(), 0.0);
}

// Each factor of 10 between peak and error is 20 dB, whatever their units.
TEST(Psnr, IsRelativeToThePeakThatIsGiven) {
    EXPECT_NEAR(psnr(0.01, 1.0), 40.0, 1e-12);
    EXPECT_NEAR(psnr(0.01, 255.0), 40.0 + 20.0 * std::log10(255.0), 1e-12);
    EXPECT_NEAR(psnr(5.0, 5.0), 0.0, 1e-12);
    EXPECT_NEAR(psnr(10.0, 5.0), -20.0 * std::log10(2.0), 1e-12);
}

TEST(Psnr, OfAPerfectFitIsInfinite) {
    EXPECT_TRUE(std::isinf(psnr(0.0, 1.0)) && psnr(0.0, 1.0) > 0.0);
    EXPECT_TRUE(std::isinf(psnr(0.0, 0.0)) && psnr(0.0, 0.0) > 0.0);
}

}  // namespace
}  // namespace burnish
