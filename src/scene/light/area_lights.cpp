#include "scene/light/area_lights.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "scene/light/punctual_lights.hpp"

namespace burnish {
namespace {

constexpr double kLumensPerWatt = 683.0;

}  // namespace

AreaAxes area_axes(const Light& light) {
    const glm::vec3 normal = travel_of(light);
    const glm::vec3 spare = std::abs(normal.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, 1);
    const auto beside = [&](const glm::vec3& v) { return v - normal * glm::dot(normal, v); };
    // 1e-6 of a unit vector: an `up` along the normal is rounding.
    const glm::vec3 up = beside(unit_or(light.up, spare));
    const glm::vec3 y = glm::normalize(glm::length(up) > 1e-6f ? up : beside(spare));
    if (light.type == LightType::tube)
        return {normal * (0.5f * light.size.x), y * (0.5f * light.size.y)};
    return {glm::cross(y, normal) * (0.5f * light.size.x), y * (0.5f * light.size.y)};
}

double emitting_area(const Light& light) {
    const double rectangle = static_cast<double>(light.size.x) * static_cast<double>(light.size.y);
    if (light.type == LightType::tube) return std::numbers::pi * rectangle;
    const double sides = light.two_sided ? 2.0 : 1.0;
    return sides * (light.type == LightType::disc ? std::numbers::pi / 4 * rectangle : rectangle);
}

double radiance_of_power(const Light& light, PowerUnit unit, double power) {
    if (unit == PowerUnit::radiance) return power;
    const double lumens = unit == PowerUnit::watts ? kLumensPerWatt * power : power;
    return lumens / (std::numbers::pi * emitting_area(light));
}

}  // namespace burnish
