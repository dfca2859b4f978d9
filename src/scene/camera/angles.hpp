// Directions by azimuth and elevation, as cameras, lights and environments have them (docs/theory/
// conventions.md): +y up; azimuth 0 is +z, 90 degrees is +x; elevation is above the horizon.
#pragma once

#include <glm/vec3.hpp>

namespace burnish {

struct DirectionAngles {
    double azimuth_deg = 0;    // (-180, 180]; 0 at the zenith and the nadir
    double elevation_deg = 0;  // -90 to 90
};

// Unit.
glm::dvec3 direction_at(DirectionAngles angles);
// Of a direction of any length but 0.
DirectionAngles angles_of(glm::dvec3 direction);

}  // namespace burnish
