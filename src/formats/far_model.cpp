#include "formats/far_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace burnish {

std::optional<glm::dvec3> center_of_far_model(const glm::dvec3& low, const glm::dvec3& high) {
    constexpr double kFarInDiagonals = 100.0;
    const double diagonal = glm::length(high - low);
    if (!(diagonal > 0.0) || !std::isfinite(diagonal)) return std::nullopt;
    const glm::dvec3 far = glm::max(glm::abs(low), glm::abs(high));
    if (std::max({far.x, far.y, far.z}) <= kFarInDiagonals * diagonal) return std::nullopt;
    const double unit = std::pow(10.0, std::floor(std::log10(diagonal)));
    return glm::round(0.5 * (low + high) / unit) * unit;
}

std::string far_model_warning(const glm::dvec3& center, std::string_view from) {
    return fmt::format(
        "the model lies far from the origin: ({:.12g}, {:.12g}, {:.12g}) is subtracted from {}, "
        "because single precision would show",
        center.x, center.y, center.z, from);
}

}  // namespace burnish
