// An environment's radiance and irradiance on the CPU, as blurred as a reflection between surfaces needs it.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "scene/light/prepared_environment.hpp"

namespace burnish {

class EnvironmentLookup {
  public:
    // `rotation`: radians about +y. None: black.
    EnvironmentLookup(const PreparedEnvironment* environment, float intensity, float rotation);

    bool is_dark() const { return irradiance_.texels.empty(); }
    // The mean radiance that a lobe of roughness alpha about the unit direction sees.
    glm::vec3 radiance(const glm::vec3& direction, float alpha) const;
    // The environment as at most `count` lights of equal luminance, directions towards them: bright parts have many.
    struct SkyLamp {
        glm::vec3 direction{0.0f};   // unit, world
        glm::vec3 irradiance{0.0f};  // of a surface that faces it
    };
    std::vector<SkyLamp> lamps(int count) const;
    // Irradiance over pi of a surface of this unit normal.
    glm::vec3 irradiance(const glm::vec3& normal) const;

  private:
    struct Cube {
        int size = 0;
        std::vector<glm::vec3> texels;  // face, row, column
    };
    Cube cube_of(const HalfCube& half, float scale) const;
    glm::vec3 at(const Cube& cube, const glm::vec3& direction) const;

    std::vector<Cube> radiance_;  // from fine to coarse
    Cube irradiance_;
    std::vector<SkyLamp> texels_;  // of the finest cube, with the irradiance by each
    float cos_ = 1.0f, sin_ = 0.0f;
};

}  // namespace burnish
