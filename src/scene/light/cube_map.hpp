// Environments as cube maps, computed on the CPU: radiance with mips, and irradiance.
//
// Faces are in OpenGL's order (+x -x +y -y +z -z) with OpenGL's axes, row 0 first.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "burnish/scene.hpp"

namespace burnish {

struct CubeMap {
    int size = 0;                   // texels a side
    std::vector<glm::vec3> texels;  // face, row, column

    const glm::vec3& at(int face, int row, int column) const {
        return texels[(static_cast<std::size_t>(face) * static_cast<std::size_t>(size) +
                       static_cast<std::size_t>(row)) *
                          static_cast<std::size_t>(size) +
                      static_cast<std::size_t>(column)];
    }
};

// Unit direction of a point of a face, (s, t) in [0, 1].
glm::vec3 cube_direction(int face, double s, double t);

// Solid angle of a texel; all texels of a cube add up to 4 pi.
double cube_texel_solid_angle(int size, int row, int column);

// Edge in texels of the cube for a lat-long map of this width: a quarter of the width, rounded up
// to a power of two, 16 to 512.
int cube_size_for(int latlong_width);

// Radiance averaged over each texel (NaN and negative values are 0). Its integral over the sphere
// equals that of the lat-long map within 0.5 %, for a sun of any size.
CubeMap cube_from_latlong(const Image& latlong, int size);

// The levels below `base`, each half the size, averaged with weights of solid angle. The last has
// size 1.
std::vector<CubeMap> cube_mips(const CubeMap& base);

// Irradiance over pi: the cosine-weighted mean over the hemisphere about each texel, exact for
// constant light.
CubeMap cube_irradiance(const CubeMap& radiance, int size);

}  // namespace burnish
