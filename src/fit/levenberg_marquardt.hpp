// Levenberg and Marquardt's method within bounds: the one loop behind every fit of the project.
// Problems whose number of parameters is known when the program is compiled use it directly (no
// allocation for the parameters); others go through least_squares.hpp. Deterministic; uses no state
// but its arguments.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

namespace burnish {

// How the search goes. The values that are set here search to full double precision.
struct DescentRules {
    int most_iterations = 100;
    // Steps of one iteration that may fail, each with more damping, before the search ends.
    int most_attempts = std::numeric_limits<int>::max();
    double relax = 0.2;  // factor on the damping after a step that lowers the sum
    double stiffen = 5;  // factor on the damping after one that does not
    // A damping below this one no longer changes a step that double precision can tell apart.
    double least_damping = 1e-12;
    // Share of the trace that damps every parameter, whatever the residuals say of it: where they
    // hardly depend on a parameter (the groove of a round lobe), its step stays finite.
    double trace_share = 0;
    // Largest change of a parameter in one step.
    double most_step = std::numeric_limits<double>::infinity();
    // The search ends after a step that lowers the sum by less than this share of it.
    double least_gain = 0;
};

// N: the number of parameters, or Eigen::Dynamic.
template <int N>
struct DescentResult {
    Eigen::Matrix<double, N, 1> x;
    double start_sum = 0;  // of squares, at the start
    double sum = 0;        // of squares, at x; never above start_sum
    int iterations = 0;
    bool converged = false;  // false: stopped after most_iterations
};

// Minimizes the sum of squares of N parameters' residuals between `low` and `high`, both included.
//
// `Problem` has
//   void residuals(const Vector& x, Eigen::VectorXd& out);
//   void derivatives(const Vector& x, Eigen::VectorXd& at_x, Derivatives& out);
// with Vector = Eigen::Matrix<double, N, 1> and Derivatives = Eigen::Matrix<double, Eigen::Dynamic,
// N>: a row a residual, a column a parameter. `at_x` holds the residuals at x and may be written
// again with the same.
//
// Parameters at a bound that the slope pushes against are held there. A step is cut at the bounds
// and taken only when it lowers the sum; a step that makes the sum infinite or not a number counts
// as worse.
template <int N>
class Descent {
  public:
    using Vector = Eigen::Matrix<double, N, 1>;
    using Square = Eigen::Matrix<double, N, N>;
    using Derivatives = Eigen::Matrix<double, Eigen::Dynamic, N>;

    Descent(const Vector& low, const Vector& high, const DescentRules& rules)
        : low_(low), high_(high), rules_(rules) {}

    // `start` is moved to the bounds first.
    template <typename Problem>
    DescentResult<N> run(Problem& problem, const Vector& start) const {
        DescentResult<N> result;
        result.x = within(start);
        Eigen::VectorXd residuals, trial_residuals;
        Derivatives derivatives;
        problem.residuals(result.x, residuals);
        result.start_sum = result.sum = residuals.squaredNorm();
        double damping = 1e-3;
        while (result.iterations < rules_.most_iterations && std::isfinite(result.sum)) {
            ++result.iterations;
            problem.derivatives(result.x, residuals, derivatives);
            const Vector slope = transposed_times(derivatives, residuals);
            const Square normal = transposed_times(derivatives, derivatives);
            const Indices free = free_parameters(result.x, slope);
            double gained = 0, moved = 0;
            bool better = false;
            // Above 1e12 a step is too short to change a double.
            for (int attempt = 0;
                 attempt < rules_.most_attempts && !better && damping < 1e12 && free.size() > 0;
                 ++attempt) {
                const Vector trial = within(result.x + step_of(normal, slope, free, damping));
                problem.residuals(trial, trial_residuals);
                const double sum = trial_residuals.squaredNorm();
                better = sum < result.sum;
                damping *= better ? rules_.relax : rules_.stiffen;
                if (!better) continue;
                gained = result.sum - sum;
                // 1e-3: a parameter that is nearly 0 counts as that large.
                moved = (trial - result.x)
                            .cwiseQuotient(result.x.cwiseAbs().array().max(1e-3).matrix())
                            .cwiseAbs()
                            .maxCoeff();
                result.x = trial;
                result.sum = sum;
                residuals.swap(trial_residuals);
            }
            // Nothing lowers the sum, or what lowers it is within the rounding of sums of squares.
            result.converged = !better || (gained <= 1e-11 * result.sum && moved < 1e-6) ||
                               gained <= 1e-15 * result.start_sum ||
                               gained < rules_.least_gain * (result.sum + gained);
            if (result.converged) break;
            damping = std::max(damping, rules_.least_damping);
        }
        return result;
    }

  private:
    using Indices = Eigen::Matrix<Eigen::Index, Eigen::Dynamic, 1, 0, N, 1>;

    // For a few parameters Eigen's blocked product costs more than the sums themselves.
    template <typename Right>
    static auto transposed_times(const Derivatives& left, const Right& right) {
        if constexpr (N == Eigen::Dynamic)
            return (left.transpose() * right).eval();
        else
            return left.transpose().lazyProduct(right).eval();
    }

    Vector within(const Vector& x) const { return x.cwiseMax(low_).cwiseMin(high_); }

    // Those not at a bound that the slope pushes against.
    Indices free_parameters(const Vector& x, const Vector& slope) const {
        Indices result(x.size());
        Eigen::Index count = 0;
        for (Eigen::Index i = 0; i < x.size(); ++i) {
            const bool held =
                (x[i] <= low_[i] && slope[i] > 0) || (x[i] >= high_[i] && slope[i] < 0);
            if (!held) result[count++] = i;
        }
        result.conservativeResize(count);
        return result;
    }

    // The damped step of the free parameters; the others stay.
    Vector step_of(const Square& normal, const Vector& slope, const Indices& free,
                   double damping) const {
        const Eigen::Index n = free.size();
        Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, N, N> a(n, n);
        Eigen::Matrix<double, Eigen::Dynamic, 1, 0, N, 1> b(n);
        // A parameter that no residual depends on yet still needs a scale to be damped by.
        const double least = 1e-14 * normal.diagonal().maxCoeff() + 1e-300;
        const double shared = rules_.trace_share * normal.trace();
        for (Eigen::Index i = 0; i < n; ++i) {
            b[i] = -slope[free[i]];
            for (Eigen::Index j = 0; j < n; ++j) a(i, j) = normal(free[i], free[j]);
            a(i, i) += damping * (std::max(normal(free[i], free[i]), least) + shared);
        }
        const Eigen::Matrix<double, Eigen::Dynamic, 1, 0, N, 1> solved = a.ldlt().solve(b);
        Vector step = Vector::Zero(slope.size());
        for (Eigen::Index i = 0; i < n; ++i)
            step[free[i]] = std::clamp(solved[i], -rules_.most_step, rules_.most_step);
        return step;
    }

    Vector low_, high_;
    DescentRules rules_;
};

}  // namespace burnish
