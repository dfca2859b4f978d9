// Problems whose optimum is known.
#include "fit/least_squares.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace burnish::test {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Rosenbrock's valley: (1 - x)^2 + 100 (y - x^2)^2, least at (1, 1).
LeastSquaresProblem valley(double low, double high) {
    LeastSquaresProblem problem;
    problem.low = VectorXd::Constant(2, low);
    problem.high = VectorXd::Constant(2, high);
    problem.evaluate = [](const VectorXd& x, VectorXd& r, MatrixXd* d) {
        r.resize(2);
        r << 1 - x[0], 10 * (x[1] - x[0] * x[0]);
        if (!d) return;
        d->resize(2, 2);
        *d << -1, 0, -20 * x[0], 10;
    };
    return problem;
}

TEST(LeastSquares, FindsTheBottomOfTheValley) {
    const auto result = minimise(valley(-5, 5), Eigen::Vector2d(-1.2, 1), 200);
    EXPECT_NEAR(result.x[0], 1, 1e-8);
    EXPECT_NEAR(result.x[1], 1, 1e-8);
    EXPECT_TRUE(result.converged);
    EXPECT_NEAR(result.start_sum, 24.2, 1e-9);  // 2.2^2 + 100 (1 - 1.44)^2
}

// With x at most 0.5 the least is there, y = x^2.
TEST(LeastSquares, StopsAtABoundAndMovesAlongIt) {
    LeastSquaresProblem problem = valley(-5, 5);
    problem.high[0] = 0.5;
    const auto result = minimise(problem, Eigen::Vector2d(-1.2, 1), 200);
    EXPECT_EQ(result.x[0], 0.5);
    EXPECT_NEAR(result.x[1], 0.25, 1e-7);
    EXPECT_NEAR(result.sum, 0.25, 1e-9);
    EXPECT_TRUE(result.converged);
}

TEST(LeastSquares, AStartOutsideIsHeldToTheBounds) {
    const auto result = minimise(valley(-0.5, 0.5), Eigen::Vector2d(100, -100), 200);
    EXPECT_NEAR(result.x[0], 0.5, 1e-9);
    EXPECT_NEAR(result.x[1], 0.25, 1e-6);
}

// What nothing depends on stays, and does not spoil the rest.
TEST(LeastSquares, AnIdleParameterStays) {
    LeastSquaresProblem problem;
    problem.low = VectorXd::Constant(2, -10);
    problem.high = VectorXd::Constant(2, 10);
    problem.evaluate = [](const VectorXd& x, VectorXd& r, MatrixXd* d) {
        r = VectorXd::Constant(1, x[0] - 3);
        if (d) *d = (MatrixXd(1, 2) << 1, 0).finished();
    };
    const auto result = minimise(problem, Eigen::Vector2d(0, 7), 50);
    EXPECT_NEAR(result.x[0], 3, 1e-9);
    EXPECT_EQ(result.x[1], 7);
}

TEST(LeastSquares, NeverEndsAboveItsStart) {
    // Residuals that overflow beyond x = 1: such steps count as worse.
    LeastSquaresProblem problem;
    problem.low = VectorXd::Constant(1, -10);
    problem.high = VectorXd::Constant(1, 10);
    problem.evaluate = [](const VectorXd& x, VectorXd& r, MatrixXd* d) {
        r = VectorXd::Constant(1, x[0] > 1 ? HUGE_VAL : x[0] - 2);
        if (d) *d = MatrixXd::Constant(1, 1, 1);
    };
    for (const double start : {-5.0, 0.0, 0.999}) {
        const auto result = minimise(problem, VectorXd::Constant(1, start), 50);
        EXPECT_LE(result.sum, result.start_sum);
        EXPECT_LE(result.x[0], 1);
    }
}

}  // namespace
}  // namespace burnish::test
