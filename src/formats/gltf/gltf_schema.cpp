#include "formats/gltf/gltf_schema.hpp"

#include <fmt/format.h>

#include <cfloat>
#include <climits>
#include <cmath>
#include <nlohmann/json.hpp>

#include "burnish/error.hpp"

namespace burnish {
namespace {

using nlohmann::json;

enum class Kind {
    object,
    objects,  // an array of objects
    text,
    texts,
    boolean,
    number,   // a number within the range of float
    numbers,  // an array of `count` numbers, of any length when 0
    index,    // 0 .. 2^31-1: indices, enumerants, and other values that tinygltf stores in an int
    indices,
    index_map,
    size,  // 0 .. 2^63-1
    list,
};

struct Rule {
    std::string_view where;  // path of the object; "[]" after a name: every item of that array
    std::string_view key;
    Kind kind;
    bool required = false;
    std::size_t count = 0;
};

constexpr bool kRequired = true;

// Parents precede their children.
constexpr Rule kRules[] = {
    {"", "asset", Kind::object, kRequired},
    {"asset", "version", Kind::text, kRequired},
    {"asset", "minVersion", Kind::text},
    {"", "extensionsUsed", Kind::texts},
    {"", "extensionsRequired", Kind::texts},
    {"", "extensions", Kind::object},
    {"", "scene", Kind::index},
    {"", "scenes", Kind::objects},
    {"scenes[]", "nodes", Kind::indices},
    {"", "nodes", Kind::objects},
    {"nodes[]", "name", Kind::text},
    {"nodes[]", "children", Kind::indices},
    {"nodes[]", "mesh", Kind::index},
    {"nodes[]", "camera", Kind::index},
    {"nodes[]", "skin", Kind::index},
    {"nodes[]", "matrix", Kind::numbers, false, 16},
    {"nodes[]", "translation", Kind::numbers, false, 3},
    {"nodes[]", "rotation", Kind::numbers, false, 4},
    {"nodes[]", "scale", Kind::numbers, false, 3},
    {"nodes[]", "extensions", Kind::object},
    {"nodes[].extensions", "KHR_lights_punctual", Kind::object},
    {"nodes[].extensions.KHR_lights_punctual", "light", Kind::index, kRequired},
    {"", "meshes", Kind::objects},
    {"meshes[]", "name", Kind::text},
    {"meshes[]", "primitives", Kind::objects, kRequired},
    {"meshes[].primitives[]", "attributes", Kind::index_map, kRequired},
    {"meshes[].primitives[]", "indices", Kind::index},
    {"meshes[].primitives[]", "material", Kind::index},
    {"meshes[].primitives[]", "mode", Kind::index},
    {"meshes[].primitives[]", "targets", Kind::list},
    {"meshes[].primitives[]", "extensions", Kind::object},
    {"", "accessors", Kind::objects},
    {"accessors[]", "bufferView", Kind::index},
    {"accessors[]", "byteOffset", Kind::size},
    {"accessors[]", "componentType", Kind::index, kRequired},
    {"accessors[]", "count", Kind::size, kRequired},
    {"accessors[]", "type", Kind::text, kRequired},
    {"accessors[]", "normalized", Kind::boolean},
    {"accessors[]", "sparse", Kind::object},
    {"accessors[].sparse", "count", Kind::index, kRequired},
    {"accessors[].sparse", "indices", Kind::object, kRequired},
    {"accessors[].sparse.indices", "bufferView", Kind::index, kRequired},
    {"accessors[].sparse.indices", "byteOffset", Kind::index},
    {"accessors[].sparse.indices", "componentType", Kind::index, kRequired},
    {"accessors[].sparse", "values", Kind::object, kRequired},
    {"accessors[].sparse.values", "bufferView", Kind::index, kRequired},
    {"accessors[].sparse.values", "byteOffset", Kind::index},
    {"", "bufferViews", Kind::objects},
    {"bufferViews[]", "buffer", Kind::index, kRequired},
    {"bufferViews[]", "byteOffset", Kind::size},
    {"bufferViews[]", "byteLength", Kind::size, kRequired},
    {"bufferViews[]", "byteStride", Kind::size},
    {"bufferViews[]", "extensions", Kind::object},
    {"bufferViews[].extensions", "EXT_meshopt_compression", Kind::object},
    {"bufferViews[].extensions.EXT_meshopt_compression", "buffer", Kind::index, kRequired},
    {"bufferViews[].extensions.EXT_meshopt_compression", "byteOffset", Kind::index},
    {"bufferViews[].extensions.EXT_meshopt_compression", "byteLength", Kind::index, kRequired},
    {"bufferViews[].extensions.EXT_meshopt_compression", "byteStride", Kind::index, kRequired},
    {"bufferViews[].extensions.EXT_meshopt_compression", "count", Kind::index, kRequired},
    {"bufferViews[].extensions.EXT_meshopt_compression", "mode", Kind::text, kRequired},
    {"bufferViews[].extensions.EXT_meshopt_compression", "filter", Kind::text},
    {"", "buffers", Kind::objects},
    {"buffers[]", "byteLength", Kind::size, kRequired},
    {"buffers[]", "uri", Kind::text},
    {"buffers[]", "extensions", Kind::object},
    {"buffers[].extensions", "EXT_meshopt_compression", Kind::object},
    {"buffers[].extensions.EXT_meshopt_compression", "fallback", Kind::boolean},
    {"", "images", Kind::objects},
    {"images[]", "uri", Kind::text},
    {"images[]", "bufferView", Kind::index},
    {"", "samplers", Kind::objects},
    {"samplers[]", "magFilter", Kind::index},
    {"samplers[]", "minFilter", Kind::index},
    {"samplers[]", "wrapS", Kind::index},
    {"samplers[]", "wrapT", Kind::index},
    {"", "textures", Kind::objects},
    {"textures[]", "sampler", Kind::index},
    {"textures[]", "source", Kind::index},
    {"textures[]", "extensions", Kind::object},
    {"", "materials", Kind::objects},
    {"materials[]", "name", Kind::text},
    {"materials[]", "emissiveFactor", Kind::numbers, false, 3},
    {"materials[]", "alphaMode", Kind::text},
    {"materials[]", "alphaCutoff", Kind::number},
    {"materials[]", "doubleSided", Kind::boolean},
    {"materials[]", "normalTexture", Kind::object},
    {"materials[].normalTexture", "scale", Kind::number},
    {"materials[]", "occlusionTexture", Kind::object},
    {"materials[].occlusionTexture", "strength", Kind::number},
    {"materials[]", "emissiveTexture", Kind::object},
    {"materials[]", "pbrMetallicRoughness", Kind::object},
    {"materials[].pbrMetallicRoughness", "baseColorFactor", Kind::numbers, false, 4},
    {"materials[].pbrMetallicRoughness", "metallicFactor", Kind::number},
    {"materials[].pbrMetallicRoughness", "roughnessFactor", Kind::number},
    {"materials[].pbrMetallicRoughness", "baseColorTexture", Kind::object},
    {"materials[].pbrMetallicRoughness", "metallicRoughnessTexture", Kind::object},
    {"materials[]", "extensions", Kind::object},
    {"materials[].extensions", "KHR_materials_anisotropy", Kind::object},
    {"materials[].extensions.KHR_materials_anisotropy", "anisotropyStrength", Kind::number},
    {"materials[].extensions.KHR_materials_anisotropy", "anisotropyRotation", Kind::number},
    {"materials[].extensions.KHR_materials_anisotropy", "anisotropyTexture", Kind::object},
    {"materials[].extensions", "KHR_materials_ior", Kind::object},
    {"materials[].extensions.KHR_materials_ior", "ior", Kind::number},
    {"materials[].extensions", "KHR_materials_emissive_strength", Kind::object},
    {"materials[].extensions.KHR_materials_emissive_strength", "emissiveStrength", Kind::number},
    {"", "cameras", Kind::objects},
    {"cameras[]", "type", Kind::text, kRequired},
    {"cameras[]", "perspective", Kind::object},
    {"cameras[].perspective", "yfov", Kind::number, kRequired},
    {"cameras[].perspective", "znear", Kind::number, kRequired},
    {"cameras[].perspective", "zfar", Kind::number},
    {"cameras[].perspective", "aspectRatio", Kind::number},
    {"cameras[]", "orthographic", Kind::object},
    {"cameras[].orthographic", "xmag", Kind::number, kRequired},
    {"cameras[].orthographic", "ymag", Kind::number, kRequired},
    {"cameras[].orthographic", "znear", Kind::number, kRequired},
    {"cameras[].orthographic", "zfar", Kind::number, kRequired},
    {"extensions", "KHR_lights_punctual", Kind::object},
    {"extensions.KHR_lights_punctual", "lights", Kind::objects, kRequired},
    {"extensions.KHR_lights_punctual.lights[]", "type", Kind::text, kRequired},
    {"extensions.KHR_lights_punctual.lights[]", "color", Kind::numbers, false, 3},
    {"extensions.KHR_lights_punctual.lights[]", "intensity", Kind::number},
    {"extensions.KHR_lights_punctual.lights[]", "range", Kind::number},
    {"extensions.KHR_lights_punctual.lights[]", "spot", Kind::object},
    {"extensions.KHR_lights_punctual.lights[].spot", "innerConeAngle", Kind::number},
    {"extensions.KHR_lights_punctual.lights[].spot", "outerConeAngle", Kind::number},
};

// The paths of all textureInfo objects; rules for their keys follow.
constexpr std::string_view kTextureInfos[] = {
    "materials[].pbrMetallicRoughness.baseColorTexture",
    "materials[].pbrMetallicRoughness.metallicRoughnessTexture",
    "materials[].normalTexture",
    "materials[].occlusionTexture",
    "materials[].emissiveTexture",
    "materials[].extensions.KHR_materials_anisotropy.anisotropyTexture",
};
constexpr Rule kTextureInfoRules[] = {
    {"", "index", Kind::index, kRequired},
    {"", "texCoord", Kind::index},
    {"", "extensions", Kind::object},
    {".extensions", "KHR_texture_transform", Kind::object},
    {".extensions.KHR_texture_transform", "offset", Kind::numbers, false, 2},
    {".extensions.KHR_texture_transform", "scale", Kind::numbers, false, 2},
    {".extensions.KHR_texture_transform", "rotation", Kind::number},
    {".extensions.KHR_texture_transform", "texCoord", Kind::index},
};

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

// Checks `rule` in every object at the path `where`, relative to `node`.
void check_rule(const json& node, std::string_view where, const Rule& rule, std::string& path,
                const GltfReport& report) {
    if (where.empty()) {
        check_object(node, rule, path, report);
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
            check_rule(item, rest, rule, path, report);
            path.resize(stem);
        }
    } else {
        check_rule(*child, rest, rule, path, report);
    }
    path.resize(length);
}

}  // namespace

void check_gltf_schema(const json& root, const GltfReport& report) {
    std::string path;
    for (const Rule& rule : kRules) check_rule(root, rule.where, rule, path, report);
    for (const std::string_view info : kTextureInfos) {
        for (const Rule& rule : kTextureInfoRules)
            check_rule(root, std::string(info) + std::string(rule.where), rule, path, report);
    }
}

}  // namespace burnish
