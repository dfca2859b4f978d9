#include "capture/solve/peak_normal.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "burnish/f32.hpp"
#include "capture/solve/shading_normal.hpp"

namespace burnish {

namespace {

// Cells with at least this ratio of D to its maximum belong to the peak: there lobes of all kinds
// are nearly paraboloids in log D.
constexpr float kOfPeak = 0.33f;
// Least curvature of a point's own peak. A Gaussian of slopes has a curvature of 2 / alpha^2; this
// is alpha 0.26. A point shows only part of a broader lobe, whose center differs from the lobe's;
// refined_normal corrects that.
constexpr double kLeastPointBend = 30.0;
// Number of corrections of the normal: the visible part of the lobe depends on the normal.
constexpr int kRounds = 3;
// Slope steps of refined_normal's finite differences: first about the error of peak_normal, then
// about the final error.
constexpr float kTilts[] = {0.04f, 0.015f};
// Half width, in columns, of the search for the rotation after the normal changes.
constexpr float kFollowColumns = 0.5f;

// The slope at the minimum of a paraboloid through the errors at six slopes spaced by `step`, at
// most two steps from 0. `middle`: the error at slope 0. Both components are solved for at once: a
// lobe is narrow across its groove and broad along it, and searching in x and y alternately would
// converge slowly.
template <typename ErrorAt>
std::array<float, 2> least_slope(const ErrorAt& error, float middle, float step) {
    const float right = error(step, 0.0f), up = error(0.0f, step);
    const float left = error(-step, 0.0f), down = error(0.0f, -step);
    const float both = error(step, step);
    const float xx = right - 2.0f * middle + left, yy = up - 2.0f * middle + down;
    const float xy = both - right - up + middle;
    const float gx = 0.5f * (right - left), gy = 0.5f * (up - down);
    float x = 0.0f, y = 0.0f;
    if (const float det = xx * yy - xy * xy; xx > 0.0f && det > 0.0f) {
        x = -(yy * gx - xy * gy) / det;
        y = -(xx * gy - xy * gx) / det;
    } else {  // no minimum: descends along the convex axes
        if (xx > 0.0f) x = -gx / xx;
        if (yy > 0.0f) y = -gy / yy;
    }
    const float scale = step * std::min(1.0f, 2.0f / std::max(std::hypot(x, y), 1e-6f));
    return {scale * x, scale * y};
}

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
            // An error dD of D is an error dD / D of log D; this weight makes errors of D equal.
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
    // Slopes are limited to 40 degrees, so that the half vector stays above the horizon after a
    // tilt of 20.
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

Vec3f first_normal(NormalStart start, const SampleContext& context, const PartialNdfSolver& solver,
                   std::size_t pixel, const float* values, PixelWork& work, PartialNdfWork& partial,
                   float* table, float* weights) {
    if (start == NormalStart::highlight)
        return peak_normal(context, solver, pixel, values, work, partial, table, weights);
    Vec3f normal = {0.0f, 0.0f, 1.0f};
    context.gather(pixel, normal, values, work);
    if (start == NormalStart::shading) {
        normal = shading_normal(work.samples);
        context.gather(pixel, normal, values, work);
    }
    solver.solve(work.samples, partial, table, weights);
    return normal;
}

Vec3f refined_normal(const KnownPixel& known, Vec3f normal, PixelWork& work, PointFit& fit) {
    const auto error = [&](const Vec3f& n) {
        known.context.gather(known.pixel, n, known.values, work);
        return PointFitter(work.samples, known.eta).at(known.tables, fit.shift).error;
    };
    for (const float step : kTilts) {
        const float now = error(normal);
        const std::array<float, 2> move = least_slope(
            [&](float x, float y) {
                return error(tilted_normal(normal, {x, y}));
            },
            now, step);
        const Vec3f next = tilted_normal(normal, move);
        if (error(next) < now) normal = next;
        known.context.gather(known.pixel, normal, known.values, work);
        fit = PointFitter(work.samples, known.eta).refined(known.tables, fit.shift, kFollowColumns);
    }
    return normal;
}

}  // namespace burnish
