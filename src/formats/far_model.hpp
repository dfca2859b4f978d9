// Models in map coordinates: so far from the origin that single precision would show.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace burnish {

// The center to subtract from a model whose positions lie between `low` and `high`, rounded to one
// digit of the diagonal, so that it can be added again by hand. None for a model that is near enough:
// farther than 100 times its diagonal, floats differ by more than 1/84000 of the diagonal.
std::optional<glm::dvec3> center_of_far_model(const glm::dvec3& low, const glm::dvec3& high);

// The warning of a center that was subtracted; `from`: "its positions".
std::string far_model_warning(const glm::dvec3& center, std::string_view from);

}  // namespace burnish
