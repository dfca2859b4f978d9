#include "burnish/turntable.hpp"

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace burnish {
namespace {

// A turn about the vertical axis through a point: azimuths grow by the angle. In double, so that a turn
// by 0 changes no bit.
class VerticalTurn {
  public:
    VerticalTurn(glm::vec3 axis, double angle_rad)
        : axis_(axis), cos_(std::cos(angle_rad)), sin_(std::sin(angle_rad)) {}

    glm::vec3 direction(const glm::vec3& v) const { return glm::vec3(turned(glm::dvec3(v))); }
    glm::vec3 place(const glm::vec3& p) const {
        return glm::vec3(axis_ + turned(glm::dvec3(p) - axis_));
    }

  private:
    glm::dvec3 turned(const glm::dvec3& v) const {
        return {cos_ * v.x + sin_ * v.z, v.y, cos_ * v.z - sin_ * v.x};
    }

    glm::dvec3 axis_;
    double cos_, sin_;
};

}  // namespace

std::span<const std::string_view> turn_names() {
    static constexpr std::array<std::string_view, 3> kNames = {"object", "light", "camera"};
    return kNames;
}

TurntableFrame turntable_frame(const Camera& camera, std::span<const Light> lights,
                               float environment_rotation, Turn turn, int index, int count) {
    const double whole = glm::two_pi<double>() * index / count;
    const double angle = turn == Turn::object ? -whole : whole;
    const VerticalTurn about(camera.target, angle);
    TurntableFrame frame{camera, {lights.begin(), lights.end()}, environment_rotation};
    if (turn != Turn::light) {
        frame.camera.position = about.place(camera.position);
        frame.camera.up = about.direction(camera.up);
    }
    if (turn != Turn::camera) {
        for (Light& light : frame.lights) {
            light.position = about.place(light.position);
            light.direction = about.direction(light.direction);
            light.up = about.direction(light.up);
        }
        frame.environment_rotation =
            static_cast<float>(static_cast<double>(environment_rotation) + angle);
    }
    return frame;
}

}  // namespace burnish
