// The table of a measured material at a point, as a map: which cell lies where, its value, and how it is known.
//
// The map is a disk in the parameters of the table: the radius is u = sqrt(2 theta / pi), of which every ring has
// an equal step, and the azimuth runs counter-clockwise from the tangent of the surface. (0, 0) is the normal of
// the texel, the rim its horizon; x and y go from -1 to 1, y up.
//
// Threads: functions of their arguments.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "burnish/image.hpp"
#include "viewer/inspect/point_lobe.hpp"
#include "viewer/inspect/surface_at.hpp"

namespace burnish::viewer {

struct TableCell {
    int ring = 0, column = 0;  // of the grid
    double theta_deg = 0;      // of its center, from the texel's normal
    double azimuth_deg = 0;    // likewise, from the tangent, [0, 360)
    double D = 0;              // per steradian
    NdfOrigin origin = NdfOrigin::extrapolated;
};
// The cell at a place of the disk. None outside the disk, and for a point without a table.
std::optional<TableCell> table_cell(const SurfaceAt& at, glm::dvec2 place);

// Where a method reads the table for a half vector. None for other lobes, and where the method says D = 0.
std::optional<glm::dvec2> table_place(const PointLobe& lobe, glm::dvec3 half, glm::dvec3 to_eye);

struct TableMap {
    Image
        D;  // side x side, one channel, the value of the cell; NaN outside the disk; row 0 at y = 1
    std::vector<std::optional<NdfOrigin>> origin;  // likewise
    double most = 0;                               // the largest value of the table
};
// Empty for a point without a table. `side`: at least 1.
TableMap table_map(const SurfaceAt& at, int side);

// How pictures tell cells that were not measured, without color: lines over completed ones, crossed lines over
// extrapolated ones. Whether the pixel lies on a line; `period`: of the lines, in pixels, at least 1.
bool is_hatched(NdfOrigin origin, int x, int y, int period);

}  // namespace burnish::viewer
