#include "viewer/document/json_numbers.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string>

namespace burnish::viewer {

double decimal_of(float value) {
    const std::string digits = fmt::format("{}", value);
    double number = 0.0;
    std::from_chars(digits.data(), digits.data() + digits.size(), number);
    // Rounding twice, to double and to float, may end at a neighbor.
    return static_cast<float>(number) == value ? number : static_cast<double>(value);
}

nlohmann::ordered_json json_of(const glm::vec3& v) {
    return {decimal_of(v.x), decimal_of(v.y), decimal_of(v.z)};
}

}  // namespace burnish::viewer
