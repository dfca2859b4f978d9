// Non-linear least squares within bounds, for any number of parameters (levenberg_marquardt.hpp has
// the method). Deterministic; may be called from any thread.
#pragma once

#include <Eigen/Core>
#include <functional>

#include "fit/levenberg_marquardt.hpp"

namespace burnish {

struct LeastSquaresProblem {
    Eigen::VectorXd low, high;  // bounds, both ends included
    // Residuals at x and, when wanted, their derivatives (a row a residual, a column a parameter).
    std::function<void(const Eigen::VectorXd& x, Eigen::VectorXd& residuals,
                       Eigen::MatrixXd* derivatives)>
        evaluate;
};

using LeastSquaresResult = DescentResult<Eigen::Dynamic>;

// `start` is moved to the bounds first. A step that makes the residuals infinite counts as worse.
LeastSquaresResult minimize(const LeastSquaresProblem& problem, const Eigen::VectorXd& start,
                            int most_iterations);

}  // namespace burnish
