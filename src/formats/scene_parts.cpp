#include "formats/scene_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <nlohmann/json.hpp>
#include <vector>

#include "burnish/draft.hpp"
#include "burnish/error.hpp"
#include "burnish/parameters.hpp"
#include "burnish/scratch_settings.hpp"
#include "core/text.hpp"

namespace burnish {
namespace {

constexpr double kFar = 1e6;                        // meters, as in the parameter table
constexpr double kSmallest = 1e-6, kLargest = 1e6;  // scale factors

glm::vec3 read_color(const JsonPlace& place) {
    if (!place.is_text()) return place.triple(0.0, 1.0);
    ParameterValues parser;
    try {
        parser.set("base_color", place.text(), "");
    } catch (const UsageError&) {
        place.fail("[r, g, b] from 0 to 1 or \"#rrggbb\"");
    }
    return parser.vec3("base_color");
}

glm::vec3 read_direction(const JsonPlace& place) {
    const glm::vec3 direction = place.triple(-kFar, kFar);
    // The square of a shorter vector would underflow, and no such vector is an intended direction.
    if (glm::length(direction) < 1e-12f) place.fail("a direction that is not zero");
    return unit(direction);
}

LightType read_light_type(const JsonPlace& place) {
    constexpr std::array<std::string_view, 3> kTypes = {"directional", "point", "spot"};
    const std::string name = place.text();
    const auto found = std::find(kTypes.begin(), kTypes.end(), name);
    if (found == kTypes.end()) refuse_name(place, kTypes, "a type of light");
    return static_cast<LightType>(found - kTypes.begin());
}

bool is_among(std::span<const std::string_view> names, std::string_view name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

// Throws Error for a name that is not in `known`; suggests the nearest one.
void refuse_name(const JsonPlace& place, std::span<const std::string_view> known,
                 const std::string& kind) {
    const std::string_view nearest = nearest_name(known, place.text());
    throw Error(
        place.file(), place.path(),
        fmt::format("{} ({})", kind,
                    known.empty() ? "there are none" : fmt::to_string(fmt::join(known, " "))),
        nearest.empty() ? shown(place.text())
                        : fmt::format("{}; did you mean '{}'?", shown(place.text()), nearest));
}

bool names_file(std::string_view key, std::string_view name) {
    if (key == "scratch") return !is_among(scratch_preset_names(), name);
    if (key == "weave") return !is_among(draft_names(), name);
    return key.ends_with("_map") || key == "maps" || key == "tabulated";
}

glm::vec3 unit(const glm::vec3& v) {
    // Three products and two sums of floats are exact to 4e-7.
    return std::abs(glm::dot(v, v) - 1.0f) < 1e-6f ? v : glm::normalize(v);
}

Light read_light(const JsonPlace& place) {
    using Keys = std::vector<std::string_view>;
    static const Keys directional_keys = {"type", "color", "intensity", "direction"};
    static const Keys point_keys = {"type", "color", "intensity", "position", "range"};
    static const Keys spot_keys = {"type",  "color",     "intensity",      "position",
                                   "range", "direction", "inner_cone_deg", "outer_cone_deg"};
    place.require_object();
    Light light;
    light.type = read_light_type(place.at("type"));
    const bool directional = light.type == LightType::directional;
    const bool spot = light.type == LightType::spot;
    place.require_object(directional ? directional_keys : spot ? spot_keys : point_keys);
    if (place.has("color")) light.color = read_color(place.at("color"));
    if (place.has("intensity"))
        light.intensity = static_cast<float>(place.at("intensity").number(0.0, 1e9));
    if (directional || spot) light.direction = read_direction(place.at("direction"));
    if (directional) return light;
    light.position = place.at("position").triple(-kFar, kFar);
    if (place.has("range")) light.range = static_cast<float>(place.at("range").number(0.0, kFar));
    if (!spot) return light;
    const double outer =
        place.has("outer_cone_deg") ? place.at("outer_cone_deg").number(0.0, 90.0) : 45.0;
    const double inner =
        place.has("inner_cone_deg") ? place.at("inner_cone_deg").number(0.0, outer) : 0.0;
    light.outer_cone = static_cast<float>(glm::radians(outer));
    light.inner_cone = static_cast<float>(glm::radians(inner));
    return light;
}

void read_placing(const JsonPlace& place, SceneFile::Object& object) {
    if (place.has("translate")) object.translate = place.at("translate").triple(-kFar, kFar);
    if (place.has("rotate_deg")) object.rotate_deg = place.at("rotate_deg").triple(-3600.0, 3600.0);
    if (!place.has("scale")) return;
    const JsonPlace scale = place.at("scale");
    object.scale = scale.value().is_array()
                       ? scale.triple(kSmallest, kLargest)
                       : glm::vec3(static_cast<float>(scale.number(kSmallest, kLargest)));
}

glm::mat4 placing_of(const SceneFile::Object& object) {
    const SceneFile::Object nowhere;
    glm::mat4 m(1.0f);
    if (object.translate != nowhere.translate) m = glm::translate(m, object.translate);
    if (object.rotate_deg != nowhere.rotate_deg) {
        const glm::vec3 turn = glm::radians(object.rotate_deg);
        m = glm::rotate(m, turn.z, glm::vec3(0, 0, 1));
        m = glm::rotate(m, turn.y, glm::vec3(0, 1, 0));
        m = glm::rotate(m, turn.x, glm::vec3(1, 0, 0));
    }
    if (object.scale != nowhere.scale) m = glm::scale(m, object.scale);
    return m;
}

}  // namespace burnish
