#include "viewer/inspect/lobe_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/constants.hpp"
#include "core/index_of.hpp"

namespace burnish::viewer {
namespace {

double radius_of(const PointLobe& lobe, glm::dvec3 to_light, glm::dvec3 to_eye) {
    const glm::dvec3 f = lobe.eval_cos(to_light, to_eye);
    return f64::luminance(f64::vec3(f));
}

// Two unit vectors across `axis`, so that (x, y, axis) is right-handed.
struct Across {
    glm::dvec3 x, y;

    explicit Across(glm::dvec3 axis) {
        const glm::dvec3 helper =
            std::abs(axis.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
        y = glm::normalize(glm::cross(axis, helper));
        x = glm::cross(y, axis);
    }
};

// The direction to the eye for which the light is mirrored about the peak.
glm::dvec3 mirror_of_light(const PointLobe& lobe, glm::dvec3 to_light, glm::dvec3 to_eye) {
    const glm::dvec3 h = lobe.peak(to_eye);
    const glm::dvec3 mirror = 2 * glm::dot(to_light, h) * h - to_light;
    return mirror.z > 0 ? mirror : lobe.normal(to_eye);
}

// Angles from -limit to limit, both sides of `middle` as dense as steps that grow with the square of
// their number: the first is 1/1600 of the way.
std::vector<double> angles_about(double middle, double limit) {
    constexpr int kSteps = 40, kEven = 90;
    std::vector<double> angles{middle};
    for (int i = 1; i <= kSteps; ++i) {
        const double step = kPi * i * i / (kSteps * kSteps);
        for (const double angle : {middle - step, middle + step})
            if (std::abs(angle) < limit) angles.push_back(angle);
    }
    for (int i = 0; i <= kEven; ++i) angles.push_back(limit * (2.0 * i / kEven - 1));
    std::sort(angles.begin(), angles.end());
    return angles;
}

}  // namespace

LobeDisk lobe_disk(const PointLobe& lobe, glm::dvec3 to_eye, int side) {
    LobeDisk disk;
    disk.D = Image(side, side, 1, std::numeric_limits<float>::quiet_NaN());
    if (!lobe.has_half_vectors()) return disk;
    const auto place = [side](double v) { return 2 * (v + 0.5) / side - 1; };
    std::vector<std::optional<NdfOrigin>> origin(index_of(side) * index_of(side));
    bool known = false;
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            const double x = place(column), y = -place(row);
            if (!(x * x + y * y < 1)) continue;
            const glm::dvec3 h(x, y, std::sqrt(1 - x * x - y * y));
            const double D = lobe.D(h, to_eye);
            *disk.D.at(column, row) = static_cast<float>(D);
            disk.most = std::max(disk.most, D);
            auto& cell = origin[index_of(row) * index_of(side) + index_of(column)];
            cell = lobe.origin(h, to_eye);
            known = known || cell.has_value();
        }
    }
    if (known) disk.origin = std::move(origin);
    const glm::dvec3 peak = lobe.peak(to_eye);
    const auto texel = [side](double v) {
        return std::clamp(static_cast<int>(0.5 * (v + 1) * side), 0, side - 1);
    };
    const double D = lobe.D(peak, to_eye);
    float& holds = *disk.D.at(texel(peak.x), texel(-peak.y));
    // Written so that a texel outside the disk, NaN, takes the value.
    if (!(static_cast<double>(holds) > D)) holds = static_cast<float>(D);
    disk.most = std::max(disk.most, D);
    return disk;
}

LobeMesh lobe_mesh(const PointLobe& lobe, glm::dvec3 to_light, glm::dvec3 to_eye, int rows,
                   int columns) {
    LobeMesh mesh;
    mesh.rows = rows;
    mesh.columns = columns;
    const glm::dvec3 axis = mirror_of_light(lobe, to_light, to_eye);
    const Across across(axis);
    for (int row = 0; row < rows; ++row) {
        const double part = static_cast<double>(row) / (rows - 1);
        const double theta = kPi * part * part;
        for (int column = 0; column < columns; ++column) {
            const double phi = kTwoPi * column / columns;
            const glm::dvec3 d = glm::normalize(
                axis * std::cos(theta) +
                (across.x * std::cos(phi) + across.y * std::sin(phi)) * std::sin(theta));
            const double radius = radius_of(lobe, to_light, d);
            mesh.vertices.emplace_back(d * radius);
            mesh.most = std::max(mesh.most, radius);
        }
    }
    for (int row = 0; row + 1 < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const int next = (column + 1) % columns;
            const auto at = [&](int r, int c) {
                return static_cast<std::uint32_t>(r * columns + c);
            };
            const std::uint32_t a = at(row, column), b = at(row + 1, column);
            const std::uint32_t c = at(row + 1, next), d = at(row, next);
            // The first and the last row are points.
            if (row + 2 < rows) mesh.triangles.insert(mesh.triangles.end(), {a, b, c});
            if (row > 0) mesh.triangles.insert(mesh.triangles.end(), {a, c, d});
        }
    }
    return mesh;
}

PolarCuts polar_cuts(const PointLobe& lobe, glm::dvec3 to_light, glm::dvec3 to_eye) {
    PolarCuts cuts;
    const glm::dvec3 n = lobe.normal(to_eye);
    const glm::dvec3 beside = to_light - n * glm::dot(n, to_light);
    // 1e-9: a light along n~ lies in every plane; the lobe's x axis chooses one.
    const glm::dvec3 x = lobe.outer({1, 0, 0});
    const glm::dvec3 towards = glm::length(beside) > 1e-9 ? -glm::normalize(beside)
                                                          : glm::normalize(x - n * glm::dot(n, x));
    const auto cut = [&](std::vector<PolarPoint>& into, glm::dvec3 up, glm::dvec3 side,
                         double middle, double limit) {
        for (const double angle : angles_about(middle, limit)) {
            const glm::dvec3 d = glm::normalize(up * std::cos(angle) + side * std::sin(angle));
            into.push_back({angle, radius_of(lobe, to_light, d)});
            cuts.most = std::max(cuts.most, into.back().radius);
        }
    };
    cuts.light_angle_rad = -std::acos(std::clamp(glm::dot(n, to_light), -1.0, 1.0));
    const glm::dvec3 mirror = mirror_of_light(lobe, to_light, to_eye);
    const double mirror_angle = std::atan2(glm::dot(mirror, towards), glm::dot(mirror, n));
    cut(cuts.incidence, n, towards, std::clamp(mirror_angle, -kHalfPi, kHalfPi), kHalfPi);
    // The normal of the plane of incidence, made perpendicular to the mirror direction.
    const glm::dvec3 normal_of_plane = glm::cross(n, towards);
    const glm::dvec3 side = normal_of_plane - mirror * glm::dot(mirror, normal_of_plane);
    // 1e-9: a mirror direction along that normal, which only a lobe far from n~ has.
    cut(cuts.across, mirror, glm::length(side) > 1e-9 ? glm::normalize(side) : n, 0.0, kHalfPi);
    return cuts;
}

}  // namespace burnish::viewer
