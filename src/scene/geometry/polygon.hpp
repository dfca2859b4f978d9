// Cutting polygons into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace burnish {

// Appends corners.size() - 2 triangles, as indices into `corners`, that keep the polygon's
// orientation. Concave outlines are cut ear by ear in the coordinate plane in which they are
// largest. Outlines that cross themselves or have no area give some triangulation, at worst a fan.
// Quadrilaterals are cut along the shorter diagonal that stays inside.
void triangulate(const std::vector<glm::vec3>& corners,
                 std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace burnish
