#include "scene/camera/angles.hpp"

#include <cmath>

#include "core/constants.hpp"

namespace burnish {

glm::dvec3 direction_at(DirectionAngles angles) {
    const double azimuth = angles.azimuth_deg * kDegree;
    const double elevation = angles.elevation_deg * kDegree;
    return {std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
            std::cos(azimuth) * std::cos(elevation)};
}

DirectionAngles angles_of(glm::dvec3 d) {
    const double across = std::hypot(d.x, d.z);
    const double azimuth = across > 0 ? std::atan2(d.x, d.z) : 0.0;
    return {azimuth * kDegreesPerRadian, std::atan2(d.y, across) * kDegreesPerRadian};
}

}  // namespace burnish
