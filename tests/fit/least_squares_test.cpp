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
    const auto result = minimize(valley(-5, 5), Eigen::Vector2d(-1.2, 1), 200);
    EXPECT_NEAR(result.x[0], 1, 1e-8);
    EXPECT_NEAR(result.x[1], 1, 1e-8);
    EXPECT_TRUE(result.converged);
    EXPECT_NEAR(result.start_sum, 24.2, 1e-9);  // 2.2^2 + 100 (1 - 1.44)^2
}

// With x at most 0.5 the least is there, y = x^2.
TEST(LeastSquares, StopsAtABoundAndMovesAlongIt) {
    LeastSquaresProblem problem = valley(-5, 5);
    problem.high[0] = 0.5;
    const auto result = minimize(problem, Eigen::Vector2d(-1.2, 1), 200);
    EXPECT_EQ(result.x[0], 0.5);
    EXPECT_NEAR(result.x[1], 0.25, 1e-7);
    EXPECT_NEAR(result.sum, 0.25, 1e-9);
    EXPECT_TRUE(result.converged);
}

TEST(LeastSquares, AStartOutsideIsHeldToTheBounds) {
    const auto result = minimize(valley(-0.5, 0.5), Eigen::Vector2d(100, -100), 200);
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
    const auto result = minimize(problem, Eigen::Vector2d(0, 7), 50);
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
        const auto result = minimize(problem, VectorXd::Constant(1, start), 50);
        EXPECT_LE(result.sum, result.start_sum);
        EXPECT_LE(result.x[0], 1);
    }
}

// Rosenbrock's valley for a size that the compiler knows.
struct FixedValley {
    int evaluations = 0;

    void residuals(const Eigen::Vector2d& x, VectorXd& out) {
        ++evaluations;
        out = Eigen::Vector2d(1 - x[0], 10 * (x[1] - x[0] * x[0]));
    }
    void derivatives(const Eigen::Vector2d& x, VectorXd&,
                     Eigen::Matrix<double, Eigen::Dynamic, 2>& out) {
        out.resize(2, 2);
        out << -1, 0, -20 * x[0], 10;
    }
};

Eigen::Vector2d both(double value) {
    return Eigen::Vector2d::Constant(value);
}

// The same steps: products of fixed and of any size differ by rounding only.
TEST(Descent, FixedSizeGoesAsAnySize) {
    for (const double high : {5.0, 0.5})
        for (int most = 1; most < 40; most += 3) {
            FixedValley problem;
            DescentRules rules;
            rules.most_iterations = most;
            const auto fixed = Descent<2>(both(-5), both(high), rules).run(problem, {-1.2, 1});
            const auto any = minimize(valley(-5, high), Eigen::Vector2d(-1.2, 1), most);
            EXPECT_EQ(fixed.iterations, any.iterations);
            EXPECT_EQ(fixed.converged, any.converged);
            EXPECT_NEAR(fixed.sum, any.sum, 1e-9 * any.start_sum) << most;
            EXPECT_NEAR(fixed.x[0], any.x[0], 1e-7) << most;
            EXPECT_NEAR(fixed.x[1], any.x[1], 1e-7) << most;
        }
}

TEST(Descent, NoStepIsLongerThanTheRulesAllow) {
    DescentRules rules;
    rules.most_iterations = 1;
    rules.most_step = 0.125;
    FixedValley problem;
    const Eigen::Vector2d start(-1.2, 1);
    const auto result = Descent<2>(both(-5), both(5), rules).run(problem, start);
    EXPECT_LE((result.x - start).cwiseAbs().maxCoeff(), 0.125);
    EXPECT_LT(result.sum, result.start_sum);
}

TEST(Descent, ASmallGainEndsTheSearch) {
    DescentRules rules;
    rules.least_gain = 0.5;
    FixedValley problem;
    const auto early = Descent<2>(both(-5), both(5), rules).run(problem, {-1.2, 1});
    rules.least_gain = 0;
    const auto late = Descent<2>(both(-5), both(5), rules).run(problem, {-1.2, 1});
    EXPECT_TRUE(early.converged);
    EXPECT_LT(early.iterations, late.iterations);
    EXPECT_GT(early.sum, late.sum);
}

// At the bottom no step helps: after the allowed attempts, and the first evaluation, it is over.
TEST(Descent, FailedAttemptsAreCounted) {
    DescentRules rules;
    rules.most_attempts = 4;
    FixedValley problem;
    const auto result = Descent<2>(both(-5), both(5), rules).run(problem, {1, 1});
    EXPECT_EQ(problem.evaluations, 1 + 4);
    EXPECT_EQ(result.sum, 0);
    EXPECT_TRUE(result.converged);
}

}  // namespace
}  // namespace burnish::test
