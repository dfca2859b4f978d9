#include "formats/scene_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "burnish/draft.hpp"
#include "burnish/error.hpp"
#include "burnish/image_io.hpp"
#include "burnish/parameters.hpp"
#include "burnish/scratch_settings.hpp"
#include "core/text.hpp"
#include "scene/light/area_lights.hpp"

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
    constexpr std::array<std::string_view, 6> kTypes = {"directional", "point", "spot",
                                                        "rectangle",   "disc",  "tube"};
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

namespace {

constexpr double kMostPower = 1e9;  // of intensity, radiance, lumens and watts

// The one key of the three that says how bright the light is.
void read_power(const JsonPlace& place, Light& light) {
    struct Key {
        const char* name;
        PowerUnit unit;
    };
    static constexpr std::array<Key, 3> kKeys = {{{"radiance", PowerUnit::radiance},
                                                  {"lumens", PowerUnit::lumens},
                                                  {"watts", PowerUnit::watts}}};
    const Key* found = nullptr;
    for (const Key& key : kKeys) {
        if (!place.has(key.name)) continue;
        if (found != nullptr)
            throw Error(place.file(), place.path(), "one of radiance, lumens and watts",
                        fmt::format("{} and {}", found->name, key.name));
        found = &key;
    }
    if (found == nullptr)
        throw Error(place.file(), place.path(), "radiance, lumens or watts", "none of them");
    const double power = place.at(found->name).number(0.0, kMostPower);
    const double radiance = radiance_of_power(light, found->unit, power);
    if (!(radiance <= kMostPower))
        place.at(found->name)
            .fail(fmt::format("at most {:g} cd/m2 from {:g} m2", kMostPower, emitting_area(light)));
    light.intensity = static_cast<float>(radiance);
}

double read_length(const JsonPlace& place) {
    return place.number(kSmallest, kLargest);
}

glm::vec2 read_size(const JsonPlace& place) {
    if (!place.value().is_array()) return glm::vec2(static_cast<float>(read_length(place)));
    if (place.value().size() != 2) place.fail("[width, height] in meters");
    return {static_cast<float>(read_length(place.at(0))),
            static_cast<float>(read_length(place.at(1)))};
}

bool read_bool(const JsonPlace& place) {
    if (!place.value().is_boolean()) place.fail("true or false");
    return place.value().get<bool>();
}

void read_light_texture(const JsonPlace& place, const std::filesystem::path& folder, Light& light) {
    const std::filesystem::path file = folder / place.text();
    try {
        Image image = read_image(file);
        light.texture.image = std::make_shared<const Image>(std::move(image));
    } catch (const Interrupted&) {
        throw;
    } catch (const Error& error) {
        throw Error(place.file() + ": " + place.path() + ": " + error.what());
    }
    light.texture.file = file.string();
}

Light read_area_light(const JsonPlace& place, LightType type, const std::filesystem::path& folder) {
    using Keys = std::vector<std::string_view>;
    static const Keys rectangle_keys = {"type",  "color",     "radiance", "lumens",
                                        "watts", "position",  "size",     "direction",
                                        "up",    "two_sided", "visible",  "texture"};
    static const Keys disc_keys(rectangle_keys.begin(), rectangle_keys.end() - 1);
    static const Keys tube_keys = {"type",     "color",  "radiance", "lumens",    "watts",
                                   "position", "length", "radius",   "direction", "visible"};
    const bool tube = type == LightType::tube;
    place.require_object(tube                           ? tube_keys
                         : type == LightType::rectangle ? rectangle_keys
                                                        : disc_keys);
    Light light;
    light.type = type;
    if (place.has("color")) light.color = read_color(place.at("color"));
    light.position = place.at("position").triple(-kFar, kFar);
    light.direction = read_direction(place.at("direction"));
    if (tube) {
        light.size = {static_cast<float>(read_length(place.at("length"))),
                      static_cast<float>(2.0 * read_length(place.at("radius")))};
    } else {
        light.size = read_size(place.at("size"));
        if (place.has("up")) {
            light.up = read_direction(place.at("up"));
            if (glm::length(glm::cross(light.up, light.direction)) < 1e-3f)
                place.at("up").fail("a direction that is not along `direction`");
        }
        if (place.has("two_sided")) light.two_sided = read_bool(place.at("two_sided"));
        if (place.has("texture")) read_light_texture(place.at("texture"), folder, light);
    }
    if (place.has("visible")) light.visible = read_bool(place.at("visible"));
    read_power(place, light);
    return light;
}

}  // namespace

Light read_light(const JsonPlace& place, const std::filesystem::path& folder) {
    using Keys = std::vector<std::string_view>;
    static const Keys directional_keys = {"type", "color", "intensity", "direction"};
    static const Keys point_keys = {"type", "color", "intensity", "position", "range"};
    static const Keys spot_keys = {"type",  "color",     "intensity",      "position",
                                   "range", "direction", "inner_cone_deg", "outer_cone_deg"};
    place.require_object();
    Light light;
    light.type = read_light_type(place.at("type"));
    if (has_area(light)) return read_area_light(place, light.type, folder);
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
