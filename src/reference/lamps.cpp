#include "reference/lamps.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "rays/vectors.hpp"
#include "scene/light/area_lights.hpp"

namespace burnish {
namespace {

glm::vec3 texture_at(const Image& image, const glm::vec2& uv) {
    const float x = uv.x * static_cast<float>(image.width) - 0.5f;
    const float y = uv.y * static_cast<float>(image.height) - 0.5f;
    const float left = std::floor(x), top = std::floor(y);
    const auto texel = [&](float column, float row) {
        const float* p = image.at(std::clamp(static_cast<int>(column), 0, image.width - 1),
                                  std::clamp(static_cast<int>(row), 0, image.height - 1));
        return image.channels >= 3 ? glm::vec3(p[0], p[1], p[2]) : glm::vec3(p[0]);
    };
    return glm::mix(glm::mix(texel(left, top), texel(left + 1, top), x - left),
                    glm::mix(texel(left, top + 1), texel(left + 1, top + 1), x - left), y - top);
}

}  // namespace

PunctualLight::AtPoint PunctualLight::at(const glm::vec3& position) const {
    const f32::LightAtPoint l = f32::light_at(
        to_f32(glm::vec3(values.place)), values.place.w, to_f32(values.axis),
        f32::vec2(values.cone.x, values.cone.y), values.inverse_range2, to_f32(position));
    const float distance = directional ? 0.0f : glm::length(glm::vec3(values.place) - position);
    return {to_glm(l.wi), color * l.falloff, distance};
}

AreaLamp::AreaLamp(const Light& light)
    : light_(light), radiance_(light.color * light.intensity), visible_(light.visible) {
    const AreaAxes axes = area_axes(light);
    x_ = axes.x;
    y_ = axes.y;
}

glm::vec3 AreaLamp::radiance_at(const glm::vec2& place) const {
    if (light_.type != LightType::rectangle || !light_.texture.image) return radiance_;
    return radiance_ *
           texture_at(*light_.texture.image, {0.5f + 0.5f * place.x, 0.5f - 0.5f * place.y});
}

std::optional<AreaLamp::Seen> AreaLamp::sample(const glm::vec3& position,
                                               const glm::vec2& xi) const {
    return light_.type == LightType::tube ? sample_tube(position, xi) : sample_flat(position, xi);
}

std::optional<AreaLamp::Seen> AreaLamp::met_by(const glm::vec3& origin,
                                               const glm::vec3& direction) const {
    return light_.type == LightType::tube ? tube_met_by(origin, direction)
                                          : flat_met_by(origin, direction);
}

float AreaLamp::cosine_share(const glm::vec3& position, const glm::vec3& normal) const {
    const int shape = static_cast<int>(light_.type) - static_cast<int>(LightType::rectangle);
    const f32::AreaLight seen = f32::area_light_seen(shape, to_f32(light_.position - position),
                                                     to_f32(x_), to_f32(y_), light_.two_sided);
    return f32::area_cosine(seen, shape, to_f32(normal));
}

// ---- rectangles and ellipses ----------------------------------------------------------------------

std::optional<AreaLamp::Seen> AreaLamp::sample_flat(const glm::vec3& position,
                                                    const glm::vec2& xi) const {
    glm::vec2 place = 2.0f * xi - 1.0f;
    const bool round = light_.type == LightType::disc;
    if (round) {
        const f32::vec2 d = f32::disc_place(f32::vec2(place.x, place.y));
        place = {d.x, d.y};
    }
    const glm::vec3 to = light_.position + x_ * place.x + y_ * place.y - position;
    const glm::vec3 area = glm::cross(x_, y_);  // along the normal, a quarter of the rectangle
    const float distance2 = glm::dot(to, to);
    if (!(distance2 > 0.0f)) return std::nullopt;
    const float distance = std::sqrt(distance2);
    // Times the area: the projected area towards the position.
    const float front = -glm::dot(area, to) / distance * (round ? f32::kPi : 4.0f);
    if (!(front > 0.0f) && !(light_.two_sided && front < 0.0f)) return std::nullopt;
    return Seen{to / distance, distance, radiance_at(place), distance2 / std::abs(front)};
}

std::optional<AreaLamp::Seen> AreaLamp::flat_met_by(const glm::vec3& origin,
                                                    const glm::vec3& direction) const {
    const glm::vec3 area = glm::cross(x_, y_);
    const float fall = -glm::dot(area, direction);
    if (!(fall > 0.0f) && !(light_.two_sided && fall < 0.0f)) return std::nullopt;
    const float distance = -glm::dot(area, light_.position - origin) / fall;
    if (!(distance > 0.0f)) return std::nullopt;
    const glm::vec3 from_middle = origin + distance * direction - light_.position;
    const glm::vec2 place(glm::dot(from_middle, x_) / glm::dot(x_, x_),
                          glm::dot(from_middle, y_) / glm::dot(y_, y_));
    const bool round = light_.type == LightType::disc;
    const bool inside = round ? glm::dot(place, place) <= 1.0f
                              : std::abs(place.x) <= 1.0f && std::abs(place.y) <= 1.0f;
    if (!inside) return std::nullopt;
    const float front = std::abs(fall) * (round ? f32::kPi : 4.0f);
    return Seen{direction, distance, radiance_at(place), distance * distance / front};
}

// ---- tubes: the part of the side that faces the point ---------------------------------------------

std::optional<AreaLamp::Seen> AreaLamp::sample_tube(const glm::vec3& position,
                                                    const glm::vec2& xi) const {
    const float half_length = glm::length(x_), radius = glm::length(y_);
    const glm::vec3 axis = x_ / half_length;
    const glm::vec3 away = position - light_.position;
    const glm::vec3 beside = away - axis * glm::dot(axis, away);
    const float distance_of_axis = glm::length(beside);
    if (!(distance_of_axis > radius)) return std::nullopt;
    const glm::vec3 u = beside / distance_of_axis, v = glm::cross(axis, u);
    const float half_arc = std::acos(radius / distance_of_axis);
    const float angle = (2.0f * xi.x - 1.0f) * half_arc;
    const glm::vec3 normal = u * std::cos(angle) + v * std::sin(angle);
    const glm::vec3 to =
        light_.position + axis * ((2.0f * xi.y - 1.0f) * half_length) + normal * radius - position;
    const float distance = glm::length(to);
    const float cosine = -glm::dot(normal, to) / distance;
    if (!(cosine > 0.0f)) return std::nullopt;
    const float area = 4.0f * half_arc * radius * half_length;
    return Seen{to / distance, distance, radiance_, distance * distance / (cosine * area)};
}

std::optional<AreaLamp::Seen> AreaLamp::tube_met_by(const glm::vec3& origin,
                                                    const glm::vec3& direction) const {
    const float half_length = glm::length(x_), radius = glm::length(y_);
    const glm::vec3 axis = x_ / half_length;
    const glm::vec3 from = origin - light_.position;
    const glm::vec3 o = from - axis * glm::dot(axis, from);
    const glm::vec3 d = direction - axis * glm::dot(axis, direction);
    const float a = glm::dot(d, d), b = glm::dot(o, d), c = glm::dot(o, o) - radius * radius;
    const float square = b * b - a * c;
    if (!(c > 0.0f) || !(square > 0.0f) || !(a > 0.0f)) return std::nullopt;
    const float distance = (-b - std::sqrt(square)) / a;
    if (!(distance > 0.0f)) return std::nullopt;
    const float along = glm::dot(axis, from + distance * direction);
    if (std::abs(along) > half_length) return std::nullopt;
    const glm::vec3 normal = (o + distance * d) / radius;
    const float cosine = -glm::dot(normal, direction);
    const float half_arc = std::acos(radius / std::sqrt(c + radius * radius));
    const float area = 4.0f * half_arc * radius * half_length;
    if (!(cosine > 0.0f)) return std::nullopt;
    return Seen{direction, distance, radiance_, distance * distance / (cosine * area)};
}

Lamps::Lamps(std::span<const Light> lights) {
    for (const Light& light : lights) {
        if (has_area(light))
            areas.emplace_back(light);
        else
            punctual.push_back({punctual_values(light), light.color * light.intensity,
                                light.type == LightType::directional});
    }
}

}  // namespace burnish
