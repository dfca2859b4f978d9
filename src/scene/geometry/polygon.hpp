// Cutting polygons into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace burnish {

// Appends corners.size() - 2 triangles, as numbers of corners, that keep the polygon's direction.
// Concave outlines are cut ear by ear in the plane they lie in best; outlines that cross themselves
// or have no area come out in some way, as a fan at worst. Four corners are cut along the shorter
// diagonal that stays inside.
void triangulate(const std::vector<glm::vec3>& corners,
                 std::vector<std::array<std::uint32_t, 3>>& triangles);

}  // namespace burnish
