// Floats as JSON numbers that read back as the same floats.
#pragma once

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

namespace burnish::viewer {

// The double with the fewest digits that gives the float again: 0.3, not 0.30000001192092896.
double decimal_of(float value);

nlohmann::ordered_json json_of(const glm::vec3& v);  // [x, y, z]

}  // namespace burnish::viewer
