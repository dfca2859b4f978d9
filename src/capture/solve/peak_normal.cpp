#include "capture/solve/peak_normal.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "burnish/f32.hpp"

namespace burnish {

namespace {

constexpr float kOfPeak = 0.33f;
// Broader lobes than of alpha 0.26 (a Gaussian of slopes bends by 2 / alpha^2) are cut off by what
// a point sees of them, and their middle with them; refined_normal finds it.
constexpr double kLeastPointBend = 30.0;
// The part that is seen changes with the normal it is seen from: once more.
constexpr int kRounds = 3;

}  // namespace

std::array<float, 2> peak_slope(const NdfGrid& grid, const float* table, const float* weights,
                                double least_bend) {
    float most = 0.0f;
    for (int i = 0; i < grid.cells(); ++i)
        if (weights[i] > 0.0f) most = std::max(most, table[i]);
    if (!(most > 0.0f)) return {};
    Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
    for (int r = 0; r < grid.rings; ++r) {
        const double theta = static_cast<double>(grid.theta(static_cast<float>(r)));
        for (int c = 0; c < grid.azimuths; ++c) {
            const int i = r * grid.azimuths + c;
            if (weights[i] <= 0.0f || table[i] < kOfPeak * most) continue;
            const double phi = 2.0 * std::numbers::pi * c / grid.azimuths;
            const double x = std::tan(theta) * std::cos(phi), y = std::tan(theta) * std::sin(phi);
            Eigen::Matrix<double, 6, 1> row;
            row << 1.0, x, y, x * x, x * y, y * y;
            const double value = static_cast<double>(table[i] / most);
            // An error of D is one of log D by D.
            const double weight = value * value * grid.solid_angle(r);
            normal += weight * row * row.transpose();
            right += weight * std::log(value) * row;
        }
    }
    const Eigen::Matrix<double, 6, 1> fit = normal.ldlt().solve(right);
    Eigen::Matrix2d bend;
    bend << -2.0 * fit[3], -fit[4], -fit[4], -2.0 * fit[5];
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(bend);
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (int k = 0; k < 2; ++k) {
        const double curvature = axes.eigenvalues()[k];
        if (!(curvature > least_bend)) continue;
        const Eigen::Vector2d axis = axes.eigenvectors().col(k);
        middle += axis * (axis[0] * fit[1] + axis[1] * fit[2]) / curvature;
    }
    if (!middle.allFinite()) return {};
    return {static_cast<float>(middle[0]), static_cast<float>(middle[1])};
}

Vec3f tilted_normal(const Vec3f& normal, const std::array<float, 2>& slope) {
    const f32::Frame frame = f32::frame_shortest_arc(f32::vec3(normal[0], normal[1], normal[2]));
    // Below 40 degrees, what is tilted by 20 stays above the horizon.
    const float steep = std::hypot(slope[0], slope[1]), steepest = std::tan(2.0f * kMostTilt);
    const float part = steep > steepest ? steepest / steep : 1.0f;
    const f32::vec3 m = frame.t * (part * slope[0]) + frame.b * (part * slope[1]) + frame.n;
    const float x = m.x / m.z, y = m.y / m.z, size = std::hypot(x, y);
    const float most = std::tan(kMostTilt);
    const float scale = size > most ? most / size : 1.0f;
    const float length = std::sqrt(1.0f + scale * scale * size * size);
    return {scale * x / length, scale * y / length, 1.0f / length};
}

Vec3f peak_normal(const SampleContext& context, const PartialNdfSolver& solver, std::size_t pixel,
                  const float* values, PixelWork& work, PartialNdfWork& partial, float* table,
                  float* weights) {
    Vec3f normal = {0.0f, 0.0f, 1.0f};
    for (int round = 0;; ++round) {
        context.gather(pixel, normal, values, work);
        solver.solve(work.samples, partial, table, weights);
        if (round == kRounds) return normal;
        normal = tilted_normal(normal, peak_slope(context.grid, table, weights, kLeastPointBend));
    }
}

}  // namespace burnish
