#include "formats/gltf/gltf_schema.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cfloat>
#include <climits>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "burnish/error.hpp"
#include "core/text.hpp"
#include "formats/gltf/gltf_rules.hpp"

namespace burnish {
namespace {

using nlohmann::json;
using Kind = GltfKind;
using Rule = GltfRule;

bool fits_float(const json& value) {
    return value.is_number() && std::abs(value.get<double>()) <= static_cast<double>(FLT_MAX);
}

bool fits_index(const json& value) {
    return value.is_number_unsigned() && value.get<std::uint64_t>() <= INT_MAX;
}

template <class Test>
bool all_items(const json& value, bool is_container, const Test& test) {
    if (!is_container) return false;
    for (const json& item : value)
        if (!test(item)) return false;
    return true;
}

bool matches(const json& value, const Rule& rule) {
    switch (rule.kind) {
        case Kind::any:
            return true;
        case Kind::object:
            return value.is_object();
        case Kind::objects:
            return all_items(value, value.is_array(), [](const json& v) { return v.is_object(); });
        case Kind::text:
            return value.is_string();
        case Kind::texts:
            return all_items(value, value.is_array(), [](const json& v) { return v.is_string(); });
        case Kind::boolean:
            return value.is_boolean();
        case Kind::number:
            return fits_float(value);
        case Kind::numbers:
            return all_items(value, value.is_array(), fits_float) &&
                   (rule.count == 0 || value.size() == rule.count);
        case Kind::index:
            return fits_index(value);
        case Kind::indices:
            return all_items(value, value.is_array(), fits_index);
        case Kind::index_map:
            return all_items(value, value.is_object(), fits_index);
        case Kind::size:
            return value.is_number_unsigned() && value.get<std::uint64_t>() <= LLONG_MAX;
        case Kind::list:
            return value.is_array();
    }
    return false;
}

std::string expectation(const Rule& rule) {
    switch (rule.kind) {
        case Kind::any:
            return "anything";
        case Kind::object:
            return "an object";
        case Kind::objects:
            return "an array of objects";
        case Kind::text:
            return "a text";
        case Kind::texts:
            return "an array of texts";
        case Kind::boolean:
            return "true or false";
        case Kind::number:
            return "a number that a float can hold";
        case Kind::numbers:
            return rule.count == 0 ? "an array of numbers"
                                   : fmt::format("{} numbers that a float can hold", rule.count);
        case Kind::index:
            return "a whole number from 0 to 2147483647";
        case Kind::indices:
            return "an array of whole numbers from 0 to 2147483647";
        case Kind::index_map:
            return "an object of whole numbers from 0 to 2147483647";
        case Kind::size:
            return "a whole number from 0 to 9223372036854775807";
        case Kind::list:
            return "an array";
    }
    return {};
}

// The value as text; containers, which may be huge, are summarized.
std::string found_in(const json& value) {
    if (value.is_array()) return fmt::format("an array of {} items", value.size());
    if (value.is_object()) return "an object";
    if (value.is_string()) return shown(value.get_ref<const std::string&>());
    return shown(value.dump(-1, ' ', false, json::error_handler_t::replace));
}

void check_object(const json& object, const Rule& rule, const std::string& path,
                  const GltfReport& report) {
    const auto key = [&] {
        return path.empty() ? std::string(rule.key) : fmt::format("{}.{}", path, rule.key);
    };
    const auto it = object.find(rule.key);
    if (it == object.end()) {
        if (rule.required) report.fail(key(), expectation(rule), "nothing");
    } else if (!matches(*it, rule)) {
        report.fail(key(), expectation(rule), found_in(*it));
    }
}

// Calls visit(object, path) for every object at the path `where`, relative to `node`.
template <class Visit>
void for_each_object(const json& node, std::string_view where, std::string& path,
                     const Visit& visit) {
    if (where.empty()) {
        visit(node, path);
        return;
    }
    const std::size_t dot = where.find('.');
    std::string_view name = where.substr(0, dot);
    const auto rest = dot == std::string_view::npos ? std::string_view() : where.substr(dot + 1);
    const bool each = name.ends_with("[]");
    if (each) name.remove_suffix(2);
    const auto child = node.find(name);
    if (child == node.end()) return;

    const std::size_t length = path.size();
    if (!path.empty()) path += '.';
    path += name;
    if (each) {
        const std::size_t stem = path.size();
        std::size_t index = 0;
        for (const json& item : *child) {
            path += fmt::format("[{}]", index++);
            for_each_object(item, rest, path, visit);
            path.resize(stem);
        }
    } else {
        for_each_object(*child, rest, path, visit);
    }
    path.resize(length);
}

// Materials and what is in them, and extensions everywhere: what says how a surface looks. Of
// "extensions" itself the keys are those of others.
bool is_held_to_its_keys(std::string_view where) {
    if (where.ends_with("extensions")) return false;
    return where.starts_with("materials[]") || where.find("extensions.") != where.npos;
}

// The keys of every object that is held to them, by the object's path.
std::map<std::string, std::vector<std::string_view>> known_keys() {
    std::map<std::string, std::vector<std::string_view>> keys;
    const auto add = [&](std::string where, const Rule& rule) {
        if (is_held_to_its_keys(where)) keys[where].push_back(rule.key);
        // An extension without keys of its own is listed, too.
        if (where.ends_with("extensions")) keys[fmt::format("{}.{}", where, rule.key)];
    };
    for (const Rule& rule : gltf_rules()) add(std::string(rule.where), rule);
    for (const std::string_view info : gltf_texture_infos())
        for (const Rule& rule : gltf_texture_info_rules())
            add(std::string(info) + std::string(rule.where), rule);
    return keys;
}

}  // namespace

void check_gltf_schema(const json& root, const GltfReport& report) {
    std::string path;
    const auto check = [&](std::string_view where, const Rule& rule) {
        for_each_object(root, where, path, [&](const json& object, const std::string& at) {
            check_object(object, rule, at, report);
        });
    };
    for (const Rule& rule : gltf_rules()) check(rule.where, rule);
    for (const std::string_view info : gltf_texture_infos())
        for (const Rule& rule : gltf_texture_info_rules())
            check(std::string(info) + std::string(rule.where), rule);
}

void warn_of_unknown_gltf_keys(const json& root, GltfReport& report) {
    std::string path;
    for (const auto& entry : known_keys()) {
        const std::vector<std::string_view>& keys = entry.second;
        for_each_object(root, entry.first, path, [&](const json& object, const std::string& at) {
            for (const auto& [key, value] : object.items()) {
                if (key == "extensions" || key == "extras" ||
                    std::find(keys.begin(), keys.end(), key) != keys.end())
                    continue;
                const std::string_view nearest = nearest_name(keys, key);
                report.warn(fmt::format("{}: the key {} is not read{}", at, shown(key),
                                        nearest.empty()
                                            ? std::string()
                                            : fmt::format(" (did you mean '{}'?)", nearest)));
            }
        });
    }
}

}  // namespace burnish
