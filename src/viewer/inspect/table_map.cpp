#include "viewer/inspect/table_map.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/constants.hpp"
#include "core/index_of.hpp"

namespace burnish::viewer {
namespace {

// From the tangent to the table's x axis, counter-clockwise.
double table_angle(const SurfaceAt& at) {
    return std::atan2(at.stretch.y, at.stretch.x) + at.exemplar->angle_rad;
}

bool has_table(const SurfaceAt& at) {
    return at.exemplar && at.exemplar->exemplar >= 0;
}

double turns_in_one(double turns) {
    return turns - std::floor(turns);
}

}  // namespace

std::optional<TableCell> table_cell(const SurfaceAt& at, glm::dvec2 place) {
    const double u = glm::length(place);
    if (!has_table(at) || !(u < 1)) return std::nullopt;
    const NdfGrid& grid = at.exemplar->material->grid;
    TableCell cell;
    cell.ring = std::min(static_cast<int>(u * grid.rings), grid.rings - 1);
    const double turns =
        turns_in_one((std::atan2(place.y, place.x) - table_angle(at)) / kTwoPi) * grid.azimuths;
    cell.column = static_cast<int>(turns + 0.5) % grid.azimuths;
    cell.theta_deg = grid.theta(cell.ring) * kDegreesPerRadian;
    const double center = static_cast<double>(cell.column) / grid.azimuths;
    cell.azimuth_deg = 360 * turns_in_one(center + table_angle(at) / kTwoPi);
    const std::size_t i = index_of(cell.ring) * index_of(grid.azimuths) + index_of(cell.column);
    cell.D = static_cast<double>(at.exemplar->table()[i]);
    cell.origin = at.exemplar->origin()[i];
    return cell;
}

std::optional<glm::dvec2> table_place(const PointLobe& lobe, glm::dvec3 half, glm::dvec3 to_eye) {
    const std::optional<glm::dvec3> at = lobe.on_table(half, to_eye);
    if (!at) return std::nullopt;
    const double across = std::hypot(at->x, at->y);
    if (!(across > 0)) return glm::dvec2(0.0);
    const double u = std::sqrt(2 * std::atan2(across, at->z) / kPi);
    return glm::dvec2(at->x, at->y) * (u / across);
}

TableMap table_map(const SurfaceAt& at, int side) {
    TableMap map;
    if (!has_table(at)) return map;
    map.D = Image(side, side, 1, std::numeric_limits<float>::quiet_NaN());
    map.origin.resize(index_of(side) * index_of(side));
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            const glm::dvec2 place(2 * (column + 0.5) / side - 1, 1 - 2 * (row + 0.5) / side);
            const std::optional<TableCell> cell = table_cell(at, place);
            if (!cell) continue;
            *map.D.at(column, row) = static_cast<float>(cell->D);
            map.origin[index_of(row) * index_of(side) + index_of(column)] = cell->origin;
        }
    }
    for (const float D : at.exemplar->table())
        map.most = std::max(map.most, static_cast<double>(D));
    return map;
}

bool is_hatched(NdfOrigin origin, int x, int y, int period) {
    if (origin == NdfOrigin::measured) return false;
    const auto on_line = [period](int i) { return ((i % period) + period) % period == 0; };
    return on_line(x + y) || (origin == NdfOrigin::extrapolated && on_line(x - y));
}

}  // namespace burnish::viewer
