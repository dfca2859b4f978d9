#include "fit/least_squares.hpp"

namespace burnish {
namespace {

struct Evaluated {
    const LeastSquaresProblem& problem;

    void residuals(const Eigen::VectorXd& x, Eigen::VectorXd& out) const {
        problem.evaluate(x, out, nullptr);
    }
    void derivatives(const Eigen::VectorXd& x, Eigen::VectorXd& at_x, Eigen::MatrixXd& out) const {
        problem.evaluate(x, at_x, &out);
    }
};

}  // namespace

LeastSquaresResult minimize(const LeastSquaresProblem& problem, const Eigen::VectorXd& start,
                            int most_iterations) {
    DescentRules rules;
    rules.most_iterations = most_iterations;
    Evaluated evaluated{problem};
    return Descent<Eigen::Dynamic>(problem.low, problem.high, rules).run(evaluated, start);
}

}  // namespace burnish
