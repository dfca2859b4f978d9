#include "scene/camera/framing.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace burnish {
namespace {

// A camera must differ from the target for a single point too.
constexpr double kLeast = 1e-6;

}  // namespace

Framing::Framing(glm::vec3 target, glm::vec3 away, glm::vec3 up_hint, double yfov, double aspect)
    : target_(target), away_(away), aspect_(aspect) {
    right_ = glm::normalize(glm::cross(up_hint, away));
    up_ = glm::cross(away, right_);
    tan_y_ = std::tan(yfov / 2) / kFramingMargin;
    tan_x_ = tan_y_ * aspect;
}

void Framing::include(glm::vec3 point) {
    const glm::vec3 v = point - target_;
    const double depth = glm::dot(v, away_);
    const double across = std::abs(glm::dot(v, right_)), height = std::abs(glm::dot(v, up_));
    distance_ = std::max(distance_, depth + std::max(across / tan_x_, height / tan_y_));
    half_height_ = std::max({half_height_, across / aspect_, height});
}

double Framing::distance() const {
    return std::max(distance_, kLeast);
}

double Framing::half_height() const {
    return std::max(half_height_ * kFramingMargin, kLeast);
}

}  // namespace burnish
