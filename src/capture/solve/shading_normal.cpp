#include "capture/solve/shading_normal.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "capture/solve/peak_normal.hpp"

namespace burnish {

namespace {

// Rounds of leaving out highlights; the chosen samples settle within a few.
constexpr int kRounds = 8;
// A sample is left out where its residual is above this multiple of the median absolute residual:
// about 2 standard deviations of Gaussian noise.
constexpr double kBrighter = 3.0;
// Least share of the samples that are kept: highlights of lobes that a stack can resolve cover less
// than the rest.
constexpr double kLeastKept = 0.5;
// Least ratio of the smallest to the largest singular value of the directions' equations: 1 degree
// of spread of the lights.
constexpr double kLeastSpread = 3e-4;

struct Row {
    Eigen::Vector3d light;  // towards it, times the irradiance at normal incidence
    double value;
};

std::vector<Row> rows_of(const PointSamples& samples) {
    std::vector<Row> rows;
    for (std::size_t q = 0; q < samples.size(); ++q) {
        const Vec3f& i = samples.to_light[q];
        const auto arriving = static_cast<double>(samples.received[q] / i[2]);
        rows.push_back(
            {arriving * Eigen::Vector3d(static_cast<double>(i[0]), static_cast<double>(i[1]),
                                        static_cast<double>(i[2])),
             static_cast<double>(samples.value[q])});
    }
    return rows;
}

// Albedo times normal by least squares over the rows that are kept; 0 if they do not determine it.
Eigen::Vector3d least_squares(const std::vector<Row>& rows, const std::vector<bool>& kept) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t q = 0; q < rows.size(); ++q) {
        if (!kept[q]) continue;
        normal += rows[q].light * rows[q].light.transpose();
        right += rows[q].light * rows[q].value;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(normal);
    const Eigen::Vector3d& square = axes.eigenvalues();
    if (!(square[0] > kLeastSpread * kLeastSpread * square[2])) return Eigen::Vector3d::Zero();
    return axes.eigenvectors() * (axes.eigenvectors().transpose() * right).cwiseQuotient(square);
}

// Keeps the rows that are not much brighter than predicted, at least kLeastKept of them.
std::vector<bool> without_highlights(const std::vector<Row>& rows, const Eigen::Vector3d& found) {
    std::vector<double> residuals, sizes;
    for (const Row& row : rows) {
        residuals.push_back(row.value - std::max(row.light.dot(found), 0.0));
        sizes.push_back(std::abs(residuals.back()));
    }
    const auto at = [](std::vector<double> values, double share) {
        const auto place =
            static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
        std::nth_element(values.begin(), values.begin() + place, values.end());
        return values[static_cast<std::size_t>(place)];
    };
    const double most = std::max(kBrighter * at(sizes, 0.5), at(residuals, kLeastKept));
    std::vector<bool> kept;
    for (const double residual : residuals) kept.push_back(residual <= most);
    return kept;
}

}  // namespace

Vec3f shading_normal(const PointSamples& samples) {
    const Vec3f upright{0.0f, 0.0f, 1.0f};
    if (samples.size() < 4) return upright;
    const std::vector<Row> rows = rows_of(samples);
    std::vector<bool> kept(rows.size(), true);
    Eigen::Vector3d found = Eigen::Vector3d::Zero();
    for (int round = 0; round < kRounds; ++round) {
        found = least_squares(rows, kept);
        if (!(found[2] > 0.0)) return upright;
        std::vector<bool> next = without_highlights(rows, found);
        if (next == kept) break;
        kept = std::move(next);
    }
    return tilted_normal(upright, {static_cast<float>(found[0] / found[2]),
                                   static_cast<float>(found[1] / found[2])});
}

}  // namespace burnish
