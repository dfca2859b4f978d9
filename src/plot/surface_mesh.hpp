// The lobe of a reflection model as a mesh in the tangent space.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "burnish/plot/brdf_plot.hpp"

namespace burnish::plot {

struct SurfaceMesh {
    std::vector<Direction<double>> points;   // direction times scaled f: length 0..1
    std::vector<Direction<double>> normals;  // unit; the side is arbitrary
    std::vector<std::array<std::size_t, 3>> triangles;
    std::vector<std::vector<std::size_t>> lines;  // of points: rings and spokes to draw on it
};

// A polar grid about the peak whose rings crowd there, cut at the horizon.
SurfaceMesh surface_mesh(const BrdfSubject& subject, Direction<double> wi, const Scale& scale,
                         Direction<double> peak);

}  // namespace burnish::plot
