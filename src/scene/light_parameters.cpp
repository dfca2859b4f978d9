#include <cmath>
#include <glm/trigonometric.hpp>

#include "scene/load.hpp"

namespace burnish {

void apply_light_parameters(Scene& scene, const ParameterValues& values) {
    const auto intensity = static_cast<float>(values.real("light_intensity"));
    if (intensity <= 0.0f) return;
    const auto azimuth = static_cast<float>(glm::radians(values.real("light_azimuth")));
    const auto elevation = static_cast<float>(glm::radians(values.real("light_elevation")));
    Light light;
    light.type = LightType::directional;
    light.color = values.vec3("light_color");
    light.intensity = intensity;
    light.direction = -glm::vec3(std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                                 std::cos(azimuth) * std::cos(elevation));
    scene.lights.push_back(light);
}

}  // namespace burnish
