#include "burnish/lobe_fit.hpp"

#include <algorithm>
#include <cmath>

#include "burnish/f64.hpp"
#include "burnish/tabulated_material.hpp"
#include "core/constants.hpp"
#include "core/parallel.hpp"
#include "fit/least_squares.hpp"

namespace burnish {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Least alpha that is fitted: tables of 32 rings, whose second ring lies at 0.2 degrees, resolve
// nothing narrower.
constexpr double kLeastFitted = 0.002;
// Largest alpha that is fitted: a broader lobe can hardly be told from an even distribution.
constexpr double kMostFitted = 1.5;

struct Cells {
    std::vector<f64::vec3> h;       // their middles
    std::vector<double> root;       // of solid angle times n.h
    VectorXd table;                 // roots of D n.h dw, of length 1
    double xx = 0, xy = 0, yy = 0;  // second moments of (h_x, h_y)
};

Cells cells_of(const NdfGrid& grid, const float* table) {
    Cells out;
    const auto count = static_cast<std::size_t>(grid.cells());
    out.h.reserve(count);
    out.root.reserve(count);
    out.table.resize(grid.cells());
    for (int ring = 0; ring < grid.rings; ++ring) {
        const double u = (ring + 0.5) / grid.rings, theta = u * u * kPi / 2;
        const double weight = grid.solid_angle(ring) * std::cos(theta);
        for (int column = 0; column < grid.azimuths; ++column) {
            const double phi = 2 * kPi * column / grid.azimuths;
            const double x = std::sin(theta) * std::cos(phi), y = std::sin(theta) * std::sin(phi);
            const int cell = ring * grid.azimuths + column;
            const double mass = weight * std::max(static_cast<double>(table[cell]), 0.0);
            out.h.emplace_back(x, y, std::cos(theta));
            out.root.push_back(std::sqrt(weight));
            out.table[cell] = std::sqrt(mass);
            out.xx += mass * x * x;
            out.xy += mass * x * y;
            out.yy += mass * y * y;
        }
    }
    out.table /= std::max(out.table.norm(), 1e-300);
    return out;
}

// Parameters of the search: the logarithm of the symmetric matrix of widths, x = (p, d cos 2a, d
// sin 2a), with ln alpha = p - d along the groove, whose angle is a, and p + d across it. Round
// lobes (d = 0) are not singular there.
struct Widths {
    double along, across, groove;
};

Widths widths_of(Mdf mdf, const VectorXd& x) {
    const double most = mdf == Mdf::ashikhmin_shirley ? 1.0 : kMostFitted;
    const double d = std::hypot(x[1], x[2]);
    return {std::clamp(std::exp(x[0] - d), kLeastFitted, most),
            std::clamp(std::exp(x[0] + d), kLeastFitted, most), 0.5 * std::atan2(x[2], x[1])};
}

void lobe_roots(const Cells& cells, Mdf mdf, const VectorXd& x, VectorXd& out) {
    const Widths w = widths_of(mdf, x);
    const f64::Lobe lobe = f64::lobe_from_alpha(static_cast<int>(mdf), w.along, w.across);
    const f64::Perturbation flat =
        f64::perturb_make(f64::kMethodNone, f64::vec3(0.0, 0.0, 1.0), true, false);
    const double c = std::cos(w.groove), s = std::sin(w.groove);
    out.resize(cells.table.size());
    for (std::size_t i = 0; i < cells.h.size(); ++i) {
        const f64::vec3& h = cells.h[i];
        const f64::vec3 own(c * h.x + s * h.y, c * h.y - s * h.x, h.z);
        out[static_cast<Eigen::Index>(i)] =
            cells.root[i] * std::sqrt(std::max(f64::lobe_D(lobe, flat, own), 0.0));
    }
    // A lobe far narrower than the cells may be 0 at all of them.
    out /= std::max(out.norm(), 1e-300);
}

LeastSquaresProblem problem_of(const Cells& cells, Mdf mdf) {
    LeastSquaresProblem problem;
    // Widths are held to their limits in widths_of; these are beyond.
    problem.low = Eigen::Vector3d(std::log(kLeastFitted), -5.0, -5.0);
    problem.high = Eigen::Vector3d(std::log(kMostFitted), 5.0, 5.0);
    problem.evaluate = [&cells, mdf](const VectorXd& x, VectorXd& residuals, MatrixXd* slopes) {
        lobe_roots(cells, mdf, x, residuals);
        residuals -= cells.table;
        if (!slopes) return;
        // Central differences: of steps this long the cut is 1e-9 and rounding 1e-12.
        constexpr double kStep = 1e-4;
        slopes->resize(residuals.size(), 3);
        VectorXd above, below;
        for (Eigen::Index k = 0; k < 3; ++k) {
            VectorXd moved = x;
            moved[k] = x[k] + kStep;
            lobe_roots(cells, mdf, moved, above);
            moved[k] = x[k] - kStep;
            lobe_roots(cells, mdf, moved, below);
            slopes->col(k) = (above - below) / (2 * kStep);
        }
    };
    return problem;
}

// The best of a coarse lattice of widths along the axes of the table's moments.
VectorXd start_of(const Cells& cells, const LeastSquaresProblem& problem) {
    // The axis of the larger moment; the groove is at a right angle to it.
    const double groove = 0.5 * std::atan2(2 * cells.xy, cells.xx - cells.yy) + kPi / 2;
    VectorXd best, residuals;
    double least = HUGE_VAL;
    for (const double along : {0.01, 0.03, 0.08, 0.2, 0.4, 0.8})
        for (const double across : {0.01, 0.03, 0.08, 0.2, 0.4, 0.8}) {
            const double d = 0.5 * std::log(across / along);
            const VectorXd x = Eigen::Vector3d(0.5 * std::log(across * along),
                                               d * std::cos(2 * groove), d * std::sin(2 * groove));
            problem.evaluate(x, residuals, nullptr);
            if (residuals.squaredNorm() >= least) continue;
            least = residuals.squaredNorm();
            best = x;
        }
    return best;
}

double line_angle(double angle) {
    const double wrapped = angle - kPi * std::floor(angle / kPi);
    return wrapped < kPi ? wrapped : 0.0;  // of -1e-17, rounding makes pi
}

}  // namespace

LobeFit fit_lobe(const NdfGrid& grid, const float* table, Mdf mdf) {
    const Cells cells = cells_of(grid, table);
    const LeastSquaresProblem problem = problem_of(cells, mdf);
    const LeastSquaresResult result = minimize(problem, start_of(cells, problem), 100);
    LobeFit out;
    const Widths widths = widths_of(mdf, result.x);
    out.alpha_along = widths.along;
    out.alpha_across = widths.across;
    out.groove = line_angle(widths.groove);
    // Of unit vectors, |a - b|^2 / 2 = 1 - a.b
    out.residual = std::sqrt(std::clamp(result.sum / 2, 0.0, 1.0));
    return out;
}

std::vector<LobeFit> fit_lobes(const TabulatedMaterial& material, Mdf mdf) {
    std::vector<LobeFit> out(static_cast<std::size_t>(material.exemplars));
    parallel_for(out.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t e = begin; e < end; ++e)
            out[e] = fit_lobe(material.grid, material.table(static_cast<int>(e)), mdf);
    });
    return out;
}

}  // namespace burnish
