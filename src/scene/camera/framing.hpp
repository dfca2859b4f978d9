// How far a camera must stand from its target to see a set of points.
#pragma once

#include <glm/vec3.hpp>

namespace burnish {

// The view is this many times as wide and high as what it frames.
inline constexpr double kFramingMargin = 1.06;

// The least distance from a target at which every included point lies within the view, with the margin.
class Framing {
  public:
    // `away`: unit, from the target to the camera. `up_hint`: not along it. `yfov`: radians. `aspect`: width over height.
    Framing(glm::vec3 target, glm::vec3 away, glm::vec3 up_hint, double yfov, double aspect);

    void include(glm::vec3 point);
    double distance() const;  // meters, at least 1e-6

    // The half height of an orthographic view of the same points, at least 1e-6.
    double half_height() const;

  private:
    glm::vec3 target_, away_, right_{0.0f}, up_{0.0f};
    double tan_x_ = 1, tan_y_ = 1, aspect_ = 1;
    double distance_ = 0, half_height_ = 0;
};

}  // namespace burnish
