#include "fit/least_squares.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <vector>

namespace burnish {
namespace {

// Parameters that may move: not at a bound that the slope pushes against.
std::vector<Eigen::Index> free_parameters(const LeastSquaresProblem& problem,
                                          const Eigen::VectorXd& x, const Eigen::VectorXd& slope) {
    std::vector<Eigen::Index> result;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        const bool held =
            (x[i] <= problem.low[i] && slope[i] > 0) || (x[i] >= problem.high[i] && slope[i] < 0);
        if (!held) result.push_back(i);
    }
    return result;
}

// The damped step of the free parameters; the others stay.
Eigen::VectorXd step_of(const Eigen::MatrixXd& normal, const Eigen::VectorXd& slope,
                        const std::vector<Eigen::Index>& free, double damping) {
    const auto n = static_cast<Eigen::Index>(free.size());
    Eigen::MatrixXd a(n, n);
    Eigen::VectorXd b(n);
    // A parameter that nothing depends on yet still needs a scale to be damped by.
    const double least = 1e-14 * normal.diagonal().maxCoeff() + 1e-300;
    for (Eigen::Index i = 0; i < n; ++i) {
        const Eigen::Index row = free[static_cast<std::size_t>(i)];
        b[i] = -slope[row];
        for (Eigen::Index j = 0; j < n; ++j)
            a(i, j) = normal(row, free[static_cast<std::size_t>(j)]);
        a(i, i) += damping * std::max(normal(row, row), least);
    }
    const Eigen::VectorXd solved = a.ldlt().solve(b);
    Eigen::VectorXd step = Eigen::VectorXd::Zero(slope.size());
    for (Eigen::Index i = 0; i < n; ++i) step[free[static_cast<std::size_t>(i)]] = solved[i];
    return step;
}

Eigen::VectorXd held(const LeastSquaresProblem& problem, const Eigen::VectorXd& x) {
    return x.cwiseMax(problem.low).cwiseMin(problem.high);
}

}  // namespace

LeastSquaresResult minimise(const LeastSquaresProblem& problem, const Eigen::VectorXd& start,
                            int most_iterations) {
    LeastSquaresResult result;
    result.x = held(problem, start);
    Eigen::VectorXd residuals, trial_residuals;
    Eigen::MatrixXd derivatives;
    problem.evaluate(result.x, residuals, &derivatives);
    result.start_sum = result.sum = residuals.squaredNorm();
    double damping = 1e-3;
    while (result.iterations < most_iterations && std::isfinite(result.sum)) {
        ++result.iterations;
        const Eigen::VectorXd slope = derivatives.transpose() * residuals;
        const Eigen::MatrixXd normal = derivatives.transpose() * derivatives;
        const auto free = free_parameters(problem, result.x, slope);
        double gained = 0, moved = 0;
        bool better = false;
        // Above 1e12 a step is too short to change a double.
        while (!better && damping < 1e12 && !free.empty()) {
            const Eigen::VectorXd trial =
                held(problem, result.x + step_of(normal, slope, free, damping));
            problem.evaluate(trial, trial_residuals, nullptr);
            const double sum = trial_residuals.squaredNorm();
            better = sum < result.sum;
            damping *= better ? 0.2 : 5;
            if (!better) continue;
            gained = result.sum - sum;
            moved = (trial - result.x)
                        .cwiseQuotient(result.x.cwiseAbs().array().max(1e-3).matrix())
                        .cwiseAbs()
                        .maxCoeff();
            result.x = trial;
            result.sum = sum;
        }
        // Nothing lowers the sum, or what does no longer matters.
        result.converged = !better || (gained <= 1e-11 * result.sum && moved < 1e-6) ||
                           gained <= 1e-15 * result.start_sum;
        if (result.converged) break;
        damping = std::max(damping, 1e-12);
        problem.evaluate(result.x, residuals, &derivatives);
    }
    return result;
}

}  // namespace burnish
