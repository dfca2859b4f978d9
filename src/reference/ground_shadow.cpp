#include "reference/ground_shadow.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "core/constants.hpp"

namespace burnish {
namespace {

// Of the heights of the scene, room for long shadows (src/gpu/draw/ground.cpp).
constexpr float kHeights = 1.5f;
// A lit plane of less irradiance than this has no shadow (shaders/ground.frag).
constexpr float kLeastLight = 1e-6f;

Ray towards(const glm::vec3& position, const glm::vec3& direction, float distance) {
    return {position, direction, 0.0f, distance};
}

}  // namespace

GroundShadow::GroundShadow(const Bounds& model, const Lamps& lamps, const Sky& sky)
    : lamps_(lamps), sky_(sky) {
    const glm::vec3 size = model.high - model.low;
    center_ = glm::vec3(model.center().x, model.low.y, model.center().z);
    half_ = std::max(0.5f * std::hypot(size.x, size.z) + kHeights * size.y, 1e-6f);
}

glm::vec3 GroundShadow::arriving(const glm::vec3& position) const {
    glm::vec3 sum = sky_.irradiance_of_ground();
    for (const PunctualLight& light : lamps_.punctual) {
        const PunctualLight::AtPoint at = light.at(position);
        sum += at.irradiance * std::max(at.direction.y, 0.0f);
    }
    for (const AreaLamp& light : lamps_.areas)
        sum += light.plain_radiance() *
               (static_cast<float>(kPi) * light.cosine_share(position, glm::vec3(0, 1, 0)));
    return sum;
}

glm::vec3 GroundShadow::blocked(const glm::vec3& position, const TracedScene& scene,
                                const Numbers& numbers) const {
    glm::vec3 sum(0.0f);
    const std::array<float, 4> first = numbers(0);
    const Sky::Sample sky = sky_.sample({first[0], first[1]});
    if (sky.pdf > 0.0f && sky.direction.y > 0.0f &&
        scene.is_blocked(towards(position, sky.direction, 0.0f)))
        sum += sky.radiance * (sky.direction.y / sky.pdf);
    for (const PunctualLight& light : lamps_.punctual) {
        const PunctualLight::AtPoint at = light.at(position);
        if (at.direction.y > 0.0f && scene.is_blocked(towards(position, at.direction, at.distance)))
            sum += at.irradiance * at.direction.y;
    }
    std::uint32_t number = 1;
    for (const AreaLamp& light : lamps_.areas) {
        const std::array<float, 4> xi = numbers(number++);
        const auto seen = light.sample(position, {xi[0], xi[1]});
        // The picture on a light counts as white, as in the renderer.
        if (seen && seen->direction.y > 0.0f &&
            scene.is_blocked(towards(position, seen->direction, seen->distance)))
            sum += light.plain_radiance() * (seen->direction.y / seen->pdf);
    }
    return sum;
}

std::optional<glm::vec3> GroundShadow::left(const Ray& ray, const TracedScene& scene,
                                            const Numbers& numbers) const {
    const float fall = -ray.direction.y;
    const float above = ray.origin.y - center_.y;
    if (!(fall > 0.0f) || !(above > 0.0f)) return std::nullopt;
    glm::vec3 position = ray.origin + ray.direction * (above / fall);
    position.y = center_.y;
    const glm::vec3 place = (position - center_) / half_;
    if (std::max(std::abs(place.x), std::abs(place.z)) > 1.0f) return std::nullopt;
    const float t = std::clamp((glm::length(place) - 0.7f) / 0.3f, 0.0f, 1.0f);
    const float shown = 1.0f - t * t * (3.0f - 2.0f * t);
    // A touch below what stands on the plane would see the underside of it.
    position.y -= 1e-5f * half_;
    const glm::vec3 all = glm::max(arriving(position), glm::vec3(kLeastLight));
    return glm::vec3(1.0f) - shown * blocked(position, scene, numbers) / all;
}

}  // namespace burnish
