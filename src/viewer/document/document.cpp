#include "viewer/document/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "burnish/conductors.hpp"
#include "burnish/error.hpp"
#include "burnish/material_assets.hpp"

namespace burnish::viewer {
namespace {

constexpr double kFar = 1e6;            // meters, as in the parameter table
constexpr double kMostIntensity = 1e9;  // as in scene files

constexpr std::string_view kCameraNames[] = {
    "camera_azimuth", "camera_elevation", "camera_distance", "camera_zoom",
    "camera_fov",     "camera_position",  "camera_target",   "camera_index"};

void erase_belonging(ParameterValues& values, std::string_view name) {
    for (const Parameter& parameter : parameter_table())
        if (parameter.belongs_to == name) values.erase(parameter.name);
}

// Sets one value in a layer, where it takes the place of other ways of saying the same thing.
void put(ParameterValues& values, std::string_view name, const ParameterValue& value) {
    const auto* text = std::get_if<std::string>(&value);
    if (text != nullptr && *text == "none") {
        // There is nothing whose place it could take.
        erase_belonging(values, name);
        return values.set_value(name, value);
    }
    ParameterValues one;
    one.set_value(name, value);
    values.merge(one);
    // A metal without a known oxide refuses the film of the metal before.
    if (name == "metal" && (!names_one(one, name) || oxide_of(one.text(name)).empty()))
        erase_belonging(values, name);
}

const Parameter& parameter_named(std::string_view name, std::string_view where) {
    if (const Parameter* parameter = find_parameter(name)) return *parameter;
    ParameterValues().set(name, "", where);  // throws, and suggests the nearest name
    throw UsageError(std::string(name));     // not reached
}

void require_of_material(std::string_view name) {
    if (parameter_named(name, "").group != ParameterGroup::material)
        throw UsageError(name, "", "a parameter of materials", "one of the whole picture");
}

[[noreturn]] void refuse(std::string_view what, std::string_view expected, double found) {
    throw UsageError(what, "", expected, fmt::format("{:g}", found));
}

void require_in(std::string_view what, double value, double low, double high) {
    if (!(value >= low && value <= high))
        refuse(what, fmt::format("a number from {:g} to {:g}", low, high), value);
}

void require_in(std::string_view what, const glm::vec3& v, double low, double high) {
    for (int i = 0; i < 3; ++i) require_in(what, static_cast<double>(v[i]), low, high);
}

void require_unit(const glm::vec3& direction) {
    const double squared = static_cast<double>(glm::dot(direction, direction));
    // A vector that was normalized in floats is unit to 4e-7.
    if (!(std::abs(squared - 1.0) < 1e-6))
        refuse("light: direction", "a vector of length 1", std::sqrt(squared));
}

void require_valid_area(const Light& light) {
    // As scene files have it; a float is as near to the ends as it can be.
    require_in("light: width", static_cast<double>(light.size.x), 0.999e-6, 2.001e6);
    require_in("light: height", static_cast<double>(light.size.y), 0.999e-6, 2.001e6);
    if (light.type == LightType::tube) return;
    if (!(glm::length(glm::cross(glm::normalize(light.up), light.direction)) >= 1e-3f))
        throw UsageError("light: up", "", "a direction that is not along `direction`",
                         "one that is");
}

}  // namespace

std::span<const std::string_view> compare_mode_names() {
    static constexpr std::array<std::string_view, 5> kNames = {"off", "split", "blink",
                                                               "difference", "flip"};
    return kNames;
}

std::optional<int> scene_material_of(std::string_view other) {
    int index = 0;
    if (!other.starts_with('#')) return std::nullopt;
    const auto [stop, error] =
        std::from_chars(other.data() + 1, other.data() + other.size(), index);
    if (error != std::errc() || stop != other.data() + other.size() || index < 0)
        return std::nullopt;
    return index;
}

void set_parameter(Document& document, std::string_view name, const ParameterValue& value,
                   std::optional<int> material) {
    if (material) {
        require_of_material(name);
        ParameterValues own = document.material_values[*material];
        put(own, name, value);
        document.material_values[*material] = std::move(own);
        return;
    }
    ParameterValues all = document.values;
    put(all, name, value);
    document.values = std::move(all);
    for (auto& [index, own] : document.material_values) own.erase(name);
    std::erase_if(document.material_values,
                  [](const auto& entry) { return entry.second.set_values().empty(); });
}

void set_parameter_text(Document& document, std::string_view name, std::string_view text,
                        std::optional<int> material, std::string_view where) {
    ParameterValues one;
    one.set(name, text, where);
    set_parameter(document, name, one.set_values().begin()->second, material);
}

void unset_parameter(Document& document, std::string_view name, std::optional<int> material) {
    parameter_named(name, "");
    const auto unset = [&](ParameterValues& values) {
        values.erase(name);
        erase_belonging(values, name);
    };
    if (!material) return unset(document.values);
    const auto own = document.material_values.find(*material);
    if (own == document.material_values.end()) return;
    unset(own->second);
    if (own->second.set_values().empty()) document.material_values.erase(own);
}

void set_camera(Document& document, const glm::vec3& position, const glm::vec3& target,
                double fov_deg) {
    if (position == target)
        throw UsageError("camera_position", "", "a place other than the target", "the target");
    ParameterValues values = document.values;
    for (const std::string_view name : kCameraNames) values.erase(name);
    values.set_value("camera_position", position);
    values.set_value("camera_target", target);
    values.set_value("camera_fov", fov_deg);
    document.values = std::move(values);
}

void unset_camera(Document& document) {
    for (const std::string_view name : kCameraNames) document.values.erase(name);
}

void require_valid(const Light& light) {
    require_in("light: color", light.color, 0.0, 1.0);
    require_in("light: intensity", static_cast<double>(light.intensity), 0.0, kMostIntensity);
    if (light.type != LightType::point) require_unit(light.direction);
    if (light.type == LightType::directional) return;
    require_in("light: position", light.position, -kFar, kFar);
    if (has_area(light)) return require_valid_area(light);
    require_in("light: range", static_cast<double>(light.range), 0.0, kFar);
    if (light.type != LightType::spot) return;
    // The float that is nearest to a right angle is larger than it.
    const double right = static_cast<double>(std::numbers::pi_v<float> / 2);
    require_in("light: outer cone", static_cast<double>(light.outer_cone), 0.0, right);
    require_in("light: inner cone", static_cast<double>(light.inner_cone), 0.0,
               static_cast<double>(light.outer_cone));
}

void require_valid(const Compare& compare) {
    const std::size_t count = compare.methods.size();
    if (count < kLeastCompared || count > kMostCompared)
        refuse("compare: methods", fmt::format("{} to {} methods", kLeastCompared, kMostCompared),
               static_cast<double>(count));
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (compare.methods[i] == compare.methods[j])
                throw UsageError("compare: methods", "", "each method once",
                                 fmt::format("{} again", name_of(compare.methods[i])));
    if (!compare.dividers.empty() && compare.dividers.size() != count - 1)
        refuse("compare: dividers", "one fewer than methods",
               static_cast<double>(compare.dividers.size()));
    for (const double place : compare.dividers) require_in("compare: dividers", place, 0.0, 1.0);
    if (!std::is_sorted(compare.dividers.begin(), compare.dividers.end()))
        throw UsageError("compare: dividers", "", "ascending places", "others");
    require_in("compare: gain", compare.gain, 0.01, 1000.0);
    require_in("compare: middle", compare.middle, 0.0, 1.0);
    if (!compare.materials) return;
    const MaterialPair& pair = *compare.materials;
    // More than any scene has.
    require_in("compare: materials", pair.material, 0.0, 1e6);
    if (pair.other.empty())
        throw UsageError("compare: materials", "", "another material of the scene, or a file",
                         "none");
    if (scene_material_of(pair.other) == pair.material)
        throw UsageError("compare: materials", "", "two materials", pair.other + " twice");
}

void require_valid(const Bookmark& bookmark) {
    if (bookmark.name.empty()) throw UsageError("bookmark", "", "a name", "none");
    require_in("bookmark: position", bookmark.position, -kFar, kFar);
    require_in("bookmark: target", bookmark.target, -kFar, kFar);
    require_in("bookmark: field of view", bookmark.fov_deg, 1.0, 170.0);
    if (bookmark.position == bookmark.target)
        throw UsageError("bookmark: position", "", "a place other than the target", "the target");
}

void require_valid(const Document& document) {
    if (document.lights)
        for (const Light& light : *document.lights) require_valid(light);
    for (const Bookmark& bookmark : document.bookmarks) require_valid(bookmark);
    require_valid(document.compare);
}

}  // namespace burnish::viewer
