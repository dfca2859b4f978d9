// Non-linear least squares within bounds: Levenberg and Marquardt's method on the parameters that
// are free to move, those at a bound that the slope pushes against held there; steps are cut at the
// bounds and taken only when they lower the sum. Deterministic.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace burnish {

struct LeastSquaresProblem {
    Eigen::VectorXd low, high;  // bounds, both ends included
    // Residuals at x and, when wanted, their derivatives (a row a residual, a column a parameter).
    std::function<void(const Eigen::VectorXd& x, Eigen::VectorXd& residuals,
                       Eigen::MatrixXd* derivatives)>
        evaluate;
};

struct LeastSquaresResult {
    Eigen::VectorXd x;
    double start_sum = 0;  // of squares
    double sum = 0;        // never above start_sum
    int iterations = 0;
    bool converged = false;  // false: stopped after most_iterations
};

// `start` is held to the bounds first. A step that makes the residuals infinite counts as worse.
LeastSquaresResult minimise(const LeastSquaresProblem& problem, const Eigen::VectorXd& start,
                            int most_iterations);

}  // namespace burnish
